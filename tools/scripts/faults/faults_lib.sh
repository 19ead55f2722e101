#!/usr/bin/env bash
# Reading faults and planting them; sourced by tools/scripts/faults/faults.sh. Needs $work (kept from run to run) and $list (of this
# run only).
# shellcheck disable=SC2154
set -euo pipefail

fail() {
  printf 'faults: %s\n' "$*" >&2
  exit 1
}

# tests/faults/*.faults into $list: NAME.file, .predicted, .why, .phase, .elsewhere, .was, .is, .cases; their names into
# fault_names. The format is in docs/faults.md.
read_faults() {
  local source line name="" part="" text="" cases=""
  fault_names=()
  for source in tests/faults/*.faults; do
    while IFS= read -r line || [[ -n $line ]]; do
      if [[ -n $part ]]; then
        case $line in
          "--- "*)
            printf '%s' "${text%$'\n'}" >"$list/$name.$part"
            text=""
            part=${line#--- }
            [[ $part != end ]] || part=""
            ;;
          *) text+=$line$'\n' ;;
        esac
        continue
      fi
      case $line in
        "fault "*)
          name=${line#fault }
          [[ ! -e $list/$name.cases ]] || fail "$source: fault \"$name\" exists twice"
          fault_names+=("$name")
          printf '%s' "$cases" >"$list/$name.cases"
          ;;
        "file "* | "predicted "* | "why "* | "phase "* | "elsewhere "*)
          printf '%s' "${line#* }" >"$list/$name.${line%% *}"
          ;;
        "cases "*) cases=${line#cases } ;;
        "--- was") part=was ;;
        "" | "#"*) ;;
        *) fail "$source: found \"$line\", wanted fault, file, predicted, why, phase, elsewhere, cases or --- was" ;;
      esac
    done <"$source"
    [[ -z $part ]] || fail "$source: fault \"$name\": found no \"--- end\""
  done
}

# Those that lie in a phase of src, in the order of tests/faults.
faults_in_phases() {
  local name
  for name in "${fault_names[@]}"; do
    [[ -s $list/$name.phase && $(<"$list/$name.phase") != start && $(<"$list/$name.file") == src/* ]] || continue
    printf '%s\n' "$name"
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
      [[ -s $list/$name.$part || ($part == is && -e $list/$name.is) ]] || fail "fault \"$name\": found no \"$part\""
    done
    file=$(<"$list/$name.file")
    [[ -f $file ]] || fail "fault \"$name\": found no file $file"
    times=$(occurrences "$file" "$(<"$list/$name.was")")
    if ((times != 1)); then
      printf 'faults: "%s" no longer applies: its text occurs %d times in %s, wanted once; give it the text of today:\n%s\n' \
        "$name" "$times" "$file" "$(<"$list/$name.was")" >&2
      bad=1
    fi
  done
  return "$bad"
}

# What a row depends on, besides the tree: the mistake and the cases that look for it.
key_of() { # name
  cat "$list/$1.file" "$list/$1.was" "$list/$1.is" "$list/$1.cases" | sha256sum | cut -c 1-16
}

# A copy of what the build and the suite need, kept from run to run: only what changed is copied, and so rebuilt. Each file
# is compiled by itself, since a fault changes one.
make_tree() { # tree
  local tree=$1 file
  local parts=(CMakeLists.txt CMakePresets.json LICENSE README.md cmake schema src replay golden tools tests bench examples python)
  mkdir -p "$tree"
  find "${parts[@]}" -type f | sort >"$tree/.files"
  { (cd "$tree" && find "${parts[@]}" -type f 2>/dev/null) || true; } | sort | comm -13 "$tree/.files" - |
    while read -r file; do rm "$tree/$file"; done
  while read -r file; do
    cmp -s "$file" "$tree/$file" && continue
    mkdir -p "$tree/$(dirname "$file")"
    cp "$file" "$tree/$file"
  done <"$tree/.files"
  rm -f "$tree/.planted" "$tree/.original"
  (cd "$tree" && export CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1 &&
    cmake --preset release -DTUMBLE_UNITY=OFF && cmake --build build/release --target "${faults_target:-tumble}" --parallel "$jobs") \
    >"$tree/.build" 2>&1 || fail "$tree does not build without a fault: see $tree/.build"
}

# The tree's own copy is put back, so that the sources may be edited while faults run.
put_back() { # tree
  [[ -f $1/.planted ]] || return 0
  cp "$1/.original" "$1/$(<"$1/.planted")"
  rm "$1/.planted" "$1/.original"
}

plant() { # name tree
  local file content was
  file=$(<"$list/$1.file")
  cp "$2/$file" "$2/.original"
  printf '%s' "$file" >"$2/.planted"
  content=$(cat "$2/$file"; printf x)
  was=$(<"$list/$1.was")
  content=${content%%"$was"*}$(<"$list/$1.is")${content#*"$was"}
  printf '%s' "${content%x}" >"$2/$file"
}

export -f fail key_of put_back plant
