#!/usr/bin/env bash
# Does `diff --zoom` of two builds of Tumble name the statement of a planted mistake? Plants faults of tests/faults one after
# the other in a copy of the tree, records sessions with the program without and the program with the fault, and zooms
# into the first step of each that differs with both programs. A fault counts as named if in a session that differs the
# first probe with another value is of a phase in which the fault lies; the place of the probe and that of the fault are
# printed: docs/zoom.md.
# Usage: tools/scripts/faults/zoom.sh [--of N] [NAME...]
#   --of N   N faults, spread evenly over those that lie in a phase, in the order of tests/faults; 10 unless given
# Needs build/release/tools/tumble of this tree and jq. Exit status: 0 nine of ten were named; 1 fewer; 2 bad usage.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
# shellcheck source=tools/scripts/faults/faults_lib.sh
source tools/scripts/faults/faults_lib.sh

cases=(layered_tower_5 layered_slide layered_inputs layered_bullets layered_size_ratio layered_sleep bounce tower thesis_slide
  thesis_inputs freeze_and_wake thesis_grid_coarse)
jobs=2 of=10 names=()
while (($#)); do
  case "$1" in
    --of) of=${2:?--of needs a number}; shift 2 ;;
    -*) sed -n '2,10s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
    *) names+=("$1"); shift ;;
  esac
done
work=$PWD/build/faults/zoom
list=$(mktemp -d)
trap 'rm -rf "$list"' EXIT
export work list
mkdir -p "$work/good" "$work/bad" "$work/log"
good=$work/tumble
tree=$work/tree
bad=$tree/build/release/tools/tumble

# The line in which the text of a fault begins.
line_of() { # name
  local before
  before=$(<"$(<"$list/$1.file")")
  before=${before%%"$(<"$list/$1.was")"*}
  printf '%d' "$(($(tr -cd '\n' <<<"$before" | wc -c)))"
}

# The answer of one session: "phase|probe at file:line", or nothing where the session does not differ.
zoom() { # case
  local log=$work/bad/$1.tumble json=$work/log/$1.json
  "$bad" record "$1" -o "$log" --quiet >/dev/null 2>&1 || true
  [[ -s $log ]] || return 0
  "$good" diff "$work/good/$1.tumble" "$log" --zoom --engine-a "$good" --engine-b "$bad" --json >"$json" 2>"$json.errors" ||
    true
  jq -r '.zoom.first.actual // empty | (.name | split(":")[0]) + "|" + .name + " at " + .file + ":" + (.line | tostring)' \
    "$json" 2>/dev/null || true
}

read_faults
mapfile -t all < <(faults_in_phases)
if ((${#names[@]} == 0)); then
  for ((k = 0; k < of; ++k)); do names+=("${all[k * ${#all[@]} / of]}"); done
fi
make_tree "$tree"
cp "$bad" "$good"
for case in "${cases[@]}"; do
  [[ $work/good/$case.tumble -nt $good ]] || "$good" record "$case" -o "$work/good/$case.tumble" --quiet >/dev/null
done

named=0 seen=0
for name in "${names[@]}"; do
  [[ -s $list/$name.file ]] || fail "found no fault $name"
  put_back "$tree"
  plant "$name" "$tree"
  if ! (cd "$tree" && CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1 \
    cmake --build build/release --target tumble --parallel "$jobs") >"$work/log/$name.build" 2>&1; then
    printf '%-34s does not build: %s\n' "$name" "$work/log/$name.build"
    continue
  fi
  phases=$(<"$list/$name.phase") hit="" first="" differ=0
  for case in "${cases[@]}"; do
    answer=$(zoom "$case")
    [[ -n $answer ]] || continue
    differ=$((differ + 1))
    [[ -n $first ]] || first=${answer#*|}
    [[ -n $hit || ", $phases, " != *", ${answer%%|*}, "* ]] || hit=${answer#*|}
  done
  put_back "$tree"
  if ((differ == 0)); then
    printf '%-34s moves nothing in these sessions\n' "$name"
    continue
  fi
  seen=$((seen + 1))
  [[ -z $hit ]] || named=$((named + 1))
  printf '%-34s %s  planted %s:%s  %s\n' "$name" "$([[ -n $hit ]] && echo named || echo MISSED)" "$(<"$list/$name.file")" \
    "$(line_of "$name")" "${hit:-$first}"
done
printf 'zoom of two builds named the phase and a statement of it for %d of %d faults\n' "$named" "$seen"
((seen > 0 && 10 * named >= 9 * seen))
