// The method table with two rows more.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method_table.h"
#include "examples/added_heuristic/least_crowd.h"
#include "examples/added_method/rings.h"

template <int D>
std::vector<sightline::Method<D>> methods_of_ones_own() {
    const auto known = sightline::method_table<D>();
    std::vector<sightline::Method<D>> methods(known.begin(), known.end());
    methods.push_back(
        sightline::cell_method<D, LeastCrowd>("crowd", "least crowd", "cells by the crowd met on the way to them"));
    methods.push_back(rings_method<D>());
    return methods;
}
