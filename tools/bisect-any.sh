#!/usr/bin/env bash
# One revision of any engine that writes our logs, judged for `git bisect run`: builds it, lets it record a session,
# compares that with a log or holds a metric against a bound. docs/bisecting.md has an example.
# Usage: git bisect run tools/bisect-any.sh --run COMMAND [--build COMMAND] (--log LOG | --require EXPR...)
#   --build COMMAND  builds the revision, run by sh in the current folder
#   --run COMMAND    runs it, by sh; it has to write the log that $TUMBLE_LOG names
#   --log LOG        good is what this log holds, every bit; --tolerance FIELD=V as for `tumble diff`
#   --require EXPR   good is what keeps this bound, as in 'lateral_max<=0'; may be repeated
# TUMBLE names the program tumble; the one in PATH if it is not set.
# Exit status, as git bisect wants it: 0 good; 1 bad; 125 to be skipped: it does not build, run or write a whole log.
# 128 and up would end the bisection; so does bad usage here (255).
set -euo pipefail
trap 'exit 255' ERR  # a mistake of this script is no verdict

usage() {
  sed -n '2,12s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 255
}

tumble=${TUMBLE:-tumble}
build="" run="" log="" bounds=() tolerances=()
while (($#)); do
  (($# > 1)) || usage
  case "$1" in
    --build) build=$2 ;;
    --run) run=$2 ;;
    --log) log=$2 ;;
    --require) bounds+=(--require "$2") ;;
    --tolerance) tolerances+=(--tolerance "$2") ;;
    *) usage ;;
  esac
  shift 2
done
[[ -n $run ]] || usage
[[ -n $log || ${#bounds[@]} -gt 0 ]] || usage
command -v "$tumble" >/dev/null || { printf 'bisect-any: %s: no such program; set TUMBLE\n' "$tumble" >&2; exit 255; }

skip() {
  printf 'bisect-any: skipped: %s\n' "$*" >&2
  exit 125
}

work=$(mktemp -d) || exit 255
trap 'rm -rf "$work"' EXIT
export TUMBLE_LOG=$work/session.tumble
if [[ -n $build ]]; then
  sh -c "$build" >"$work/build.txt" 2>&1 || { tail -n 3 "$work/build.txt" >&2; skip "does not build"; }
fi
sh -c "$run" >"$work/run.txt" 2>&1 || { tail -n 3 "$work/run.txt" >&2; skip "does not run"; }
[[ -s $TUMBLE_LOG ]] || skip "wrote no log"

verdict=0
judge() { # command...
  local status=0
  "$tumble" "$@" || status=$?
  case $status in
    0) ;;
    1) verdict=1 ;;
    *) skip "its log cannot be judged" ;;
  esac
}
[[ -z $log ]] || judge diff ${tolerances[@]+"${tolerances[@]}"} "$log" "$TUMBLE_LOG"
((${#bounds[@]} == 0)) || judge measure "${bounds[@]}" "$TUMBLE_LOG"
exit "$verdict"
