#!/bin/sh
# TR figure 3 (TVCG figure 3) in shape: the input, the quadtree over its vertices, the triangulation of its leaf centres.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" cars --headless --steps 0 --set palette=paper --set show_view=off --set show_states=off --set show_visibility=off \
    --set show_tessellation=off --set legend=off --set caption=off --size 84mm --shot "$out/tr-figure-3a.svg"
"$viewer" cars --headless --steps 0 --set palette=paper --set show_view=off --set show_states=off --set show_visibility=off \
    --set tessellation=tree --set legend=off --set caption=off --size 84mm --shot "$out/tr-figure-3b.svg"
"$viewer" cars --headless --steps 0 --set palette=paper --set show_view=off --set show_states=off --set show_visibility=off \
    --set border=none --set legend=off --set caption=off --size 84mm --shot "$out/tr-figure-3c.svg"
