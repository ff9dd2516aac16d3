// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/command.h"

int main(int argc, char** argv) { return sightline::lab::lab_program(argc, argv); }
