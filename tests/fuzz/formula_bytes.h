// Any bytes as the text of a formula: it compiles and evaluates, or throws InputError with one line.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "core/base/error.h"
#include "core/base/formula.h"

namespace sightline::fuzz {

/// 1: compiled, 0: refused properly. Ends the program when a promise is broken; lets other exceptions escape.
inline int fuzz_formula(const std::uint8_t* data, std::size_t size) {
    constexpr std::string_view names[] = {"content", "angle", "handed_on", "star"};
    constexpr double inf = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double samples[][4] = {{0, -0.0, 1, -1}, {0.5, 2, 1e300, -3}, {inf, -inf, nan, 0}};
    try {
        const Formula formula({reinterpret_cast<const char*>(data), size}, names);
        for (const std::size_t used : formula.used())
            if (used >= std::size(names)) std::abort();
        for (const auto& values : samples) {
            const double value = formula.value(values);
            if (formula.holds(values) != (value < 0 || value > 0)) std::abort();
        }
        return 1;
    } catch (const InputError& error) {
        const std::string_view what = error.what();
        for (const char c : what)
            if (static_cast<unsigned char>(c) < 0x20) std::abort();
        if (!what.starts_with("formula '") || what.size() > 6000) std::abort();
        return 0;
    }
}

}  // namespace sightline::fuzz
