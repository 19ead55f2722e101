#!/usr/bin/env bash
# Draws every golden picture again, in a process of its own each, under every setting that must not matter, and counts
# the pixels that differ from the golden's. Status 1 if any does. By hand: it takes minutes, and goldens of another
# machine or Mesa may differ by rounding.
# Usage: tools/scripts/checks/picture_bits.sh [ROUNDS]     ROUNDS: times that each picture is drawn as it is, 4 unless said
# Needs build/release/tools/tumble, ffmpeg, and the drivers of both OSMesa and EGL.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
tumble=$PWD/build/release/tools/tumble
rounds=${1:-4}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

pixels_of() { # picture: one line a pixel
  ffmpeg -v error -i "$1" -f rawvideo -pix_fmt rgb24 - | od -An -v -tu1 -w3
}
pictures=(golden/cases/*/frame_*.png)
for picture in "${pictures[@]}"; do
  name=$(basename "$(dirname "$picture")")
  if [[ -f golden/cases/$name/session.tumble ]]; then # another engine's
    cp "golden/cases/$name/session.tumble" "$work/$name.tumble"
  elif [[ ! -f $work/$name.tumble ]]; then
    "$tumble" record "$name" -o "$work/$name.tumble" --quiet
  fi
  pixels_of "$picture" >"$work/$name-$(basename "$picture" .png)"
done

failed=0
draw_all() { # words, arguments of render; the environment is set already
  local drawn=0 differing=0 picture name frame step size show count
  for picture in "${pictures[@]}"; do
    name=$(basename "$(dirname "$picture")")
    frame=$(basename "$picture" .png)
    step=$((10#${frame#frame_}))
    size=$(ffprobe -v error -show_entries stream=width,height -of csv=p=0:s=x "$picture")
    # The rules say which pictures show what is frozen.
    show=$(awk -v step=$step '/^\[\[/ { hit = 0 } /^step *=/ && $3 == step { hit = 1 } /^freezing *= *true/ && hit { print "freezing" }' \
      "golden/cases/$name/metrics.toml")
    "$tumble" render "$work/$name.tumble" --step $step --size "$size" --show "$show" -o "$work/drawn.png" "${@:2}" >/dev/null
    pixels_of "$work/drawn.png" >"$work/drawn"
    count=$(paste -d '|' "$work/$name-$frame" "$work/drawn" | awk -F '|' '$1 != $2 { n++ } END { print n + 0 }')
    drawn=$((drawn + 1))
    differing=$((differing + count))
    ((count == 0)) || printf '  %s: %d pixels differ\n' "$picture" "$count"
  done
  printf '%-28s %3d pictures, %d pixels differ\n' "$1" $drawn $differing
  ((differing == 0)) || failed=1
}

for ((round = 1; round <= rounds; ++round)); do draw_all "as it is, round $round"; done
draw_all "--gl osmesa" --gl osmesa
draw_all "--gl egl" --gl egl
for threads in 0 1 2; do LP_NUM_THREADS=$threads draw_all "LP_NUM_THREADS=$threads"; done
for width in 128 256; do LP_NATIVE_VECTOR_WIDTH=$width draw_all "LP_NATIVE_VECTOR_WIDTH=$width"; done
exit $failed
