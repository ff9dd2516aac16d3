#!/bin/sh
# TR figure 4 (TVCG figure 7): four moments of one traversal.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" streets --headless --preset prototype-2d --set outside_view=unseen --budget 500 \
    --panels "step 1; step 40; step 90; end" \
    --set palette=paper --set show_visibility=off --set zoom=1.3 --size 174mm \
    --shot "$out/tr-figure-4.svg" --shot "$out/tr-figure-4.png"
