#!/usr/bin/env bash
# Makes the drawings of docs/thesis.md, after the thesis's Figs. 8 and 9: one box in several others, before and after the
# first step of a recorded session. What the session made of it is read from the log, the rest is drawn beside it.
# Usage: tools/scripts/figures/figures_drawn.sh [FOLDER]     FOLDER: docs/images unless said
# Needs build/release/tools/tumble and gnuplot.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
tumble=$PWD/build/release/tools/tumble
out=${1:-docs/images}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"

width=1.4 height=1.0 # of the box that moves, m; all sizes along x and z
box() { # x, z, width, height, more
  printf '[[box]]\nposition = [%s, 0, %s]\nsize = [%s, 1, %s]\n%b' "$1" "$2" "$3" "$4" "${5-}"
}
head_of_scene='[world]\nmethod = "thesis"\nsteps = 1\nsubsteps = 1\ngravity = [0, 0, 0]\nground = false\n[material]\nrestitution = 0\n'
scene() { # name, z of the box, "x z width height" of each static one
  printf '%b' "$head_of_scene" >"$work/$1.toml"
  box 0 "$2" $width $height >>"$work/$1.toml"
  local at
  for at in "${@:3}"; do
    # shellcheck disable=SC2086 # four numbers
    box $at 'static = true\n' >>"$work/$1.toml"
  done
  "$tumble" record "$work/$1.toml" -o "$work/$1.tumble" --quiet
}
place_of() { # name: x and z after the step, to the millimetre
  "$tumble" dump "$work/$1.tumble" --step 1 --body 1 --csv | awk -F, 'END { printf "%.3f %.3f\n", $3, $5 }'
}
statics() { # "x z width height"...
  local at x z w h
  for at in "$@"; do
    read -r x z w h <<<"$at"
    echo "set object rect center $x,$z size $w,$h fc rgb '#c9ced6' fs solid border lc rgb '#5f6670'"
  done
}
before() { # z: where the box was
  echo "set object rect center 0,$1 size $width,$height fs empty border lc rgb '#6b4a2a' dt 2 front"
}
after() { # x, z
  echo "set object rect center $1,$2 size $width,$height fc rgb '#d9984f' fs transparent solid 0.55 border lc rgb '#6b4a2a' lw 2 front"
}
arrow() { # from x, z; by x, z; colour
  echo "set arrow from $1,$2 rto $3,$4 lw 2.5 lc rgb '$5' front filled size 0.07,22"
}
note() { echo "set label at $1,$2 center '$3' tc rgb '#202020' front"; }
panel() { # title; objects are set already
  echo "set title '$1'"
  echo "plot [-1.75:1.75][-1.15:$top] NaN notitle"
  echo "unset object; unset arrow; unset label"
}
start() { # picture, panels
  echo "set terminal pngcairo size $((400 * $2)),$3 font ',11'"
  echo "set output '$1'; set multiplot layout 1,$2; unset tics; unset border; set size ratio -1"
  echo "set lmargin 1; set rmargin 1; set tmargin 2; set bmargin 1"
}

# Fig. 8: 300 mm in one block and 180 mm in another.
blocks=("-0.8 -0.5 1.5 1" "0.8 -0.62 1.5 1")
scene two 0.2 "${blocks[@]}"
read -r x z <<<"$(place_of two)"
top=1.35
{
  start "$out/fig08_separation_simple.png" 3 320
  statics "${blocks[@]}"; before 0.2; after 0 0.68; panel '(a) the sum, 480 mm: too much'
  statics "${blocks[@]}"; before 0.2; after 0 0.44; panel '(b) the mean, 240 mm: not apart'
  statics "${blocks[@]}"; before 0.2; after "$x" "$z"
  panel "(c) as recorded, $(awk -v z="$z" 'BEGIN { printf "%.0f", 1000 * (z - 0.2) }') mm: apart"
} | gnuplot

# Fig. 9: 250 and 150 mm in two blocks below, 120 mm in one at the side, 100 mm in one above.
blocks=("-0.6 -0.5 1.1 1" "0.6 -0.6 1.1 1" "-1.08 0.4 1.0 0.5" "0.5 1.05 1.1 0.8")
scene four 0.25 "${blocks[@]}"
read -r x z <<<"$(place_of four)"
top=1.55
{
  start "$out/fig09_separation_complex.png" 3 370
  statics "${blocks[@]}"; before 0.25
  note -0.6 -0.35 '1: 250 mm up'; note 0.6 -0.35 '2: 150 mm up'; note -1.12 0.4 '3: 120 mm'; note 0.5 1.05 '4: 100 mm'
  panel '(a) what each asks for'
  # Three times as long as they are: the longer one up, the one down, the one sideways; then what comes of them.
  arrow -1.0 0 0 0.75 '#8a8f98'; arrow -0.6 0 0 0.45 '#c0c4ca'; arrow -0.2 0.75 0 -0.30 '#8a8f98'; arrow 0.1 0 0.36 0 '#8a8f98'
  note -1.0 -0.15 '1'; note -0.6 -0.15 '2'; note -0.2 0.9 '4'; note 0.28 -0.15 '3'
  arrow 0.9 0 "$(awk -v x="$x" 'BEGIN { print 3 * x }')" "$(awk -v z="$z" 'BEGIN { print 3 * (z - 0.25) }')" '#b35309'
  note 1.05 -0.15 'recorded'
  note 0 -0.6 "up max(250, 150) − 100, sideways 120"
  panel '(b) merged, axis by axis'
  statics "${blocks[@]}"; before 0.25; after "$x" "$z"
  panel "(c) as recorded: $(awk -v x="$x" -v z="$z" 'BEGIN { printf "%.0f mm sideways, %.0f up", 1000 * x, 1000 * (z - 0.25) }')"
} | gnuplot
ls -s --block-size=1 "$out"/fig0[89]*.png
