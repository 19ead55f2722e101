#!/usr/bin/env bash
# Makes docs/images/report.png: the page of a check that failed because a cube was thrown a little to the side.
# Usage: tools/scripts/report/picture.sh [FOLDER]     FOLDER: docs/images unless said
# Needs build/release/tools/tumble, ffmpeg, node, npm and chromium (tools/setup.sh --with report).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
tumble=$PWD/build/release/tools/tumble
out=$(realpath "${1:-docs/images}")
chromium=$(command -v "${CHROMIUM:-chromium}")
modules=$(tools/scripts/report/packages.sh)
work=$(dirname "$(mktemp --dry-run)")/demo  # short: the page shows it
mkdir "$work"
trap 'rm -rf "$work"' EXIT

mkdir -p "$work/golden/cases"
cp -r golden/cases/layered_brick_wall golden/cases/stacks golden/cases/tilted_grid "$work/golden/cases/"
scene=$work/golden/cases/layered_brick_wall/scene.toml
sed -i 's/^velocity = \[0.0, 25.0, 4.0\]/velocity = [1.5, 25.0, 4.0]/' "$scene"
cmp -s "$scene" golden/cases/layered_brick_wall/scene.toml && { echo "report_picture: the throw is written otherwise now" >&2; exit 1; }
(cd "$work" && "$tumble" check --suite golden --report report >/dev/null) || (($? == 1))
CHROMIUM=$chromium MODULES=$modules node tests/report_page/picture.js "$work/report/index.html" "$work"
ffmpeg -v error -y -i "$work/top.png" -i "$work/slider.png" -i "$work/bodies.png" -filter_complex \
  "[0]scale=-2:1200[a];[1]scale=840:-2[b];[2]scale=840:-2[c];[b][c]vstack,pad=880:1200:20:20:white[d];[a][d]hstack,scale=1300:-2:flags=lanczos,split[e][f];[e]palettegen=max_colors=200[p];[f][p]paletteuse=dither=none" \
  -compression_level 9 "$out/report.png"
printf '%s  %s bytes\n' "$out/report.png" "$(stat -c %s "$out/report.png")"
