#!/bin/sh
# The states of figures 1 to 8 of Coorg and Teller (docs/figures.md): make.sh VIEWER2D VIEWER3D [FOLDER]
# SPDX-License-Identifier: GPL-3.0-or-later
set -e
viewer2d=$1 viewer3d=$2 out=${3:-examples/states/coorg-teller}
here=$(dirname "$0")
case $viewer3d in /*) ;; *) viewer3d=$PWD/$viewer3d ;; esac
case $out in /*) ;; *) out=$PWD/$out ;; esac

# state NAME VIEWER SCENE METHOD VIEW DO: the run at its end, with what DO selects and notes
state() {
    name=$1 viewer=$2 scene=$3 method=$4 view=$5
    shift 5
    # The view is several words.
    # shellcheck disable=SC2086
    "$viewer" "$scene" --headless --method "$method" --budget unlimited --size 120mm $view \
        --do "run; $1; save $out/$name.json" > "$out/$name.log" 2>&1 || { cat "$out/$name.log" >&2; exit 1; }
    rm "$out/$name.log"
}

plane() {
    name=$1 scene=$here/../../scenes/$2.json
    shift 2
    state "$name" "$viewer2d" "$scene" "$@"
}

# A 3D state names its scene, which lies beside it.
space() {
    name=$1 scene=$2.obj
    shift 2
    [ "$out/$scene" -ef "$here/$scene" ] || cp "$here/$scene" "$out"
    (cd "$out" && state "$name" "$viewer3d" "$scene" "$@")
}

single="coorg-teller connected=off occluder_count=1 leaf=1"
joint="coorg-teller connected=on leaf=1"
near="coorg-teller leaf=1 threshold=0.6"

plane figure-1a viewpoints "$near" "--eye 1,3" \
    "note callout primitive:0 occluder; note callout primitive:1 occludee"
plane figure-1b viewpoints "$near" "--eye 11,3" \
    "note callout primitive:1 occluder; note callout primitive:0 occludee"
plane figure-2 three-walls "coorg-teller connected=fused leaf=1" "" \
    "select node:6; note text primitive:0 [-12,0] A; note text primitive:1 [10,0] B; \
note text primitive:2 [-12,0] C; note text 9,3 [0,0] T"
plane figure-3a wedge "$single" "" "select node:4; note text primitive:0 [10,0] A; note text 9.2,2.8 [0,0] T"
plane figure-3b two-walls "$joint" "" \
    "select node:2; note text primitive:0 [-8,0] A; note text primitive:1 [-8,0] B; note text 8.8,2.3 [0,0] T"
plane figure-3c three-walls "$joint" "" \
    "select node:6; note text primitive:0 [-12,0] A; note text primitive:1 [10,0] B; \
note text primitive:2 [-12,0] C; note text 8.8,2.3 [0,0] T"
plane figure-4a wedge "$single" "--eye 1,4.65" \
    "select node:4; note text primitive:0 [10,0] A; note text 9.2,2.8 [0,0] T"
plane figure-4b two-walls "$joint" "" \
    "select node:2; note text primitive:0 [-8,-8] A; note text primitive:1 [-8,8] B; note text 4.5,3 [8,0] e; \
note text 8.8,2.3 [0,0] T"
plane figure-4c bent-walls "$joint" "" \
    "select node:4; note text primitive:0 [-8,0] A; note text primitive:1 [8,0] B; note text 4.5,3 [0,8] e; \
note text 8.8,2.3 [0,0] T"
space figure-5a convex "$joint" "--eye 0,0,0 --look-at 1,0,0 --fov 60" \
    "select node:10; note text primitive:0 [0,0] A; note text primitive:2 [0,0] B; note text primitive:4 [0,0] C"
space figure-5b notched "$joint" "--eye 0,0,0 --look-at 1,0,0 --fov 60" \
    "select node:6; note text primitive:0 [0,0] A; note text primitive:2 [0,0] B; note text 4.25,0.8,0.65 [0,8] e"
plane figure-6 one-occluder "coorg-teller threshold=1 tree=octree leaf=1" "" \
    "note callout primitive:0 the only occluder"
plane figure-8 wedge "coorg-teller threshold=1 leaf=1" "--eye 2.5,3" \
    "select primitive:0; note callout primitive:0 area-angle 2 · 1 / 1.5 = 1.33"

# A moving eye: the frame before this one is kept. The catalogue makes the scene again.
state moving-eye "$viewer2d" soda "coorg-teller step=change" "--fov 360 --eye 20,22" "frame keep; seek start"
moving=$out/moving-eye
awk '/^  "embedded": \{/ { skip = 1; sub(/,$/, "", held) }
     !skip { if (NR > 1) print held; held = $0 }
     skip && /^  \}/ { skip = 0 }
     END { print held }' "$moving.json" > "$moving.short"
mv "$moving.short" "$moving.json"
