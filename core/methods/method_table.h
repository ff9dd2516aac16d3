// Every method that the programs know: a row each.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/method.h"

namespace sightline {

/// In the order in which help shows them.
template <int D>
std::span<const Method<D>> method_table();
template <>
std::span<const Method<2>> method_table<2>();
template <>
std::span<const Method<3>> method_table<3>();

/// The methods of both dimensions that a program knows.
struct MethodTables {
    std::span<const Method<2>> in_2d = method_table<2>();
    std::span<const Method<3>> in_3d = method_table<3>();

    template <int D>
    std::span<const Method<D>> of() const {
        if constexpr (D == 2)
            return in_2d;
        else
            return in_3d;
    }
};

/// The parameters of all methods of both tables, each once.
std::span<const ParameterRow* const> all_parameters();

}  // namespace sightline
