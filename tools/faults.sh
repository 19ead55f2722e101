#!/usr/bin/env bash
# Plants one small mistake after the other in a copy of the tree, builds the program there, runs its `tumble check`, and
# compares what the check says with what the author of the mistake predicted: docs/faults.md.
# Usage: tools/faults.sh [--all-cases] [--jobs N] [--write] [NAME...]
#        tools/faults.sh --texts      only: does every fault still apply? Fast, builds nothing (part of the tests)
#        tools/faults.sh --list       names, files and predictions
#        tools/faults.sh --rebuilds   no fault, other compilers and flags: every check must pass
#   --all-cases   also the cases that take long
#   --write       puts the table into docs/faults.md; rows of faults that were not run now are those of the run before
# Exit status: 0 every fault was caught as predicted; 1 one was not, or no longer applies; 2 bad usage.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tools/faults_lib.sh

slow_cases=(layered_pile_4096 layered_tower_40 layered_tower_20 layered_wall layered_brick_wall pile)
jobs=2 write=false mode=run names=()
while (($#)); do
  case "$1" in
    --all-cases) slow_cases=(); shift ;;
    --jobs) jobs=${2:?--jobs needs a number}; shift 2 ;;
    --write) write=true; shift ;;
    --texts | --list | --rebuilds) mode=${1#--}; shift ;;
    -*) sed -n '3,9s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
    *) names+=("$1"); shift ;;
  esac
done

work=$PWD/build/faults
export work
mkdir -p "$work"

cases_to_run() { # all of the suite but the slow ones
  local name
  for path in golden/cases/*/; do
    name=$(basename "$path")
    [[ " ${slow_cases[*]} " == *" $name "* ]] || printf '%s\n' "$name"
  done
}

# Runs in a process of its own, in the tree of its slot.
run_fault() { # name
  local name=$1 tree=$work/tree$SLOT begin=$SECONDS found status=ok seen=""
  local file; file=$(<"$work/list/$name.file")
  put_back "$tree"
  plant "$name" "$tree"
  if ! (cd "$tree" && CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1 cmake --build build/release --target tumble --parallel 1) \
      >"$work/log/$name.build" 2>&1; then
    found="does not build"
  else
    found=$(judge_build "$tree/build/release/tools/tumble" "$tree" "$work/report/$name" "$(<"$work/list/$name.cases")")
    seen=$(<"$work/report/$name/seen")
  fi
  as_predicted "$(<"$work/list/$name.predicted")" "$found" || status=WRONG
  printf '%s|%s|%s|%s|%s|%s|%s\n' "$name" "$file" "$(<"$work/list/$name.predicted")" "$found" "$seen" \
    $((SECONDS - begin)) "$status" | tee "$work/rows/$name" | print_row
}

case $mode in
  texts)
    read_faults
    check_texts && printf 'faults: %d apply\n' "${#fault_names[@]}"
    ;;
  list)
    read_faults
    for name in "${fault_names[@]}"; do
      printf '%-36s %-38s %s\n' "$name" "$(<"$work/list/$name.file")" "$(<"$work/list/$name.predicted")"
    done
    ;;
  rebuilds)
    rebuild_all
    ;;
  run)
    command -v jq >/dev/null || fail "jq is missing; run tools/setup.sh"
    read_faults
    check_texts
    ((${#names[@]})) || names=("${fault_names[@]}")
    for name in "${names[@]}"; do
      [[ -f $work/list/$name.file ]] || fail "no fault \"$name\"; tools/faults.sh --list names them"
    done
    mkdir -p "$work/log" "$work/rows" "$work/report"
    for name in "${names[@]}"; do rm -f "$work/rows/$name"; done
    cases_to_run >"$work/cases"
    make_probes "$work/probes"
    for ((slot = 0; slot < jobs; ++slot)); do make_tree "$work/tree$slot"; done
    check_control
    export -f run_fault
    begin=$SECONDS
    printf '%-36s %-26s %-34s %s\n' fault predicted found "cases that failed, seconds"
    printf '%s\n' "${names[@]}" | xargs -P "$jobs" -n 1 --process-slot-var=SLOT bash -c 'run_fault "$1"' run_fault
    wrong=0
    for name in "${names[@]}"; do grep -qs '|ok$' "$work/rows/$name" || wrong=$((wrong + 1)); done
    "$write" && write_table
    printf 'faults: %d planted, %d not caught as predicted, %d s\n' "${#names[@]}" "$wrong" $((SECONDS - begin))
    ((wrong == 0))
    ;;
esac
