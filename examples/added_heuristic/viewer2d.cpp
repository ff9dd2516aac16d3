// The 2D viewer with two methods more.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/viewer2d.h"

#include "examples/added_heuristic/methods.h"

int main(int argc, char** argv) { return sightline::viewer2d(argc, argv, methods_of_ones_own<2>()); }
