#!/bin/sh
# TR figure 1: a traversal that spent a budget of 500 segments.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" streets --headless --preset prototype-2d --set outside_view=unseen --budget 500 \
    --set palette=paper --set show_visibility=off --size 174mm \
    --shot "$out/tr-figure-1.svg" --shot "$out/tr-figure-1.png"
