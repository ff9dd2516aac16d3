// The 3D viewer with two methods more.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/viewer3d.h"

#include "examples/added_heuristic/methods.h"

int main(int argc, char** argv) { return sightline::viewer3d(argc, argv, methods_of_ones_own<3>()); }
