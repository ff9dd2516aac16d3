#!/bin/sh
# The bottleneck of TR section 3.2, with and without the star-shape test.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" bottleneck --headless --set star_shaped=off --panels "step 7; step 14; end" \
    --set label=none --set palette=print --size 174mm --shot "$out/bottleneck-off.pdf" --shot "$out/bottleneck-off.png"
"$viewer" bottleneck --headless --set penalty=multiply --set show_penalties=on --panels "step 7; step 14; end" \
    --set label=none --set palette=print --size 174mm --shot "$out/bottleneck-on.pdf" --shot "$out/bottleneck-on.png"
