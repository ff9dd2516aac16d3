#!/bin/sh
# TVCG figure 2 in shape: one frame on both tessellations.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" rooms --headless --budget 5% --set palette=paper --set show_visibility=off --set zoom=2 \
    --size 120mm --shot "$out/tvcg-figure-2a.svg" --shot "$out/tvcg-figure-2a.png"
"$viewer" rooms --headless --budget 5% --set palette=paper --set show_visibility=off --set zoom=2 \
    --set tessellation=tree --size 120mm --shot "$out/tvcg-figure-2b.svg" --shot "$out/tvcg-figure-2b.png"
