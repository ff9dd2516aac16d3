// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/viewer3d.h"

int main(int argc, char** argv) { return sightline::viewer3d(argc, argv); }
