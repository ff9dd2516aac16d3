#!/bin/sh
# CT figure 8: the area-angle of a wall, and from where it is large enough.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" --headless --state examples/states/coorg-teller/figure-8.json --shot "$out/ct-figure-8.svg"
