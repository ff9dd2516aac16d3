// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/viewer2d.h"

int main(int argc, char** argv) { return sightline::viewer2d(argc, argv); }
