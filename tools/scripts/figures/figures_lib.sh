#!/usr/bin/env bash
# What figures.sh and figures_grid.sh share; sourced by both, from the root of the project.
# Sets: tumble, peers, out (folder of the pictures), wanted (figures), work (temporary folder), size of the next pictures.
set -euo pipefail
tumble=$PWD/build/release/tools/tumble
peers=$PWD/build/release/bench/peers
out=${1:-docs/images}
(($# == 0)) || shift
wanted=" $* "
work=${FIGURES_LOGS-} # a folder keeps the sessions for the next run
if [[ -z $work ]]; then
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
mkdir -p "$out" "$work"
size=400x300

is_wanted() { [[ $wanted == "  " || $wanted == *" $1 "* ]]; }
is_named() { [[ $wanted == *" $1 "* ]]; }
record() { # name, case or scene, arguments
  [[ -f $work/$1.tumble ]] || "$tumble" record "$2" -o "$work/$1.tumble" --quiet "${@:3}"
}
record_by() { # engine, name, scene file, arguments: the scene through the program of another engine, half a second a state
  [[ -x $peers/tumble_peer_$1 ]] || { echo "figures: no tumble_peer_$1; tools/setup.sh --with peers, then build it" >&2; exit 4; }
  [[ -f $work/$2.tumble ]] || "$peers/tumble_peer_$1" "$3" --log "$work/$2.tumble" "${@:4}" >/dev/null
}
draw() { # picture, session, step, arguments
  "$tumble" render "$work/$2.tumble" --step "$3" -o "$work/$1.png" --size "$size" "${@:4}" >/dev/null
}
name() { # picture, its words without a colon, in the upper left corner
  ffmpeg -v error -y -i "$work/$1.png" -vf "drawtext=font=DejaVu Sans:text='$2':x=8:y=8:fontsize=15:fontcolor=black:box=1:boxcolor=white@0.7:boxborderw=4" \
    "$work/$1-named.png"
  mv "$work/$1-named.png" "$work/$1.png"
}
row() { # figure, pictures from left to right, scaled to one height
  local inputs=() scaled='' joined='' k=0
  for picture in "${@:2}"; do
    inputs+=(-i "$work/$picture.png")
    scaled+="[$k]scale=-2:${size#*x}:flags=neighbor[s$k];"
    joined+="[s$k]"
    k=$((k + 1))
  done
  ffmpeg -v error -y "${inputs[@]}" -filter_complex "$scaled${joined}hstack=$k" "$work/$1.png"
}
column() { # figure, rows from top to bottom
  local inputs=() k=0
  for picture in "${@:2}"; do
    inputs+=(-i "$work/$picture.png")
    k=$((k + 1))
  done
  ffmpeg -v error -y "${inputs[@]}" -filter_complex "vstack=$k" "$work/$1.png"
}
publish() { # picture, name: few enough bytes for a document, with 256 colours
  ffmpeg -v error -y -i "$work/$1.png" -vf "split[a][b];[a]palettegen=max_colors=256[p];[b][p]paletteuse=dither=sierra2_4a" \
    -compression_level 9 "$out/$2.png"
  printf '%s  %s bytes\n' "$out/$2.png" "$(stat -c %s "$out/$2.png")"
}
