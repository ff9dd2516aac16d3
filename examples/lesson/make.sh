#!/bin/sh
# The states of docs/teaching.md: make.sh VIEWER [FOLDER]
# SPDX-License-Identifier: GPL-3.0-or-later
set -e
viewer=$1 out=${2:-examples/lesson}

# state NAME SCENE OPTION... --do COMMANDS: the file keeps the hash of its scene and not the segments, which the
# catalogue makes again.
state() {
    name=$1
    shift
    "$viewer" "$@; save $out/$name.json" > "$out/$name.log" 2>&1 || { cat "$out/$name.log" >&2; exit 1; }
    rm "$out/$name.log"
    awk '/^  "embedded": \{/ { skip = 1; sub(/,$/, "", held) }
         !skip { if (NR > 1) print held; held = $0 }
         skip && /^  \}/ { skip = 0 }
         END { print held }' "$out/$name.json" > "$out/$name.short"
    mv "$out/$name.short" "$out/$name.json"
}

state 01-street streets --headless --do "seek start"
state 02-bottleneck bottleneck --headless --do "seek start"
state 03-one-step bottleneck --headless --do "seek 6"
state 04-penalty bottleneck --headless --do "compare penalty=multiply"
state 05-forgotten-wall forget --headless --set show_chain=on --do "seek 104; select last"
state 06-two-segments wall2 --headless --set show_chain=on --do "seek 93; select last"
state 07-one-scale statue --headless --set label=solidity --do "compare solidity_scale=p95; seek 30"
state 08-one-scale-added statue --headless --set penalty=add --set label=solidity \
    --do "compare solidity_scale=p95; seek 30"
state 09-no-order terrain --headless --do "compare centroid; align rendered; seek end"
state 10-moved-eye bottleneck --headless --set penalty=multiply --do "seek end"
state 11-task cars --headless --do "seek start"
