#!/usr/bin/env bash
# Does `tumble blame` find the phase of a planted mistake? Plants faults of tests/faults one after the other in a copy of
# the tree, records cases with and without the fault, takes the first value of a body that differs (`tumble diff`), and
# asks the program with the fault for five answers about it (`tumble blame --back 5`). Only one log is given to blame: it
# knows neither the other log nor its phase hashes. A fault counts as named if, in more than half of the logs that
# differ, the phase of one of the five answers is the phase in which the fault lies: docs/blame.md.
# Usage: tools/scripts/faults/blame.sh [--of N] [--jobs N] [--rest] [NAME...]
#   --of N   N faults, spread evenly over those that lie in a phase, in the order of tests/faults; 30 unless given
#   --rest   only those not asked since the program changed last
# Exit status: 0 nine of ten were named; 1 fewer; 2 bad usage.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
# shellcheck source=tools/scripts/faults/faults_lib.sh
source tools/scripts/faults/faults_lib.sh

# Short, and together they run every phase: the logs that faults.sh replays.
mapfile -t log_cases < <(sed -n '/^log_cases=(/,/)$/p' tools/scripts/faults/faults.sh | tr -d '()' | sed 's/log_cases=//' | xargs -n 1)
answers=5 jobs=1 of=30 rest=false names=()
while (($#)); do
  case "$1" in
    --of) of=${2:?--of needs a number}; shift 2 ;;
    --jobs) jobs=${2:?--jobs needs a number}; shift 2 ;;
    --rest) rest=true; shift ;;
    -*) sed -n '2,11s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
    *) names+=("$1"); shift ;;
  esac
done
work=$PWD/build/faults/blame
list=$(mktemp -d)
trap 'rm -rf "$list"' EXIT
export work list answers
mkdir -p "$work/good" "$work/rows" "$work/log"

# Those that lie in a phase of src.
faults_in_phases() {
  local name
  for name in "${fault_names[@]}"; do
    [[ -s $list/$name.phase && $(<"$list/$name.phase") != start && $(<"$list/$name.file") == src/* ]] || continue
    printf '%s\n' "$name"
  done
}

# A row: name|phase|logs that differ|logs whose answers name the phase|case: phases of the answers; …
ask() { # name slot
  local name=$1 tree=$work/tree$2 program=$work/tree$2/build/release/tools/tumble
  local case first body field step phases phase differ=0 named=0 hit told=""
  put_back "$tree"
  plant "$name" "$tree"
  if ! (cd "$tree" && CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1 cmake --build build/release --target tumble --parallel 1) \
    >"$work/log/$name.build" 2>&1; then
    printf '%s|%s|0|0|does not build\n' "$name" "$(<"$list/$name.phase")" | tee "$work/rows/$name"
    return
  fi
  mkdir -p "$work/bad/$name"
  for case in "$work"/good/*.tumble; do
    case=$(basename "$case" .tumble)
    timeout 120 "$program" record "$case" -o "$work/bad/$name/$case.tumble" --quiet >/dev/null 2>&1 || true
    [[ -s $work/bad/$name/$case.tumble ]] || continue
    first=$("$work/tumble" diff "$work/good/$case.tumble" "$work/bad/$name/$case.tumble" --json 2>/dev/null |
      jq -r '(.effect // empty) | select(.body != null) | "\(.body) \(.field) \(.step)"' 2>/dev/null || true)
    if [[ -z $first ]]; then
      rm -f "$work/bad/$name/$case.tumble"
      continue
    fi
    read -r body field step <<<"$first"
    [[ $field != id ]] || continue
    phases=$(timeout 120 "$program" blame "$work/bad/$name/$case.tumble" --body "$body" --field "$field" --step "$step" \
      --back "$answers" --json 2>"$work/log/$name.$case" | jq -r '[.answers[].phase] | join(" ")' 2>/dev/null || true)
    differ=$((differ + 1))
    hit=no
    for phase in $phases; do
      [[ ", $(<"$list/$name.phase"), " != *", $phase, "* ]] || hit=yes
    done
    [[ $hit == no ]] || named=$((named + 1))
    told+="$case $step $body $field $hit: ${phases:-$(head -c 200 "$work/log/$name.$case")}; "
  done
  printf '%s|%s|%s|%s|%s\n' "$name" "$(<"$list/$name.phase")" "$differ" "$named" "$told" >"$work/rows/$name"
  printf '%-36s %-40s %s of %s logs\n' "$name" "$(<"$list/$name.phase")" "$named" "$differ"
}

command -v jq >/dev/null || fail "jq is missing; run tools/setup.sh --with faults"
read_faults
if ((${#names[@]} == 0)); then
  mapfile -t all < <(faults_in_phases)
  for ((k = 0; k < of; ++k)); do names+=("${all[k * ${#all[@]} / of]}"); done
fi
for ((slot = 0; slot < jobs; ++slot)); do make_tree "$work/tree$slot"; done
cmp -s "$work/tree0/build/release/tools/tumble" "$work/tumble" || cp "$work/tree0/build/release/tools/tumble" "$work/tumble"
for case in "${log_cases[@]}"; do
  [[ -s $work/good/$case.tumble ]] || "$work/tumble" record "$case" -o "$work/good/$case.tumble" --quiet >/dev/null
done
if "$rest"; then
  left=()
  for name in "${names[@]}"; do [[ $work/rows/$name -nt $work/tumble ]] || left+=("$name"); done
else
  left=("${names[@]}")
fi
export -f ask
# shellcheck disable=SC2016  # the shell that xargs starts is to expand it
((${#left[@]} == 0)) || printf '%s\n' "${left[@]}" |
  xargs -P "$jobs" -n 1 --process-slot-var=SLOT bash -c 'ask "$1" "$SLOT"' ask
named=0 seen=0
for name in "${names[@]}"; do
  IFS='|' read -r _ _ differ hits _ <"$work/rows/$name" || continue
  ((differ > 0)) || { printf '%s moves no value of these logs\n' "$name"; continue; }
  seen=$((seen + 1))
  ((2 * hits <= differ)) || named=$((named + 1))
done
printf 'blame names the phase of %d of %d faults within %d answers\n' "$named" "$seen" "$answers"
((10 * named >= 9 * seen))
