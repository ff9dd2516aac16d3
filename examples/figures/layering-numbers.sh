#!/bin/sh
# The layering number of TVCG section 3 as a heat map.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" wallholes --headless --steps 0 --set heat=zeta --set label=zeta --set label_where=all \
    --set show_tessellation=off --size 150mm --font 7pt \
    --shot "$out/layering-numbers.svg" --shot "$out/layering-numbers.png"
