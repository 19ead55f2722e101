# What tools/faults.sh is made of: reading faults, trees, judging, tables. Sourced; needs $work.

fail() {
  printf 'faults: %s\n' "$*" >&2
  exit 1
}

# tests/faults/*.faults into $work/list: NAME.file, .predicted, .why, .was, .is, .cases; their names into fault_names.
read_faults() {
  local source line name="" part="" text="" cases=""
  fault_names=()
  rm -rf "$work/list"
  mkdir -p "$work/list"
  for source in tests/faults/*.faults; do
    while IFS= read -r line || [[ -n $line ]]; do
      if [[ -n $part && $line == "--- "* ]]; then
        printf '%s' "${text%$'\n'}" >"$work/list/$name.$part"
        text="" part=""
      fi
      case $line in
        "fault "*)
          name=${line#fault }
          [[ ! -e $work/list/$name.file ]] || fail "$source: fault \"$name\" exists twice"
          fault_names+=("$name")
          printf '%s' "$cases" >"$work/list/$name.cases"
          ;;
        "file "*) [[ -n $part ]] || printf '%s' "${line#file }" >"$work/list/$name.file" ;;
        "predicted "*) [[ -n $part ]] || printf '%s' "${line#predicted }" >"$work/list/$name.predicted" ;;
        "why "*) [[ -n $part ]] || printf '%s' "${line#why }" >"$work/list/$name.why" ;;
        "cases "*) [[ -n $part ]] || cases=${line#cases } ;;
        "--- was") part=was ;;
        "--- is") part=is ;;
        "--- end") ;;
        *) ;;
      esac
      [[ -z $part || $line == "--- "* ]] || text+=$line$'\n'
    done <"$source"
  done
}

# How often a text occurs in a file.
occurrences() { # file text
  local rest count=0
  rest=$(<"$1")
  while [[ $rest == *"$2"* ]]; do
    rest=${rest#*"$2"}
    count=$((count + 1))
  done
  printf '%d' "$count"
}

check_texts() {
  local name part file times bad=0
  for name in "${fault_names[@]}"; do
    for part in file predicted why was is; do
      [[ -s $work/list/$name.$part || ($part == is && -e $work/list/$name.is) ]] ||
        fail "fault \"$name\": found no \"$part\""
    done
    file=$(<"$work/list/$name.file")
    [[ -f $file ]] || fail "fault \"$name\": found no file $file"
    times=$(occurrences "$file" "$(<"$work/list/$name.was")")
    if ((times != 1)); then
      printf 'faults: "%s" no longer applies: its text occurs %d times in %s, wanted once; give it the text of today:\n%s\n' \
        "$name" "$times" "$file" "$(<"$work/list/$name.was")" >&2
      bad=1
    fi
  done
  return "$bad"
}

# A copy of what the build and the suite need, kept from run to run: only what changed is copied, and so rebuilt.
make_tree() { # tree
  local tree=$1 file
  mkdir -p "$tree"
  local parts=(CMakeLists.txt CMakePresets.json cmake schema src replay golden tools tests bench)
  find "${parts[@]}" -type f | sort >"$tree/.files"
  { (cd "$tree" && find "${parts[@]}" -type f 2>/dev/null) || true; } | sort | comm -13 "$tree/.files" - |
    while read -r file; do rm "$tree/$file"; done
  while read -r file; do
    cmp -s "$file" "$tree/$file" && continue
    mkdir -p "$tree/$(dirname "$file")"
    cp "$file" "$tree/$file"
  done <"$tree/.files"
  rm -f "$tree/.planted"
  (cd "$tree" && export CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1 &&
    cmake --preset release && cmake --build build/release --target tumble --parallel 1) \
    >"$tree/.build" 2>&1 || fail "$tree does not build without a fault: see $tree/.build"
}

put_back() { # tree
  [[ -f $1/.planted ]] || return 0
  cp "$(<"$1/.planted")" "$1/$(<"$1/.planted")"
  rm "$1/.planted"
}

plant() { # name tree
  local file content was
  file=$(<"$work/list/$1.file")
  content=$(cat "$file"; printf x)
  was=$(<"$work/list/$1.was")
  printf '%s' "$file" >"$2/.planted"
  content=${content%%"$was"*}$(<"$work/list/$1.is")${content#*"$was"}
  printf '%s' "${content%x}" >"$2/$file"
}

# Suites that must fail, for what only the exit status of a check can show.
make_probes() { # folder
  rm -rf "$1"
  mkdir -p "$1/bound/cases" "$1/empty/cases" "$1/missing/cases"
  cp -r golden/cases/bounce "$1/bound/cases/"
  cp -r golden/cases/bounce "$1/missing/cases/"
  rm "$1/missing/cases/bounce/expected.tumble"
  sed -i '0,/^max = .*/s//max = -1/' "$1/bound/cases/bounce/metrics.toml"
}

