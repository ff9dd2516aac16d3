#!/bin/sh
# TVCG figure 14 in shape: what each method misses of one frame.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" rooms --headless --budget 5% --method centroid --set show_states=off --set show_tessellation=off \
    --set zoom=2 --size 84mm --shot "$out/tvcg-figure-14-centroid.svg" --shot "$out/tvcg-figure-14-centroid.png"
"$viewer" rooms --headless --budget 5% --set tessellation=tree --set show_states=off --set show_tessellation=off \
    --set zoom=2 --size 84mm --shot "$out/tvcg-figure-14-tree.svg" --shot "$out/tvcg-figure-14-tree.png"
"$viewer" rooms --headless --budget 5% --set show_states=off --set show_tessellation=off \
    --set zoom=2 --size 84mm --shot "$out/tvcg-figure-14-delaunay.svg" --shot "$out/tvcg-figure-14-delaunay.png"
