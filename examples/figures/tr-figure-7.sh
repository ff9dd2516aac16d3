#!/bin/sh
# TR figure 7 (TVCG figure 6): what cell A hands on to B and to C.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" examples/scenes/gallery.json --headless \
    --do "step 9; note text cell:25 [0,0] A; note text cell:27 [0,0] B; note text cell:28 [0,0] C; explain" \
    --set show_normals=on --set show_penalties=on --set zoom=7 --set zoom_at=last --size 120mm \
    --shot "$out/tr-figure-7.svg" --shot "$out/tr-figure-7.png"
