#!/usr/bin/env bash
# Installs a build into a folder and uses it as a stranger does: the program from another place after the installation
# was moved, and a program of somebody else through find_package and pkg-config, built with flags that change arithmetic.
# Usage: installed.sh BUILD SOURCE CXX       SOURCE: tests/install; exits with 1 at the first thing that is wrong
set -euo pipefail
build=$1 source=$2 cxx=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  printf 'installed: %s\n' "$*" >&2
  exit 1
}

cmake --install "$build" --prefix "$work/first" >"$work/install.log" || { cat "$work/install.log" >&2; exit 1; }
mv "$work/first" "$work/moved"
prefix=$work/moved
cd "$work" # no golden/cases here or above
tumble=$prefix/bin/tumble

# Scenes and cases are found beside the program.
[[ $("$tumble" scenes | wc -l) -gt 50 ]] || fail 'tumble scenes lists hardly any scene'
"$tumble" record layered_inputs -o case.tumble --quiet
"$tumble" replay case.tumble >/dev/null || fail 'replay of a session that the installed program recorded'
expected=$("$tumble" info --json case.tumble | sed -nE 's/.*"final_hash": "([0-9a-f]+)".*/\1/p')
scene=$prefix/share/tumble/golden/cases/layered_inputs/scene.toml

# Headers: only under tumble/, no header of the tree's own spelling.
[[ $(ls "$prefix/include") == tumble ]] || fail "found $(ls "$prefix/include") in include, wanted tumble alone"
if grep -rnE '#include "(src|replay|golden|tools)/' "$prefix/include"; then fail 'a header includes one that is not installed'; fi

# Inline functions of the libraries are their own: a program's copy, compiled with other flags, must replace none.
while read -r archive; do
  open=$(nm -g --defined-only --format=posix "$archive" 2>/dev/null | awk '$2 ~ /^[WVuv]$/ && $1 !~ /^_ZT[VIS]N6tumble/ { print $1 }')
  [[ -z $open ]] || fail "${archive##*/}: a program can replace $(wc -l <<<"$open") functions, such as ${open%%$'\n'*}"
done < <(find "$prefix" -name 'libtumble_*.a')

# Manual pages and completions: one page a command, without a word that troff does not know.
for command in $("$tumble" help | sed -nE 's/^  ([a-z]+) +.*$/\1/p' | grep -v '^tumble$'); do
  [[ -s $prefix/share/man/man1/tumble-$command.1 ]] || fail "no manual page of tumble $command"
done
if command -v groff >/dev/null; then
  for page in "$prefix"/share/man/man1/*.1; do
    warnings=$(groff -K utf8 -man -ww -z -T utf8 "$page" 2>&1) || true
    [[ -z $warnings ]] || fail "$page: $warnings"
  done
fi
bash -n "$prefix/share/bash-completion/completions/tumble" || fail 'the completion for bash'
found=$(bash -c 'source "$1"; COMP_WORDS=(tumble record --se); COMP_CWORD=2; _tumble; printf "%s " "${COMPREPLY[@]}"' - \
  "$prefix/share/bash-completion/completions/tumble")
[[ " $found" == *' --seconds '* ]] || fail "bash completes \"tumble record --se\" to \"$found\", wanted --seconds"

consumer() { # name, flags: builds the consumer and runs it
  cmake -S "$source/consumer" -B "$work/$1" -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_PREFIX_PATH="$prefix" \
    -DCMAKE_CXX_FLAGS="$2" >"$work/$1.log" 2>&1 && cmake --build "$work/$1" >>"$work/$1.log" 2>&1 || return 1
  "$work/$1/consumer" "$scene" case.tumble >"$work/$1.out" || return 1
}
same_hash() { # name
  [[ $(sort -u "$work/$1.out") == "$expected" ]] || fail "$1: found hashes $(tr '\n' ' ' <"$work/$1.out"), wanted $expected"
}
native=-march=native
[[ $("$cxx" -dumpmachine) == x86_64* ]] || native=-mcpu=native
consumer plain '-O1' || { cat "$work/plain.log" >&2; fail 'find_package: the consumer does not build or run'; }
same_hash plain
consumer fused "-O3 $native -ffp-contract=fast" || { cat "$work/fused.log" >&2; fail 'find_package, other flags'; }
same_hash fused
if consumer fast '-O2 -ffast-math'; then fail 'a consumer with -ffast-math was built'; fi
grep -q "without -ffast-math" "$work/fast.log" || fail 'the error of -ffast-math does not say what to do'

if command -v pkg-config >/dev/null; then
  export PKG_CONFIG_PATH=$prefix/lib/pkgconfig:$(echo "$prefix"/lib/*/pkgconfig)
  read -ra flags <<<"$(pkg-config --cflags --libs tumble-replay)"
  "$cxx" -std=c++20 -O2 "$source/consumer/main.cc" "${flags[@]}" -o "$work/by_pkg_config"
  "$work/by_pkg_config" "$scene" case.tumble >"$work/pkg.out"
  same_hash pkg
fi
printf 'installed: program, headers, libraries, manual pages and completions work; final hash %s\n' "$expected"
