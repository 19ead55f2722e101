#!/usr/bin/env bash
# How long the pages of `tumble view` let a person wait in chromium: the served page of 6400 cubes in 1500 steps, and the
# page to send of 400 cubes in as many. The server's own figures are those of `tumble bench view`.
# Usage: tools/scripts/figures/view.sh [RUNS]     RUNS: times that each page is opened; 5 unless said
# Needs build/release/tools/tumble, node, npm, chromium (tools/setup.sh --with report) and curl.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
tumble=$(realpath "${TUMBLE:-build/release/tools/tumble}")
CHROMIUM=$(command -v "${CHROMIUM:-chromium}")
MODULES=$(tools/scripts/report/packages.sh)
export CHROMIUM MODULES
work=$(mktemp -d)
server=
trap '[[ -z $server ]] || kill $server; rm -rf "$work"' EXIT

grid() { # rows
  "$tumble" record layered_grid --set grid.rows="$1" --set grid.cols="$1" --steps 1500 --quiet -o "$work/$1.tumble" >/dev/null
}
grid 80
grid 20
"$tumble" view "$work/80.tumble" >"$work/said" &
server=$!
until address=$(grep -m1 '^http:' "$work/said"); do sleep 0.1; done
printf 'load %s\nserved, 6400 x 1500: ' "$(cut -d ' ' -f 1-3 /proc/loadavg)"
node tests/session_page/figures.js "$address" "${1:-5}"
until curl -fsS "${address}news?log=0" | grep -q '"timeline_done":true,"contacts_done":true'; do sleep 1; done
printf 'memory of the server, timeline and contacts begun complete: '
grep VmHWM /proc/$server/status
kill $server
wait $server || true
server=
"$tumble" view "$work/20.tumble" -o "$work/20.html"
printf 'sent, 400 x 1500: '
node tests/session_page/figures.js "$work/20.html" "${1:-5}"
