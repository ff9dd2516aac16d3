// The 2D viewer with one method more.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "examples/added_heuristic/least_crowd.h"
#include "viewer2d/viewer2d.h"

using namespace sightline;

int main(int argc, char** argv) {
    const auto known = method_table<2>();
    std::vector<Method<2>> methods(known.begin(), known.end());
    methods.push_back(cell_method<2, LeastCrowd>("crowd", "least crowd", "cells by the crowd met on the way to them"));
    return viewer2d(argc, argv, methods);
}
