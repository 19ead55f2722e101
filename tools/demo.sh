#!/usr/bin/env bash
# From nothing to a result: installs what is missing, builds, records the thrown cube and the brick wall, replays the
# session bit for bit, does the same with the thesis's comparison scene, checks both against their goldens, shows what a
# difference looks like, and draws a picture and a movie.
# Usage: tools/demo.sh        Everything it makes lies in build/demo.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
demo=build/demo
mkdir -p $demo

say() { # what comes next, with the time so far
  printf '\n== %d:%02d  %s\n' $((SECONDS / 60)) $((SECONDS % 60)) "$*"
}
# Builds the program: ninja's own counter on a terminal, a line a minute elsewhere.
build() {
  local log=$demo/build.log pid=""
  cmake --preset release -DTUMBLE_TESTS=OFF >"$log" 2>&1 || { tail -n 40 "$log" >&2; return 1; }
  if [[ -t 1 ]]; then
    NINJA_STATUS='[%f of %t files, %e s] ' cmake --build --preset release --parallel "$(nproc)" --target tumble
    return
  fi
  NINJA_STATUS='[%f of %t files] ' cmake --build --preset release --parallel "$(nproc)" --target tumble >>"$log" 2>&1 &
  pid=$!
  local next=$((SECONDS + 60))
  while kill -0 "$pid" 2>/dev/null; do
    sleep 1
    ((SECONDS < next)) && continue
    next=$((SECONDS + 60))
    printf '%d:%02d  %s built\n' $((SECONDS / 60)) $((SECONDS % 60)) "$(sed -nE 's/^\[([0-9]+ of [0-9]+ files)\].*/\1/p' "$log" | tail -n 1)"
  done
  wait "$pid" || { tail -n 40 "$log" >&2; return 1; }
}

say 'Installing what building needs and this machine lacks'
tools/setup.sh --only program
installed=$SECONDS
say 'Building the program'
build || { printf 'demo: the build failed\n' >&2; exit 4; }
tumble=build/release/tools/tumble

run() { # command and arguments, shown and run
  printf '\n$ %s\n' "$*"
  "$@"
}
value() { # key, file: the first number, word or null that the key has in a JSON file
  sed -nE 's/.*"'"$1"'": *"?([^",}]*[^",} ])"?.*/\1/p' "$2" | head -n 1
}
# The verdict of a replay or diff whose JSON is in a file, for the summary.
verdict() { # file, what it is when identical
  if [[ $(value identical "$1") == true ]]; then
    printf '%s (%s steps)' "$2" "$(value steps "$1")"
  else
    printf 'DIFFERS from step %s, phase %s' "$(value step "$1")" "$(value phase "$1")"
  fi
}

say 'A first session, recorded and replayed'
run $tumble record brick_wall -o $demo/brick_wall.tumble
run $tumble replay $demo/brick_wall.tumble
first=$SECONDS
say "The log's contents, and the thesis's comparison scene with its symmetry measured"
run $tumble info $demo/brick_wall.tumble
run $tumble record tilted_grid -o $demo/tilted_grid.tumble
run $tumble replay $demo/tilted_grid.tumble
run $tumble measure $demo/tilted_grid.tumble

say 'Both sessions checked against their goldens, pictures included'
pictures=$SECONDS
tools/setup.sh --only pictures
installed=$((installed + SECONDS - pictures))
run $tumble check brick_wall tilted_grid --report $demo/report

say 'The same wall again, and once more with gravity stronger by a billionth'
run $tumble record brick_wall -o $demo/again.tumble --quiet
run $tumble diff $demo/brick_wall.tumble $demo/again.tumble
run $tumble record brick_wall -o $demo/stronger.tumble --quiet --set 'world.gravity=[0, 0, -9.81000001]'
run $tumble diff $demo/brick_wall.tumble $demo/stronger.tumble && status=0 || status=$?
if ((status != 1)); then
  printf 'demo: the difference was not found (exit status %d)\n' "$status" >&2
  exit 1
fi

for name in brick_wall tilted_grid; do
  $tumble info --json $demo/$name.tumble >$demo/$name.info.json
  $tumble replay --json $demo/$name.tumble >$demo/$name.replay.json
  $tumble measure --json $demo/$name.tumble >$demo/$name.measure.json
done
$tumble diff --json $demo/brick_wall.tumble $demo/again.tumble >$demo/again.diff.json
$tumble diff --json $demo/brick_wall.tumble $demo/stronger.tumble >$demo/stronger.diff.json || true

say 'A picture and a movie'
run $tumble render $demo/brick_wall.tumble --step 60 -o $demo/brick_wall.png
run $tumble render $demo/brick_wall.tumble -o $demo/brick_wall.mp4 --size 480x360 --samples 1

say 'Summary'
printf 'The first session was recorded and replayed after %d s, everything after %d s; installing took %d s of them.\n' \
  "$first" "$SECONDS" "$installed"
for name in brick_wall tilted_grid; do
  printf '%s\n' "$name: $(value title $demo/$name.info.json)"
  printf '  recorded      %s bodies, %s steps, %s s of motion, every state of every body\n' \
    "$(value bodies $demo/$name.info.json)" "$(value steps $demo/$name.info.json)" "$(value seconds $demo/$name.info.json)"
  printf '  log           %s bytes, %.1f bytes per moving body-step (raw: 104)\n' \
    "$(value bytes $demo/$name.info.json)" "$(value bytes_per_moving_body_step $demo/$name.info.json)"
  printf '  replay        %s\n' "$(verdict $demo/$name.replay.json "identical to the bit")"
  printf '  final hash    %s\n' "$(value final_hash $demo/$name.info.json)"
done
printf 'Golden suite, these two cases: %s\n' "$(sed -nE 's/.*"headline": "([^"]*)".*/\1/p' $demo/report/report.json)"
printf 'Symmetry of tilted_grid: lateral error %s m, column spread %s m (both exactly 0 when right)\n' \
  "$(value lateral_max $demo/tilted_grid.measure.json)" "$(value column_spread $demo/tilted_grid.measure.json)"
printf 'The wall recorded twice: %s\n' "$(verdict $demo/again.diff.json "identical to the bit")"
printf 'With stronger gravity:   %s, body %s, %s\n' "$(verdict $demo/stronger.diff.json "no difference found")" \
  "$(value body $demo/stronger.diff.json)" "$(value field $demo/stronger.diff.json)"
printf 'Logs, figures, brick_wall.png and brick_wall.mp4 are in %s/%s; the program is %s.\n' "$PWD" "$demo" "$tumble"
printf 'Next: %s --help, README.md, and tools/test.sh for all tests.\n' "$tumble"
