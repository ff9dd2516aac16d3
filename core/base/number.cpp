// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number.h"

#include <charconv>
#include <cmath>

namespace sightline {

std::optional<double> parse_number(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<std::uint32_t> parse_whole(std::string_view text) {
    const auto number = parse_number(text);
    if (!number || *number < 0 || *number > 4e9 || *number != std::floor(*number)) return std::nullopt;
    return static_cast<std::uint32_t>(*number);
}

std::string number_text(double value) {
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string duration_text(double seconds) {
    const auto whole = static_cast<long>(std::lround(seconds));
    if (whole < 60) return std::to_string(whole) + " s";
    return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

std::string short_number(double value, int digits) {
    if (value == 0) return "0";
    char text[40];
    const double size = std::abs(value);
    // Scientific notation only where plain digits would be long.
    if (size >= 1e7 || size < 1e-4)
        return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits - 1).ptr};
    int decimals = digits - 1;
    for (double limit = 10; limit <= size; limit *= 10) --decimals;
    for (double limit = 1; limit > size; limit /= 10) ++decimals;
    std::string plain(
        text,
        std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals > 0 ? decimals : 0).ptr);
    if (plain.find('.') != std::string::npos) {
        while (plain.ends_with('0')) plain.pop_back();
        if (plain.ends_with('.')) plain.pop_back();
    }
    return plain;
}

std::string milliseconds_text(double ms) {
    const bool tiny = ms > 0 && ms < 0.001;
    return tiny ? short_number(ms * 1000) + " µs" : short_number(ms) + " ms";
}

std::string percent_text(double share) { return short_number(share * 100) + " %"; }

int separating_digits(double a, double b) {
    if (a == b) return 3;
    for (int digits = 3; digits < 17; ++digits)
        if (short_number(a, digits) != short_number(b, digits)) return digits;
    return 17;
}

}  // namespace sightline
