// How much a frame may spend: primitives, a share of the scene, or time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sightline {

struct Budget {
    enum class Kind : std::uint8_t { unlimited, primitives, share, milliseconds };
    Kind kind = Kind::unlimited;
    double value = 0;  ///< primitives: a whole number; share: a fraction of 1; milliseconds of a whole frame

    bool operator==(const Budget&) const = default;

    /// Number of primitives the budget allows in a scene of `total`; 2^32 - 1 when it does not limit them. A share is
    /// rounded to the nearest whole number, but to no less than 1.
    std::uint32_t primitives(std::size_t total) const;
};

/// "500", "5%", "16ms" or "unlimited". Throws InputError for anything else, negative numbers and shares above 100 %.
Budget parse_budget(std::string_view text);
std::string budget_text(const Budget& budget);

}  // namespace sightline
