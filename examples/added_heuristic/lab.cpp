// The lab with two methods more.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "examples/added_heuristic/methods.h"
#include "lab/command.h"

int main(int argc, char** argv) {
    const auto in_2d = methods_of_ones_own<2>();
    const auto in_3d = methods_of_ones_own<3>();
    return sightline::lab::lab_program(argc, argv, {in_2d, in_3d});
}
