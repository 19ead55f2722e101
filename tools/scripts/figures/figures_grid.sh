#!/usr/bin/env bash
# Makes the pictures of the comparison scene, after the thesis's Figs. 21 to 25, with Bullet's view where the thesis has Havok's.
# Usage: tools/scripts/figures/figures_grid.sh [FOLDER [FIGURE...]]     FOLDER: docs/images unless said; FIGURE: 21 … 25 (all unless said)
# Needs build/release/tools/tumble, build/release/bench/peers/tumble_peer_bullet (tools/setup.sh --with peers), ffmpeg and gnuplot.
# All figures take about half an hour. Bullet's 200 substeps of 1/300 s, and those of 6400 cubes, take half an hour more and are run
# only with FIGURES_FINEST=1. Fig. 25 is a measurement of this machine, so it is made only where it is named.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
# shellcheck source=tools/scripts/figures/figures_lib.sh
source tools/scripts/figures/figures_lib.sh

scene=golden/cases/tilted_grid/scene.toml
seconds=5
fine=0.0033333333333333335 coarse=0.03333333333333333 # s
steps_of() { [[ $1 == "$fine" ]] && echo 300 || echo 30; } # dt: steps a second

# The whole field of n × n cubes from above, also the rows that roll farthest.
view_of() { # n: sets view
  local span=$((75 * $1 / 20)) middle=$((31 * $1 / 20))
  ((span < 200)) || span=$((span * 2 / 3)) middle=$((middle * 2 / 3)) # larger fields do not spread in proportion within 5 s
  view=(--camera "position=0,$middle,$((2 * span))" --camera "target=0,$middle,0" --camera fov=28 --effects -dof,-motion,-shadow,-specular --samples 3)
}
grid=() # of the next sessions: sizes of the field
ours() { # name, dt, substeps, more: a session of method thesis
  record "$1" tilted_grid --set world.method='"thesis"' --set world.dt="$2" --set world.substeps="$3" \
    --states "every:$(($(steps_of "$2") * seconds))" "${grid[@]}" "${@:4}"
}
bullets() { # name, dt, substeps: Bullet has none, so its steps are as long as one; a state each half second
  local n=$(($(steps_of "$2") * $3))
  record_by bullet "$1" $scene --set "world.dt=$(awk -v n=$n 'BEGIN { printf "%.17g", 1 / n }')" "${grid[@]}" --every $((n / 2))
}
has_bullet() { # dt, substeps
  [[ $1 != "$fine" || $2 != 200 || -n ${FIGURES_FINEST-} || -f $work/bullet-20-fine-200.tumble ]]
}
blank() { # picture, words; in place of a session that was not run
  ffmpeg -v error -y -f lavfi -i "color=white:size=$size" -frames:v 1 "$work/$1.png"
  name "$1" "$2"
}
last() { # picture, session, words: the last state from above
  "$tumble" render "$work/$2.tumble" -o "$work/$1.png" --size "$size" "${view[@]}" >/dev/null
  name "$1" "$3"
}

if is_wanted 21; then
  view_of 20
  size=400x400
  ours 20-fine-1 $fine 1
  bullets bullet-20-coarse-1 $coarse 1
  draw 21a 20-fine-1 0 "${view[@]}" --camera position=0,8,120 --camera target=0,8,0 --camera fov=14
  draw 21b 20-fine-1 0
  draw 21c bullet-20-coarse-1 0 "${view[@]}" --camera position=0,8,120 --camera target=0,8,0 --camera fov=14
  name 21a Tumble
  name 21b Tumble
  name 21c Bullet
  row 21 21a 21b 21c
  publish 21 fig21_comparison_scene
fi
if is_wanted 22; then
  view_of 20
  size=240x400
  for length in fine coarse; do
    for n in 1 4 10 40 200; do
      ours 20-$length-$n ${!length} $n
      last 22-$length-$n 20-$length-$n "$n"
      if ! has_bullet ${!length} $n; then
        blank 22-bullet-$length-$n "$n, Bullet, not run"
        continue
      fi
      bullets bullet-20-$length-$n ${!length} $n
      last 22-bullet-$length-$n bullet-20-$length-$n "$n, Bullet"
    done
    row 22-$length 22-$length-{1,4,10,40,200}
    row 22-bullet-$length 22-bullet-$length-{1,4,10,40,200}
    column 22 22-$length 22-bullet-$length
    publish 22 "fig22_400_cubes_$([[ $length == fine ]] && echo a || echo b)"
  done
fi
if is_wanted 23; then
  view_of 20
  size=240x400
  [[ -f $work/clock.tumble ]] || "$tumble" record tilted_grid -o "$work/clock.tumble" --quiet --set world.dt=$coarse --set world.substeps=1 --realtime
  ours 20-coarse-200 $coarse 200
  ours 20-fine-200 $fine 200
  ours 20-finest 0.00033333333333333335 8
  finest=40
  ! has_bullet $fine 200 || finest=200
  bullets bullet-20-fine-$finest $fine $finest
  last 23a clock 'real time'
  last 23b 20-coarse-200 '1/30, 200'
  last 23c 20-fine-200 '1/300, 200'
  last 23d 20-finest '1/3000, 8'
  last 23e bullet-20-fine-$finest "1/300, $finest, Bullet"
  row 23 23{a,b,c,d,e}
  publish 23 fig23_real_time
fi
many() { # n: sets grid and the view of n × n cubes
  grid=(--set "grid.rows=$1" --set "grid.cols=$1")
  view_of "$1"
}
if is_wanted 24; then
  size=400x400
  many 40
  ours 40-coarse-200 $coarse 200
  ours 40-fine-200 $fine 200
  bullets bullet-40-coarse-40 $coarse 40
  last 24a 40-coarse-200 '1600, 1/30, 200'
  last 24b 40-fine-200 '1600, 1/300, 200'
  last 24c bullet-40-coarse-40 '1600, 1/30, 40, Bullet'
  row 24x 24a 24b 24c
  for side in 60 80; do
    many $side
    most=200
    [[ $side != 80 || -n ${FIGURES_FINEST-} || -f $work/80-fine-200.tumble ]] || most=40
    for n in 1 10 $most; do
      ours $side-fine-$n $fine $n
      last 24-$side-$n $side-fine-$n "$((side * side)), 1/300, $n"
    done
    row 24-$side "24-$side-1" "24-$side-10" "24-$side-$most"
  done
  column 24 24x 24-60 24-80
  publish 24 fig24_numbers_of_cubes
fi
if is_named 25; then
  "$tumble" bench scaling --method thesis --plot "$work/25.png" >/dev/null
  publish 25 fig25_growth_thesis
fi
