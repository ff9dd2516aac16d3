#!/bin/sh
# CT figure 2 in two dimensions: three walls cut away what can be seen of a box.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" --headless --state examples/states/coorg-teller/figure-2.json --shot "$out/ct-figure-2.svg"