# The verdict words of a report: exact (bits moved), image, symmetry, energy, stacking, freezing, format, suite, stopped.
words_of_report='
  def word: if test("damage|torn|golden|log|hash|codec|chunk|footer|index") then "format"
            elif test("phase ") then "stopped" else "suite" end;
  [ (.cases[] | select(.verdicts.exact.outcome == "fail") | "exact"),
    (.cases[] | select(.verdicts.image.outcome == "fail") | "image"),
    (.cases[].metrics[] | select(.pass | not)
      | if .name == "frozen_fraction" or .name == "rest_time" then "freezing" else .group end),
    (.cases[].problems[] | word), (.problems[] | "suite"),
    (.canaries[] | select(.caught | not) | .about // "suite") ] | unique | join(", ")'

# The cases whose names match one of the patterns.
matching_cases() { # patterns
  local name pattern
  set -f
  while read -r name; do
    # shellcheck disable=SC2053  # a pattern is meant
    for pattern in $1; do [[ $name == $pattern ]] && printf '%s\n' "$name" && break; done
  done <"$work/cases" || true
  set +f
}

# Checks the tree with its own program; prints what was found. What is not seen reads "missed".
judge_build() { # program tree report patterns
  local status=0 found="" probe
  rm -rf "$3"
  mkdir -p "$3"
  mapfile -t cases < <(matching_cases "${4:-*}")
  nice "$1" check --suite "$2/golden" --report "$3" --jobs 1 --timeout 120 "${cases[@]}" >"$3/output" 2>&1 || status=$?
  : >"$3/seen"
  if [[ -f $3/report.json ]]; then
    found=$(jq -r "$words_of_report" "$3/report.json") || found=suite
    jq -r '"\(.failed_cases) of \(.cases | length)"' "$3/report.json" >"$3/seen"
    rm -rf "$3/cases"
  fi
  ((status == 0 || status == 1)) || [[ -n $found ]] || found=suite
  for probe in bound:1 missing:1 empty:2; do
    status=0
    "$1" check --suite "$work/probes/${probe%:*}" --report "$3/probe" >/dev/null 2>&1 || status=$?
    ((status == ${probe#*:})) || [[ $found == *suite* ]] || found+=${found:+, }suite
  done
  printf '%s' "${found:-missed}"
}

# "energy or stacking" holds if one of them was found; "exact" only if nothing but bits and their pictures moved.
as_predicted() { # predicted found
  local word
  for word in ${1// or / }; do
    if [[ $word == exact ]]; then
      [[ $2 == exact || $2 == "exact, image" ]] && return 0
    else
      [[ ", $2, " == *", $word, "* ]] && return 0
    fi
  done
  return 1
}

# What must be so before a fault proves anything: without one, the check passes.
check_control() {
  local found
  found=$(judge_build "$work/tree0/build/release/tools/tumble" "$work/tree0" "$work/report/control")
  [[ $found == missed ]] || fail "the tree fails its check without any fault ($found): see $work/report/control"
}

print_row() {
  awk -F'|' '{ printf "%-36s %-26s %-34s %s, %s s%s\n", $1, $3, $4, $5, $6, $7 == "ok" ? "" : "   <-- not as predicted"
               fflush() }'
}

write_table() {
  local name table=$work/table
  {
    printf '| fault | file | predicted | found | cases | s |\n|---|---|---|---|---|---|\n'
    for name in "${fault_names[@]}"; do
      [[ -f $work/rows/$name ]] || fail "\"$name\" was never run, so there is no row for docs/faults.md"
      awk -F'|' '{ printf "| `%s` | `%s` | %s | %s%s | %s | %s |\n", $1, $2, $3, $4, $7 == "ok" ? "" : " (**not as predicted**)", $5, $6 }' \
        "$work/rows/$name"
    done
  } >"$table"
  awk -v table="$table" '
    /<!-- table -->/ { print; while ((getline line < table) > 0) print line; skip = 1 }
    /<!-- end -->/ { skip = 0 }
    !skip && !/<!-- table -->/ { print }' docs/faults.md >"$work/faults.md"
  cp "$work/faults.md" docs/faults.md
}

# The unchanged tree, built otherwise. Without optimisation a step takes seventy times as long, so few cases.
rebuild_all() {
  local row name compiler flags which found bad=0
  mkdir -p "$work/report"
  make_probes "$work/probes"
  for row in "gcc-O0|g++|-O0|few" "gcc-O2-native|g++|-O2 -march=native|all" \
    "gcc-O3-v3|g++|-O3 -march=x86-64-v3|all" "clang-16-O2|clang++-16|-O2|all" "clang-19-O3|clang++-19|-O3|all"; do
    IFS='|' read -r name compiler flags which <<<"$row"
    if ! command -v "$compiler" >/dev/null; then
      printf '%-16s %s is not installed\n' "$name" "$compiler"
      continue
    fi
    cases_to_run >"$work/cases"
    [[ $which == all ]] || printf '%s\n' bounce tower size_ratio stacks >"$work/cases"
    (export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
      cmake -B "$work/$name" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None \
        -DCMAKE_CXX_FLAGS="$flags" && cmake --build "$work/$name" --target tumble --parallel "$jobs") \
      >"$work/$name.build" 2>&1 || fail "$name does not build: see $work/$name.build"
    found=$(judge_build "$work/$name/tools/tumble" "$PWD" "$work/report/$name")
    [[ $found != missed ]] || found="passed"
    printf '%-16s %-30s %-8s %s cases failed\n' "$name" "$compiler $flags" "$found" "$(<"$work/report/$name/seen")"
    [[ $found == passed ]] || bad=1
  done
  return "$bad"
}

export -f fail put_back plant matching_cases judge_build as_predicted print_row
export words_of_report
