// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/budget.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/number.h"
#include "core/base/text.h"

namespace sightline {

std::uint32_t Budget::primitives(std::size_t total) const {
    constexpr std::uint32_t no_limit = std::numeric_limits<std::uint32_t>::max();
    if (kind == Kind::primitives) return value >= no_limit ? no_limit : static_cast<std::uint32_t>(value);
    if (kind != Kind::share) return no_limit;
    const double wanted = std::nearbyint(value * static_cast<double>(total));
    return static_cast<std::uint32_t>(value > 0 ? std::max(wanted, 1.0) : 0);
}

Budget parse_budget(std::string_view text) {
    if (text == "unlimited") return {};
    const auto fail = [&](const char* why) {
        return InputError(
            "budget '" + excerpt(text) + "': " + why +
            " (write a whole number of primitives, a share such as 5%, a time such as 16ms, or unlimited)");
    };
    if (text.starts_with("wrong:"))
        throw InputError("budget '" + excerpt(text) + "': only lab measure follows wrong pixels");
    Budget::Kind kind = Budget::Kind::primitives;
    std::string_view digits = text;
    if (digits.ends_with('%')) {
        kind = Budget::Kind::share;
        digits.remove_suffix(1);
    } else if (digits.ends_with("ms")) {
        kind = Budget::Kind::milliseconds;
        digits.remove_suffix(2);
    }
    const auto value = parse_number(digits);
    if (!value) throw fail("not a number");
    if (*value < 0) throw fail("negative");
    if (kind == Budget::Kind::share && *value > 100) throw fail("more than the whole scene");
    if (kind == Budget::Kind::primitives && *value != std::floor(*value)) throw fail("not a whole number");
    return {kind, kind == Budget::Kind::share ? *value / 100 : *value};
}

std::string budget_text(const Budget& budget) {
    switch (budget.kind) {
        case Budget::Kind::primitives:
            return number_text(budget.value);
        case Budget::Kind::share: {
            // value was percent / 100; find the short percentage that reads back to the same share.
            const double percent = budget.value * 100;
            for (int decimals = 0; decimals < 17; ++decimals) {
                char text[64];
                const auto end = std::to_chars(text, text + sizeof text, percent, std::chars_format::fixed, decimals);
                const std::string_view candidate(text, static_cast<std::size_t>(end.ptr - text));
                if (parse_number(candidate).value_or(-1) / 100 == budget.value) return std::string(candidate) + "%";
            }
            return number_text(percent) + "%";
        }
        case Budget::Kind::milliseconds:
            return number_text(budget.value) + "ms";
        case Budget::Kind::unlimited:
            break;
    }
    return "unlimited";
}

}  // namespace sightline
