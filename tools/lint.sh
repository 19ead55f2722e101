#!/usr/bin/env bash
# Layout and habits of the code, judged by clang-format (part of the tests) and clang-tidy; prints what to change.
# Usage: tools/lint.sh [--since REVISION | --all] [--minutes N]     clang-tidy with the checks of .clang-tidy
#          over the .cc files that changed since the revision and those of changed headers; without --since, since the
#          last tag, else since this branch left main, else over all. --minutes: files not begun by then are listed
#          and not read (60)
#        tools/lint.sh format     layout of every .h and .cc (.clang-format)
#        tools/lint.sh fix        puts the layout right
# A file that was found clean is not looked at again until it, a header it includes or the checks change; what is
# remembered lies in TUMBLE_LINT_CACHE (by default under ~/.cache), and tells nothing that cannot be found again.
# Exit status: 0 clean, also where files were left for lack of time; 2 something to change, or bad usage.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/.."

fail() {
  printf 'lint: %s\n' "$*" >&2
  exit 2
}
usage() {
  sed -n '3,8s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
}
need() {
  command -v "$1" >/dev/null || fail "$1 is missing; run tools/setup.sh"
}
sources() { # ending...
  for ending in "$@"; do
    find src replay golden tools python tests bench -name "*.$ending" -type f
  done | sort
}

# "file included-file" for every include of ours; public headers by their files.
includes() {
  sources cc h | xargs grep -H '^#include "' | sed -E 's/^([^:]+):#include "([^"]+)".*/\1 \2/' |
    awk 'NR == FNR { if (NF == 2) file[$1] = $2; next } { print $1, ($2 in file ? file[$2] : $2) }' \
      cmake/public_headers.txt -
}

# "file key" for every .cc: the key changes with the file, what it includes, directly or not, and the checks.
keys() {
  local common
  common=$({ clang-tidy --version; cat .clang-tidy; find cmake schema -type f | sort | xargs cat; } | sha256sum)
  sources cc h | xargs sha256sum | sed 's/^\([0-9a-f]*\)  /\1 /' >"$work/hashes"
  includes >"$work/includes"
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
tidy_one() { # work cache deadline file key
  local output
  if (($(date +%s) >= $3)); then
    printf '%s\n' "$4" >>"$1/unread"
  elif output=$(clang-tidy -p "$1" --quiet --extra-arg=-Wno-unknown-warning-option "$4" 2>&1); then
    : >"$2/$5"
  else
    printf '%s\n' "$output" | grep -vE '^[0-9]+ (warning|error)|^Error while processing' || true
    return 1
  fi
}

# The revision that a change is held against; empty if there is none.
base_revision() {
  local branch base
  git describe --tags --abbrev=0 2>/dev/null && return
  for branch in origin/main main; do
    base=$(git merge-base HEAD "$branch" 2>/dev/null) || continue
    [[ $base == $(git rev-parse HEAD) ]] && continue # this is the main branch
    printf '%s\n' "$base"
    return
  done
}

# The .cc files that show what changed since a revision: themselves, and for a header its own source or, where it has
# none, the first that includes it.
changed_since() { # revision
  { git diff --name-only --diff-filter=d "$1" --; git ls-files --others --exclude-standard; } | sort -u |
    while read -r file; do
      case $file in
        *.cc) printf '%s\n' "$file" ;;
        *.h)
          if [[ -f ${file%.h}.cc ]]; then
            printf '%s\n' "${file%.h}.cc"
          else
            awk -v file="$file" '$2 == file && $1 ~ /\.cc$/ { print $1; exit }' "$work/includes"
          fi
          ;;
      esac
    done | sort -u
}

# The commands that compile the files one by one and without precompiled headers, as clang-tidy reads them, in a build
# folder of its own. Code that the build generates is generated. One entry a file: clang-tidy would read a file as often
# as programs are built with it.
write_commands() {
  local build=build/lint
  { cmake -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DTUMBLE_UNITY=OFF -DTUMBLE_PRECOMPILED=OFF &&
    ninja -C $build -t targets all | grep -oE '^generated/[^: ]*\.(h|inc)' | xargs ninja -C $build; } >"$work/configured" 2>&1 ||
    { cat "$work/configured" >&2; fail "the tree cannot be configured"; }
  awk '/^{/ { entry = ""; file = "" } { entry = entry $0 "\n" } /"file":/ { file = $0 }
    /^}/ && !(file in seen) { seen[file] = 1; sub(/,\n$/, "\n", entry); printf "%s%s", n++ ? "," : "[", entry }
    END { print "]" }' <(sed "s/ -fno-gnu-unique//g" $build/compile_commands.json) >"$work/compile_commands.json"
}

tidy() {
  local minutes=60 since="" all=false cache checked unread=0
  while (($#)); do
    case "$1" in
      --all) all=true; shift; continue ;;
      --since) since=${2:?--since needs a revision} ;;
      --minutes) minutes=${2:?--minutes needs a number} ;;
      *) usage ;;
    esac
    shift 2
  done
  [[ $minutes =~ ^[0-9]+$ ]] || usage
  need clang-tidy
  cache=${TUMBLE_LINT_CACHE:-${XDG_CACHE_HOME:-${HOME:-build}/.cache}/tumble/clang-tidy}
  mkdir -p "$cache"
  find "$cache" -type f -mtime +30 -delete
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  keys >"$work/keys"
  write_commands
  grep -o '"file": "[^"]*"' "$work/compile_commands.json" | sed "s|.*\"$PWD/||; s|\"||" | sort -u >"$work/built"
  "$all" || [[ -n $since ]] || since=$(base_revision)
  if [[ -n $since ]]; then
    git rev-parse --quiet --verify "$since^{commit}" >/dev/null || fail "$since is no revision of this tree"
    changed_since "$since" | join - "$work/built" >"$work/wanted"
    printf 'lint: %d files changed since %s\n' "$(wc -l <"$work/wanted")" "$since"
  else
    cp "$work/built" "$work/wanted"
  fi
  join "$work/wanted" "$work/keys" | while read -r file key; do
    [[ -f $cache/$key ]] || printf '%s\0%s\0' "$file" "$key"
  done >"$work/todo"
  checked=$(join "$work/wanted" "$work/keys" | wc -l)
  [[ -n $since ]] || ((checked > 0)) || fail "the build knows no file of this tree"
  : >"$work/unread"
  export -f tidy_one
  xargs -0 -r -n 2 -P "$(nproc)" bash -c 'tidy_one "$@"' tidy_one "$work" "$cache" $(($(date +%s) + 60 * minutes)) \
    <"$work/todo" || fail "clang-tidy wants the changes above"
  unread=$(wc -l <"$work/unread")
  if ((unread > 0)); then
    printf 'lint: %d files were not read, because the time (%d min) was over:\n' "$unread" "$minutes"
    sort "$work/unread" | sed 's/^/  /'
  fi
  printf 'lint: %d files clean\n' $((checked - unread))
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
  "" | --*) tidy "$@" ;;
  *) usage ;;
esac
