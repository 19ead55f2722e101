#!/usr/bin/env bash
# What check and replay say about a fault, and the table of it; sourced by tools/scripts/faults/faults.sh. Needs $work and $list.
# shellcheck disable=SC2154
set -euo pipefail

# Suites that must fail, for what only the exit status of a check can show.
make_probes() { # folder
  local probe
  rm -rf "$1"
  mkdir -p "$1/empty/cases"
  for probe in bound missing stray null; do
    mkdir -p "$1/$probe/cases"
    cp -r golden/cases/bounce "$1/$probe/cases/"
  done
  : >"$1/stray/cases/bounce/notes.txt"
  rm "$1/missing/cases/bounce/expected.tumble"
  sed -i '0,/^max = .*/s//max = -1/' "$1/bound/cases/bounce/metrics.toml"
  printf '\n[[metric]]\nname = "column_spread"\nmax = 1.0\nwhy = "null: there is no grid"\n' \
    >>"$1/null/cases/bounce/metrics.toml"
}

# The verdict words of a report: exact (bits moved), image, symmetry, energy, stacking, freezing, format, suite, stopped.
# shellcheck disable=SC2089
words_of_report='
  def word: if test("its process|phase ") then "stopped"
            elif test("damage|torn|golden|log|hash|codec|chunk|footer|index") then "format" else "suite" end;
  [ (.cases[] | select(.verdicts.exact.outcome == "fail") | "exact"),
    (.cases[] | select(.verdicts.image.outcome == "fail") | "image"),
    (.cases[].metrics[] | select(.pass | not)
      | if .name == "frozen_fraction" or .name == "rest_time" then "freezing" else .group end),
    (.cases[].problems[] | word), (.problems[] | "suite"),
    (.canaries[] | select(.asked and (.caught | not)) | .about // "suite") ] | unique | join(", ")'
# shellcheck disable=SC2090  # it is given to jq as it stands
export words_of_report

# The cases whose names match one of the patterns; those called by their full name even if they take long.
matching_cases() { # patterns
  local name pattern
  set -f
  for pattern in $1; do
    if [[ $pattern != *"*"* ]]; then
      printf '%s\n' "$pattern"
      continue
    fi
    # shellcheck disable=SC2053  # a pattern is meant
    while read -r name; do [[ $name != $pattern ]] || printf '%s\n' "$name"; done <"$work/cases"
  done | sort -u
  set +f
}

# Checks the tree with its own program; prints what was found. What is not seen reads "missed".
judge_build() { # program tree report patterns
  local status=0 found="" probe
  rm -rf "$3"
  mkdir -p "$3"
  mapfile -t cases < <(matching_cases "${4:-*}")
  "$1" check --suite "$2/golden" --report "$3" --jobs 4 --timeout 120 "${cases[@]}" >"$3/output" 2>&1 || status=$?
  printf -- '-' >"$3/seen"
  if [[ -f $3/report.json ]]; then
    found=$(jq -r "$words_of_report" "$3/report.json") || found=suite
    jq -r '"\(.failed_cases) of \(.cases | length)"' "$3/report.json" >"$3/seen"
    rm -rf "$3/cases"
  fi
  if ((status != 0)); then
    printf '%s' "${found:-suite}"
    return
  fi
  [[ -z $found ]] || found=suite  # something failed and the exit status, which is what a build machine reads, says no
  for probe in bound:1 missing:1 stray:1 null:1 empty:2; do
    status=0
    "$1" check --suite "$work/probes/${probe%:*}" --report "$3/probe" >/dev/null 2>&1 || status=$?
    ((status == ${probe#*:})) || found=suite
  done
  printf '%s' "${found:-missed}"
}

# Logs of the tree without a fault.
record_logs() { # program case...
  local name program=$1
  shift
  rm -rf "$work/logs"
  mkdir -p "$work/logs"
  for name in "$@"; do
    "$program" record "$name" -o "$work/logs/$name.tumble" >/dev/null || fail "cannot record $name"
  done
}

# The phases that a replay of those logs names, and by how many: "find_planes 7, integrate 1".
phases_named() { # program folder
  # shellcheck disable=SC2016  # the shell that xargs starts is to expand it
  printf '%s\n' "$work"/logs/*.tumble | xargs -P 4 -n 1 bash -c \
    'timeout 60 "$0" replay "$1" --json 2>/dev/null | jq -r ".first.phase // empty" 2>/dev/null || true' "$1" \
    >"$2/phases"
  sort "$2/phases" | uniq -c | sort -k 1,1nr -k 2 | awk '{ printf "%s%s %d", (NR > 1 ? ", " : ""), $2, $1 }'
}

# "energy, stacking" holds if both were found; "exact" only if nothing but bits and their pictures moved.
as_predicted() { # predicted found
  local word
  [[ $1 != exact ]] || { [[ $2 == exact || $2 == "exact, image" ]]; return; }
  for word in ${1//, / }; do
    [[ ", $2, " == *", $word, "* ]] || return 1
  done
}

# Whether replay named the phase (or one of several that share the code): "yes" in every log that differs, "mostly" in
# more than half of them, "no", or "-" where a fault lies in no phase.
names_phase() { # name phases
  local phase count right=0 all=0
  [[ -s $list/$1.phase ]] || { printf -- '-'; return; }
  while read -r phase count; do
    all=$((all + count))
    [[ ", $(<"$list/$1.phase"), " != *", $phase, "* ]] || right=$((right + count))
  done < <(printf '%s\n' "${2//, /$'\n'}" | grep .)
  if ((all == 0 || 2 * right <= all)); then printf no; elif ((right < all)); then printf mostly; else printf yes; fi
}

# The row of a fault, if it was run as it is now.
row_of() { # name
  local key row
  [[ -f $work/rows/$1 ]] || return 1
  IFS='|' read -r key row <"$work/rows/$1"
  [[ $key == "$(key_of "$1")" ]] || return 1
  printf '%s\n' "$row"
}

# As the author said: the verdict, and that replay names the phase unless "elsewhere" says why it cannot.
row_holds() { # name
  local found seen named seconds
  IFS='|' read -r found seen named seconds < <(row_of "$1") || return 1
  as_predicted "$(<"$list/$1.predicted")" "$found" || return 1
  [[ $(names_phase "$1" "$named") != no || -s $list/$1.elsewhere ]]
}

print_row() { # name
  local found seen named seconds mark=""
  IFS='|' read -r found seen named seconds < <(row_of "$1") ||
    { printf '%-36s was not run, or changed since\n' "$1"; return; }
  row_holds "$1" || mark="   <-- not as predicted"
  printf '%-36s %s: %s (%s, %s s) %s%s\n' "$1" "$(<"$list/$1.predicted")" "$found" "$seen" "$seconds" \
    "${named:+[$(names_phase "$1" "$named"): $named]}" "$mark"
}

# What must be so before a fault proves anything: without one, the check passes.
check_control() {
  local found
  found=$(judge_build "$work/tree0/build/release/tools/tumble" "$work/tree0" "$work/report/control")
  [[ $found == missed ]] || fail "the tree fails its check without any fault ($found): see $work/report/control"
  found=$(phases_named "$work/tree0/build/release/tools/tumble" "$work/report/control")
  [[ -z $found ]] || fail "the tree does not replay its own logs ($found)"
}

table_rows() {
  local name found seen named seconds
  printf '| fault | file | predicted | found | cases | replay names | s |\n|---|---|---|---|---|---|---|\n'
  for name in "${fault_names[@]}"; do
    IFS='|' read -r found seen named seconds < <(row_of "$name") ||
      found="not run" seen="" named="" seconds=""
    [[ $found == "not run" ]] || row_holds "$name" || found+=" (**not as predicted**)"
    # shellcheck disable=SC2016  # backquotes of Markdown
    printf '| `%s` | `%s` | %s | %s | %s | %s | %s |\n' "$name" "$(<"$list/$name.file")" "$(<"$list/$name.predicted")" \
      "$found" "$seen" "$named" "$seconds"
  done
}

# What replay said of those faults that lie in a phase.
phase_rows() {
  local name found seen named seconds names yes=0 mostly=0 all=0 others=""
  for name in "${fault_names[@]}"; do
    [[ -s $list/$name.phase ]] || continue
    IFS='|' read -r found seen named seconds < <(row_of "$name") || continue
    all=$((all + 1))
    names=$(names_phase "$name" "$named")
    case $names in
      yes) yes=$((yes + 1)); continue ;;
      mostly) mostly=$((mostly + 1)) ;;
    esac
    others+="- \`$name\` lies in \`$(<"$list/$name.phase")\`; named: ${named:-none}"
    [[ ! -s $list/$name.elsewhere ]] || others+=": $(<"$list/$name.elsewhere")"
    others+=$'.\n'
  done
  # shellcheck disable=SC2016  # backquotes of Markdown
  printf 'Of %d faults that lie in a phase, `replay` names it for %d: for %d in every log that differs, for %d in most. ' \
    "$all" $((yes + mostly)) "$yes" "$mostly"
  printf 'All that some log names another way:\n\n%s' "$others"
}

write_table() {
  table_rows >"$work/table"
  { phase_rows; printf '\n'; } >"$work/phases"
  awk -v table="$work/table" -v phases="$work/phases" '
    function take(file, line) { print; while ((getline line < file) > 0) print line; skip = 1 }
    /<!-- table -->/ { take(table) }
    /<!-- phases -->/ { take(phases) }
    /<!-- end -->/ { skip = 0 }
    !skip { print }' docs/faults.md >"$work/faults.md"
  cp "$work/faults.md" docs/faults.md
}

# The unchanged tree, built otherwise. Without optimisation a step takes seventy times as long, so few cases.
rebuild_all() { # build..., all if none
  local row name compiler flags cases found bad=0
  mkdir -p "$work/report"
  make_probes "$work/probes"
  cases_to_run >"$work/cases"
  for row in "gcc-O0|g++|-O0|bounce friction_with size_ratio stacks tower layered_images_ties layered_inputs layered_leaning" \
    "gcc-O2-native|g++|-O2 -march=native|*" "gcc-O3-v3|g++|-O3 -march=x86-64-v3|*" "clang-O2|clang++|-O2|*" \
    "clang-O3-v3|clang++|-O3 -march=x86-64-v3|*"; do
    IFS='|' read -r name compiler flags cases <<<"$row"
    (($# == 0)) || [[ " $* " == *" $name "* ]] || continue
    if ! command -v "$compiler" >/dev/null; then
      printf '%-16s %s is not installed\n' "$name" "$compiler"
      continue
    fi
    (export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
      cmake -B "$work/$name" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None \
        -DCMAKE_CXX_FLAGS="$flags" && cmake --build "$work/$name" --target tumble --parallel "$jobs") \
      >"$work/$name.build" 2>&1 || fail "$name does not build: see $work/$name.build"
    found=$(judge_build "$work/$name/tools/tumble" "$PWD" "$work/report/$name" "$cases")
    [[ $found != missed ]] || found="passed"
    printf '%-16s %-30s %-8s %s cases failed\n' "$name" "$compiler $flags" "$found" "$(<"$work/report/$name/seen")"
    [[ $found == passed ]] || bad=1
  done
  return "$bad"
}

export -f matching_cases judge_build phases_named as_predicted names_phase row_of row_holds print_row
