#!/bin/sh
# CT figures 10 and 11 in shape: boxes that the method drops and keeps, all round and in a view.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" soda --headless --method "coorg-teller connected=on threshold=0.2" --budget unlimited --fov 360 \
    --set show_planes=off --set show_visibility=off --set legend=short --size 84mm --shot "$out/ct-figure-10-soda.png"
"$viewer" soda --headless --method "coorg-teller connected=on threshold=0.2" --budget unlimited --fov 60 \
    --set show_planes=off --set show_visibility=off --set legend=short --size 84mm --shot "$out/ct-figure-11-soda.png"
"$viewer" blocks --headless --method "coorg-teller connected=on threshold=0.2" --budget unlimited --fov 360 \
    --set show_planes=off --set show_visibility=off --set legend=short --size 84mm --shot "$out/ct-figure-10-blocks.png"
"$viewer" blocks --headless --method "coorg-teller connected=on threshold=0.2" --budget unlimited --fov 60 \
    --set show_planes=off --set show_visibility=off --set legend=short --size 84mm --shot "$out/ct-figure-11-blocks.png"
"$viewer" tetra --headless --method "coorg-teller connected=on threshold=0.2" --budget unlimited --fov 360 \
    --set show_planes=off --set show_visibility=off --set legend=short --size 84mm --shot "$out/ct-figure-10-tetra.png"
"$viewer" tetra --headless --method "coorg-teller connected=on threshold=0.2" --budget unlimited --fov 60 \
    --set show_planes=off --set show_visibility=off --set legend=short --size 84mm --shot "$out/ct-figure-11-tetra.png"
