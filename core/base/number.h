// Numbers as text, independent of the locale.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sightline {

/// The whole text as one finite number, or nothing.
std::optional<double> parse_number(std::string_view text);

/// The whole text as one whole number of at most 4e9, or nothing.
std::optional<std::uint32_t> parse_whole(std::string_view text);

/// The shortest text that reads back to the same double.
std::string number_text(double value);

/// "42 s" or "3 min 5 s", for people.
std::string duration_text(double seconds);

/// At most `digits` significant digits, for people.
std::string short_number(double value, int digits = 3);

/// "12.3 ms"; below a thousandth "0.05 µs".
std::string milliseconds_text(double ms);

/// A fraction of 1 for people: "12.3 %".
std::string percent_text(double share);

/// As few significant digits, but no fewer than 3, as tell two different numbers apart.
int separating_digits(double a, double b);

}  // namespace sightline
