#!/bin/sh
# CT figure 4: planes and regions, planes that two occluders may leave out, and one that they may not.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" --headless --state examples/states/coorg-teller/figure-4a.json --shot "$out/ct-figure-4a.svg"
"$viewer" --headless --state examples/states/coorg-teller/figure-4b.json --shot "$out/ct-figure-4b.svg"
"$viewer" --headless --state examples/states/coorg-teller/figure-4c.json --shot "$out/ct-figure-4c.svg"
