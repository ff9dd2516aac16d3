#!/bin/sh
# CT figure 1: what hides from one side is hidden from the other.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
viewer=$1 out=${2:-.}
"$viewer" --headless --state examples/states/coorg-teller/figure-1a.json --shot "$out/ct-figure-1a.svg"
"$viewer" --headless --state examples/states/coorg-teller/figure-1b.json --shot "$out/ct-figure-1b.svg"
