#!/bin/sh
# TR figure 2 in shape: the front carves its way round a car.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" cars --headless --preset prototype-2d --set outside_view=unseen --budget unlimited \
    --eye 20,9 --look-at 24,-2 --fov 120 --steps 70 \
    --set palette=paper --set show_visibility=off --set show_tessellation=off --set zoom=1.6 --size 120mm \
    --shot "$out/tr-figure-2.svg" --shot "$out/tr-figure-2.png"
