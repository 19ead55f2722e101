#!/usr/bin/env bash
# Layout and habits of the code, judged by clang-format and clang-tidy. Part of the tests; prints what to change.
# Usage: tools/lint.sh format         layout of every .h and .cc (.clang-format)
#        tools/lint.sh fix            puts the layout right
#        tools/lint.sh tidy [BUILD]   the checks of .clang-tidy, with the flags of a build folder (build/release)
# A file that was found clean is not looked at again until it, a header it includes or the checks change; what is
# remembered lies in TUMBLE_LINT_CACHE (by default under ~/.cache), and tells nothing that cannot be found again.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/.."

fail() {
  printf 'lint: %s\n' "$*" >&2
  exit 2
}
need() {
  command -v "$1" >/dev/null || fail "$1 is missing; run tools/setup.sh"
}
sources() { # ending...
  for ending in "$@"; do
    find src replay golden tools tests bench -name "*.$ending" -type f
  done | sort
}

# "file key" for every .cc: the key changes with the file, what it includes, directly or not, and the checks.
keys() {
  local common
  common=$({ clang-tidy --version; cat .clang-tidy cmake/* schema/*; } | sha256sum)
  sources cc h | xargs sha256sum | sed 's/^\([0-9a-f]*\)  /\1 /' >"$work/hashes"
  sources cc h | xargs grep -H '^#include "' | sed -E 's/^([^:]+):#include "([^"]+)".*/\1 \2/' >"$work/includes" || true
  awk -v common="${common%% *}" '
    FILENAME ~ /hashes$/ { hash[$2] = $1; next }
    { included[$1] = included[$1] " " $2 }
    function visit(file, list, i, n) {
      if (file in seen) return
      seen[file] = 1
      text = text " " hash[file]
      n = split(included[file], list, " ")
      for (i = 1; i <= n; i++) visit(list[i])
    }
    END {
      for (file in hash) {
        if (file !~ /\.cc$/) continue
        split("", seen); text = common
        visit(file)
        print file, text
      }
    }' "$work/hashes" "$work/includes" | sort |
    while read -r file text; do
      printf '%s %s\n' "$file" "$(sha256sum <<<"$text" | cut -d ' ' -f 1)"
    done
}

# Runs in a process of its own for each file that is not known to be clean.
tidy_one() { # database cache file key
  local output
  if output=$(clang-tidy -p "$1" --quiet --extra-arg=-Wno-unknown-warning-option "$3" 2>&1); then
    : >"$2/$4"
  else
    printf '%s\n' "$output" | grep -vE '^[0-9]+ (warning|error)|^Error while processing' || true
    return 1
  fi
}

case "${1-}" in
  format)
    need clang-format
    places=$(sources h cc | xargs clang-format --dry-run 2>&1 | grep -oE '^[^ :]+:[0-9]+' | uniq) || true
    if [[ -n $places ]]; then
      printf '%s\n' "$places"
      fail "the layout above differs from .clang-format's; tools/lint.sh fix puts it right"
    fi
    ;;
  fix)
    need clang-format
    sources h cc | xargs clang-format -i
    ;;
  tidy)
    need clang-tidy
    build=${2:-build/release}
    [[ -f $build/compile_commands.json ]] || fail "$build/compile_commands.json is missing; configure and build first"
    cache=${TUMBLE_LINT_CACHE:-${XDG_CACHE_HOME:-${HOME:-$build}/.cache}/tumble/clang-tidy}
    mkdir -p "$cache"
    find "$cache" -type f -mtime +30 -delete
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    keys >"$work/keys"
    # One entry a file: clang-tidy would read a file as often as programs are built with it.
    awk '/^{/ { entry = ""; file = "" } { entry = entry $0 "\n" } /"file":/ { file = $0 }
      /^}/ && !(file in seen) { seen[file] = 1; sub(/,\n$/, "\n", entry); printf "%s%s", n++ ? "," : "[", entry }
      END { print "]" }' "$build/compile_commands.json" >"$work/compile_commands.json"
    grep -o '"file": "[^"]*"' "$work/compile_commands.json" | sed "s|.*\"$PWD/||; s|\"||" | sort >"$work/built"
    join "$work/built" "$work/keys" | while read -r file key; do
      [[ -f $cache/$key ]] || printf '%s\0%s\0' "$file" "$key"
    done >"$work/todo"
    checked=$(join "$work/built" "$work/keys" | wc -l)
    ((checked > 0)) || fail "no file of this tree is in $build/compile_commands.json"
    export -f tidy_one
    xargs -0 -r -n 2 -P "$(nproc)" bash -c 'tidy_one "$@"' tidy_one "$work" "$cache" <"$work/todo" ||
      fail "clang-tidy wants the changes above"
    printf 'lint: %d files clean\n' "$checked"
    ;;
  *)
    sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}" >&2
    exit 2
    ;;
esac
