#!/bin/sh
# CT figure 3 in two dimensions: one wall hides a box, two that meet, three that do not.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" --headless --state examples/states/coorg-teller/figure-3a.json --shot "$out/ct-figure-3a.svg"
"$viewer" --headless --state examples/states/coorg-teller/figure-3b.json --shot "$out/ct-figure-3b.svg"
"$viewer" --headless --state examples/states/coorg-teller/figure-3c.json --do "explain node 6" \
    --shot "$out/ct-figure-3c.svg"
