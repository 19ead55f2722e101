#!/usr/bin/env bash
# Makes the pictures of docs/live.md: the window of `tumble live` after three throws, and a movie of twenty seconds as it
# was seen, rendered from the log of the session, with a sheet of eight of its pictures.
# Usage: tools/scripts/figures/live.sh [FOLDER]   FOLDER: for live.png, live_movie.png, live.tumble and live.mp4 (build/live)
# Needs build/release/tools/tumble with its window, Xvfb, xdotool and ffmpeg (tools/setup.sh --with live).
# Copy the two pictures to docs/images once they were looked at.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
tumble=$(realpath "${TUMBLE:-build/release/tools/tumble}")
folder=${1:-build/live}
for command in Xvfb xdotool ffmpeg; do
  command -v $command >/dev/null || { printf 'live: %s is missing\n' $command >&2; exit 77; }
done
mkdir -p "$folder"
cd "$folder"
rm -f live.tumble window.tumble

exec 3<>display
Xvfb -displayfd 3 -screen 0 1024x768x24 -nolisten tcp -noreset 2>/dev/null &
display=$!
trap 'kill $display; rm -f display' EXIT
until [[ -s display ]]; do sleep 0.1; done
DISPLAY=:$(<display)
export DISPLAY

"$tumble" live brick_wall --size 800x560 -o window.tumble >/dev/null &
window=$!
until xdotool search --onlyvisible --name "tumble live" windowfocus >/dev/null 2>&1; do sleep 0.2; done
sleep 2
# step by phase; a slow window must see each part in a frame of its own
xdotool mousemove 60 66 sleep 0.3 mousedown 1 sleep 0.3 mouseup 1 sleep 0.3
for x in 500 540 580; do
  xdotool mousemove $x 230 mousedown 1
  sleep 0.8
  xdotool mouseup 1
  sleep 0.7
done
few_colours() { # colours filter: of ffmpeg's input, in front of which the palette is made
  printf '%s,split[a][b];[a]palettegen=max_colors=%d:stats_mode=single[p];[b][p]paletteuse=dither=none' "$2" "$1"
}
ffmpeg -y -loglevel error -f x11grab -video_size 800x560 -i "$DISPLAY" -vf "$(few_colours 200 null)" -frames:v 1 live.png
xdotool key ctrl+q
wait $window

"$tumble" live brick_wall --measure 20 --size 640x360 -o live.tumble >/dev/null
"$tumble" replay live.tumble
"$tumble" render live.tumble --as-seen --size 640x360 -o live.mp4
ffmpeg -y -loglevel error -i live.mp4 -vf "$(few_colours 160 'fps=1/2.5,scale=240:-1,tile=4x2')" -frames:v 1 live_movie.png
