#!/usr/bin/env bash
# Plants one small mistake after the other in a copy of the tree, builds the program there, runs its `tumble check`, and
# compares what the check says with what the author of the mistake predicted; then lets `tumble replay` say of logs that
# were recorded without the mistake in which phase it lies: docs/faults.md.
# Usage: tools/scripts/faults/faults.sh [--all-cases] [--rest] [--jobs N] [--write] [NAME...]
#        tools/scripts/faults/faults.sh --texts      only: does every fault still apply? Fast, builds nothing (part of the tests)
#        tools/scripts/faults/faults.sh --list       names, files and predictions
#        tools/scripts/faults/faults.sh --table      judges what earlier runs found once more, and writes docs/faults.md
#        tools/scripts/faults/faults.sh --rebuilds [BUILD...]   no fault, other compilers and flags: every check must pass
#   --all-cases   also the cases that take long
#   --rest        only those that were not run yet, or changed since
#   --write       puts the table into docs/faults.md; rows of faults that were not run now are those of the run before
# Exit status: 0 every fault was caught as predicted; 1 one was not, or no longer applies; 2 bad usage.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
# shellcheck source=tools/scripts/faults/faults_lib.sh
source tools/scripts/faults/faults_lib.sh
# shellcheck source=tools/scripts/faults/faults_judge.sh
source tools/scripts/faults/faults_judge.sh

slow_cases=(brick_tower brick_wall layered_brick_wall layered_cabin layered_cabin_hit layered_grid layered_pile layered_pile_4096
  layered_tower_20 layered_tower_40 layered_wall pile pyramid thin_long tilted_grid)
# Whose logs are replayed: short, and together they run every phase.
log_cases=(bounce freeze_and_wake friction_with size_ratio stacks thesis_free_spin thesis_grid_coarse
  thesis_images_pile thesis_inputs thesis_overhang thesis_slide tower layered_bounce layered_bullets layered_chain_hit
  layered_free_hits layered_free_pass layered_free_spin layered_heavy_drop layered_images_grams
  layered_images_pile layered_images_wide layered_inputs layered_leaning layered_mass_graded layered_memory_of_ties layered_plates
  layered_ramp layered_size_ratio layered_sleep layered_slide layered_slope_loose layered_spinning_plates
  layered_still layered_support_removed layered_table layered_thin_plate layered_tower_5 thesis_images_lattice
  thesis_slope_rest_coarse)
jobs=2 write=false rest=false mode=run names=()
while (($#)); do
  case "$1" in
    --all-cases) slow_cases=(); shift ;;
    --jobs) jobs=${2:?--jobs needs a number}; shift 2 ;;
    --write) write=true; shift ;;
    --rest) rest=true; shift ;;
    --texts | --list | --table | --rebuilds) mode=${1#--}; shift ;;
    -*) sed -n '5,13s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
    *) names+=("$1"); shift ;;
  esac
done

work=$PWD/build/faults
[[ $mode != rebuilds ]] || work+=/rebuilds  # which may run beside faults
list=$(mktemp -d)
trap 'rm -rf "$list"' EXIT
export work list
mkdir -p "$work"

cases_to_run() { # all of the suite but the slow ones
  local name
  for path in golden/cases/*/; do
    name=$(basename "$path")
    [[ " ${slow_cases[*]} " == *" $name "* ]] || printf '%s\n' "$name"
  done
}

# In a process of its own, in the tree of its slot. Leaves a row: key|found|cases that failed|phases named|seconds.
run_fault() { # name slot
  local name=$1 tree=$work/tree$2 begin=$SECONDS found seen="" named=""
  local program=$tree/build/release/tools/tumble
  put_back "$tree"
  plant "$name" "$tree"
  if ! (cd "$tree" && CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1 \
    cmake --build build/release --target tumble --parallel 1) >"$work/log/$name.build" 2>&1; then
    found="does not build"
  else
    found=$(judge_build "$program" "$tree" "$work/report/$name" "$(<"$list/$name.cases")")
    seen=$(<"$work/report/$name/seen")
    [[ ! -s $list/$name.phase ]] || named=$(phases_named "$program" "$work/report/$name")
  fi
  printf '%s|%s|%s|%s|%s\n' "$(key_of "$name")" "$found" "$seen" "$named" $((SECONDS - begin)) >"$work/rows/$name"
  print_row "$name"
}

run_faults() {
  local name slot wrong=0 begin
  command -v jq >/dev/null || fail "jq is missing; run tools/setup.sh --with faults"
  check_texts
  for name in "${names[@]}"; do
    [[ -f $list/$name.file ]] || fail "no fault \"$name\"; tools/scripts/faults/faults.sh --list names them"
  done
  mkdir -p "$work/log" "$work/rows" "$work/report"
  for name in "${names[@]}"; do rm -f "$work/rows/$name"; done
  cases_to_run >"$work/cases"
  make_probes "$work/probes"
  for ((slot = 0; slot < jobs; ++slot)); do make_tree "$work/tree$slot"; done
  record_logs "$work/tree0/build/release/tools/tumble" "${log_cases[@]}"
  check_control
  export -f run_fault
  begin=$SECONDS
  # shellcheck disable=SC2016  # the shell that xargs starts is to expand it
  printf '%s\n' "${names[@]}" |
    xargs -P "$jobs" -n 1 --process-slot-var=SLOT bash -c 'run_fault "$1" "$SLOT"' run_fault
  for name in "${names[@]}"; do row_holds "$name" || wrong=$((wrong + 1)); done
  ! "$write" || write_table
  printf 'faults: %d planted, %d not as predicted, %d s\n' "${#names[@]}" "$wrong" $((SECONDS - begin))
  ((wrong == 0))
}

read_faults
((${#names[@]})) || [[ $mode == rebuilds ]] || names=("${fault_names[@]}")
! "$rest" || mapfile -t names < <(for name in "${names[@]}"; do row_of "$name" >/dev/null || printf '%s\n' "$name"; done)
case $mode in
  texts) check_texts && printf 'faults: %d apply\n' "${#fault_names[@]}" ;;
  list)
    for name in "${fault_names[@]}"; do
      printf '%-36s %-38s %s\n' "$name" "$(<"$list/$name.file")" "$(<"$list/$name.predicted")"
    done
    ;;
  table)
    for name in "${fault_names[@]}"; do print_row "$name"; done
    write_table
    ;;
  rebuilds) rebuild_all "${names[@]}" ;;
  run) run_faults ;;
esac
