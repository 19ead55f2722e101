#!/usr/bin/env bash
# Does blame name the phase of a planted mistake? Plants faults of tests/faults one after the other in a copy of the tree
# and builds tests/trial/blame.cc there: it takes sessions again that were recorded without the fault, up to the first
# value of a body that differs, and asks for five answers about that value. blame knows neither the other log nor its
# phase hashes. A fault counts as named if, in more than half of the sessions that differ, one of the five answers is the
# phase in which the fault lies: docs/blame.md.
# Usage: tools/scripts/faults/blame.sh [--of N] [--jobs N] [--rest] [NAME...]
#   --of N   N faults, spread evenly over those that lie in a phase, in the order of tests/faults; 30 unless given. In place
#            of one that moves no value of a body in these sessions stands the next of that order
#   --rest   only those not asked yet, or asked of another fault or by other sources of blame; an interrupted run goes on so
# Needs build/release/tools/tumble. Exit status: 0 nine of ten were named; 1 fewer; 2 bad usage.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
# shellcheck source=tools/scripts/faults/faults_lib.sh
source tools/scripts/faults/faults_lib.sh

# The logs that faults.sh replays: short, and together they run every phase.
mapfile -t log_cases < <(sed -n '/^log_cases=(/,/)$/p' tools/scripts/faults/faults.sh | tr -d '()' | sed 's/log_cases=//' | xargs -n 1)
jobs=1 of=30 rest=false names=() faults_target=blame_trial
while (($#)); do
  case "$1" in
    --of) of=${2:?--of needs a number}; shift 2 ;;
    --jobs) jobs=${2:?--jobs needs a number}; shift 2 ;;
    --rest) rest=true; shift ;;
    -*) sed -n '2,12s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
    *) names+=("$1"); shift ;;
  esac
done
work=$PWD/build/faults/blame
list=$(mktemp -d)
trap 'rm -rf "$list"' EXIT
export work list faults_target
mkdir -p "$work/good" "$work/rows" "$work/log"

# What a row depends on, besides the sessions: the fault and the blame of a tree that is asked about it.
blame_key() { # name tree
  printf '%s.%s' "$(key_of "$1")" "$(cat "$2"/replay/blame/* "$2/tests/trial/blame.cc" | sha256sum | cut -c 1-16)"
}

# Whether a row is of the fault and of the blame of today.
is_asked() { # name
  [[ -s $work/rows/$1 && $(head -n 1 "$work/rows/$1") == *"|$(blame_key "$1" .)" ]]
}

# Whether the answers of a line hold one of the phases of a fault.
names_one_of() { # phases line
  local phase
  for phase in ${2##*:}; do
    [[ ", $1, " != *", $phase, "* ]] || return 0
  done
  return 1
}

# Leaves a row: sessions that differ|sessions whose answers name the phase|key; then the lines of the trial.
ask() { # name slot
  rm -f "$work/rows/$1"
  local name=$1 tree=$work/tree$2 line phases differ=0 named=0
  phases=$(<"$list/$name.phase")
  put_back "$tree"
  plant "$name" "$tree"
  if ! (cd "$tree" && CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1 \
    cmake --build build/release --target blame_trial --parallel 1) >"$work/log/$name.build" 2>&1; then
    printf '%-36s does not build: %s\n' "$name" "$work/log/$name.build"
    return
  fi
  mkdir -p "$work/own$2"
  if ! timeout 600 "$tree/build/release/tests/blame_trial" "$work/own$2" "$work"/good/*.tumble \
    >"$work/log/$name" 2>"$work/log/$name.errors"; then
    printf '%-36s cannot be asked: %s\n' "$name" "$(<"$work/log/$name.errors")"
    return
  fi
  while read -r line; do
    [[ $line == *" body "* ]] || continue
    differ=$((differ + 1))
    ! names_one_of "$phases" "$line" || named=$((named + 1))
  done <"$work/log/$name"
  { printf '%s|%s|%s\n' "$differ" "$named" "$(blame_key "$name" "$tree")"; cat "$work/log/$name"; } >"$work/rows/$name"
  printf '%-36s %-44s %s of %s sessions\n' "$name" "$phases" "$named" "$differ"
}

read_faults
all=()
if ((${#names[@]} == 0)); then
  mapfile -t all < <(faults_in_phases)
  for ((k = 0; k < of; ++k)); do names+=("${all[k * ${#all[@]} / of]}"); done
fi
for case in "${log_cases[@]}"; do
  [[ -s $work/good/$case.tumble ]] || build/release/tools/tumble record "$case" -o "$work/good/$case.tumble" --quiet >/dev/null
done
for ((slot = 0; slot < jobs; ++slot)); do make_tree "$work/tree$slot"; done
export -f ask names_one_of blame_key

# Asks about those of the names that are to be asked about.
ask_all() { # name...
  local name left=()
  for name; do
    ! "$rest" || ! is_asked "$name" || continue
    left+=("$name")
  done
  # shellcheck disable=SC2016  # the shell that xargs starts is to expand it
  ((${#left[@]} == 0)) || printf '%s\n' "${left[@]}" |
    xargs -P "$jobs" -n 1 --process-slot-var=SLOT bash -c 'ask "$1" "$SLOT"' ask
}

# The fault behind this one in the order of tests/faults that is not asked about yet.
next_of() { # name
  local k behind=false
  for ((k = 0; k < 2 * ${#all[@]}; ++k)); do
    name=${all[k % ${#all[@]}]}
    if "$behind" && [[ " ${names[*]} " != *" $name "* ]]; then
      printf '%s' "$name"
      return
    fi
    [[ $name != "$1" ]] || behind=true
  done
}

ask_all "${names[@]}"
named=0 seen=0 missed=()
for ((k = 0; k < ${#names[@]}; ++k)); do
  name=${names[k]}
  [[ -s $work/rows/$name ]] || continue
  IFS='|' read -r differ hits _ <"$work/rows/$name"
  if ((differ == 0)); then
    instead=$(next_of "$name")
    printf '%s moves no value of these sessions%s\n' "$name" "${instead:+: $instead instead}"
    [[ -n $instead ]] || continue
    names+=("$instead")
    ask_all "$instead"
    continue
  fi
  seen=$((seen + 1))
  if ((2 * hits > differ)); then named=$((named + 1)); else missed+=("$name"); fi
done
((${#missed[@]} == 0)) || printf 'not named: %s\n' "${missed[*]}"
printf 'blame names the phase of %d of %d faults within five answers\n' "$named" "$seen"
((seen > 0 && 10 * named >= 9 * seen))
