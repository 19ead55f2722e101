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

# Fig. 9: slanted blocks of 0.8 m thickness and 2 m depth, deeper than the box, so that their faces are the planes. A row of
# `slanted`: name, degrees of the face's normal from up towards x, depth (m), width (m).
z0=0.25
slanted='1 25 0.20 1.1
2 -20 0.12 1.1
3 95 0.10 0.8
4 -94 0.04 0.8'
# For a row: normal (nx, nz) and centre (x, z) of the block. Its face lies `depth` beyond the box's deepest corner (cx, cz).
geometry='function row_of(  t) { t = $2 * atan2(0, -1) / 180; nx = sin(t); nz = cos(t)
  cx = (nx > 0 ? -1 : 1) * w / 2; cz = z0 + (nz > 0 ? -1 : 1) * h0 / 2
  x = cx + nx * ($3 - 0.4); z = cz + nz * ($3 - 0.4) }'
over_rows() { # awk program for each row
  awk -v w=$width -v h0=$height -v z0=$z0 "$geometry { row_of() } $1" <<<"$slanted"
}
slanted_scene() {
  printf '%b' "$head_of_scene" >"$work/slanted.toml"
  box 0 $z0 $width $height >>"$work/slanted.toml"
  over_rows '{ printf "[[box]]\nposition = [%.12f, 0, %.12f]\nsize = [%s, 2, 0.8]\naxis = [0, 1, 0]\ndegrees = %s\nstatic = true\n",
    x, z, $4, $2 }' >>"$work/slanted.toml"
  "$tumble" record "$work/slanted.toml" -o "$work/slanted.tumble" --quiet
}
blocks() { # drawn as polygons
  over_rows '{ a = $4 / 2; b = 0.4; printf "set object polygon from %f,%f to %f,%f to %f,%f to %f,%f to %f,%f", x + a * nz + b * nx, z - a * nx + b * nz,
    x + a * nz - b * nx, z - a * nx - b * nz, x - a * nz - b * nx, z + a * nx - b * nz, x - a * nz + b * nx, z + a * nx + b * nz,
    x + a * nz + b * nx, z - a * nx + b * nz; print " fc rgb \"#c9ced6\" fs solid border lc rgb \"#5f6670\"" }'
}
slanted_scene
read -r x z <<<"$(place_of slanted)"
left=$(awk -v w=$width -v h0=$height -v z0=$z0 -v dx="$x" -v dz="$(awk -v z="$z" -v z0=$z0 'BEGIN { print z - z0 }')" \
  "$geometry { row_of(); d = 1000 * (\$3 - nx * dx - nz * dz); if (d > most) most = d } END { printf \"%.0f\", most }" <<<"$slanted")
top=1.55
{
  start "$out/fig09_separation_complex.png" 3 370
  blocks; before $z0
  over_rows '{ printf "set label at %f,%f center \"%s: %d mm\" tc rgb \"#202020\" front\n", x, z, $1, 1000 * $3 }'
  panel '(a) what each asks for'
  # Four times as long as they are, from one point; then what comes of them.
  over_rows '{ printf "set arrow from -0.6,0.1 rto %f,%f lw 2.5 lc rgb \"#8a8f98\" front filled size 0.07,22\n", 4 * $3 * nx, 4 * $3 * nz
    printf "set label at %f,%f center \"%s\" tc rgb \"#202020\" front\n", -0.6 + (4 * $3 + 0.12) * nx, 0.1 + (4 * $3 + 0.12) * nz, $1 }'
  arrow 0.7 0.1 "$(awk -v x="$x" 'BEGIN { print 4 * x }')" "$(awk -v z="$z" -v z0=$z0 'BEGIN { print 4 * (z - z0) }')" '#b35309'
  note 0.75 -0.1 'recorded'
  panel '(b) merged: the least sum of squares'
  blocks; before $z0; after "$x" "$z"
  panel "(c) as recorded: at most $left mm are left"
} | gnuplot
ls -s --block-size=1 "$out"/fig0[89]*.png
