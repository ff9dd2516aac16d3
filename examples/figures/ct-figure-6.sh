#!/bin/sh
# CT figure 6: the boxes that Visible comes to.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" --headless --state examples/states/coorg-teller/figure-6.json --columns 3 \
    --panels "step 12; step 30; end" --set show_planes=off --size 174mm \
    --shot "$out/ct-figure-6.svg" --shot "$out/ct-figure-6.png"
