#!/usr/bin/env bash
# Installs a build into a folder and uses it as a stranger does: the program from another place after the installation
# was moved, and programs of somebody else through find_package and pkg-config, built with flags that change arithmetic.
# Usage: installed.sh BUILD SOURCE CC CXX       SOURCE: tests/install; exits with 1 at the first thing that is wrong
set -euo pipefail
build=$1 source=$2 cc=$3 cxx=$4
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

# Schemas of what --json prints, known by the names that the outputs give, and of the messages in MCAP files.
for command in $("$tumble" help | sed -nE 's/^  ([a-z]+) +.*$/\1/p' | grep -v '^tumble$'); do
  "$tumble" "$command" --help | grep -q -e --json || continue
  grep -q "\"urn:tumble:json:[0-9]*:$command\"" "$prefix/share/tumble/schema/json/$command.schema.json" ||
    fail "share/tumble/schema/json: no schema of tumble $command --json"
done
[[ -s $prefix/share/tumble/schema/export/foxglove.proto ]] || fail 'share/tumble/schema/export: no messages of MCAP files'

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

configure_and_build() { # name, folder, arguments of cmake: a project against the installed tree
  local name=$1 folder=$2
  shift 2
  cmake -S "$source/$folder" -B "$work/$name" -DCMAKE_PREFIX_PATH="$prefix" "$@" >"$work/$name.log" 2>&1 &&
    cmake --build "$work/$name" >>"$work/$name.log" 2>&1
}
# An engine in C: the recorder alone, on a machine without the packages of the other components.
configure_and_build engine engine -DCMAKE_C_COMPILER="$cc" -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON ||
  { cat "$work/engine.log" >&2; fail 'find_package: the component recorder alone'; }
"$work/engine/engine" ball.tumblestream || fail 'the engine with the recorder of the installed tree'
"$tumble" import ball.tumblestream -o ball.tumble >import.log || fail 'import of what the recorder wrote'
configure_and_build log_in_c log_in_c -DCMAKE_C_COMPILER="$cc" ||
  { cat "$work/log_in_c.log" >&2; fail 'find_package: a project in C alone that uses the component replay'; }
"$work/log_in_c/log_in_c" fall.tumble && "$tumble" info fall.tumble >info.log || fail 'the log of an engine in C'
if configure_and_build unknown engine -DPARTS=kitchen; then fail 'find_package found a component "kitchen"'; fi
grep -q kitchen "$work/unknown.log" || fail 'find_package does not name the component that it lacks'

consumer() { # name, flags: builds the consumers and runs them
  configure_and_build "$1" consumer -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_CXX_FLAGS="$2" || return 1
  "$work/$1/consumer" "$scene" case.tumble >"$work/$1.out" &&
    "$work/$1/suite" "$prefix/share/tumble/golden" layered_inputs "$work/$1.report" >>"$work/$1.out"
}
same_hash() { # name: all hashes that a consumer printed are the session's
  [[ $(sort -u "$work/$1.out") == "$expected" ]] || fail "$1: found hashes $(tr '\n' ' ' <"$work/$1.out"), wanted $expected"
}
native=-march=native
[[ $("$cxx" -dumpmachine) == x86_64* ]] || native=-mcpu=native
consumer plain '-O1' || { cat "$work/plain.log" >&2; fail 'find_package: the consumers do not build or run'; }
same_hash plain
consumer fused "-O3 $native -ffp-contract=fast" || { cat "$work/fused.log" >&2; fail 'find_package, other flags'; }
same_hash fused
for file in index.html junit.xml report.json grey.png; do
  [[ -s $work/fused.report/$file ]] || fail "the component golden wrote no $file"
done
if consumer fast '-O2 -ffast-math'; then fail 'a consumer with -ffast-math was built'; fi
grep -q "without -ffast-math" "$work/fast.log" || fail 'the error of -ffast-math does not say what to do'

if command -v pkg-config >/dev/null; then
  export PKG_CONFIG_PATH=$prefix/lib/pkgconfig:$(echo "$prefix"/lib/*/pkgconfig)
  read -ra flags <<<"$(pkg-config --cflags --libs tumble-golden)"
  mkdir pkg
  for program in main suite; do
    "$cxx" -std=c++20 -O2 "$source/consumer/$program.cc" "${flags[@]}" -o "pkg/$program"
  done
  pkg/main "$scene" case.tumble >pkg.out
  pkg/suite "$prefix/share/tumble/golden" layered_inputs pkg.report >>pkg.out
  same_hash pkg
  # The C++ of README as it stands there: a scene with inputs ends as its session does.
  snippet() { awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$source/../../README.md"; }
  {
    printf '#include <cstdio>\n#include <fstream>\n#include <iterator>\n'
    snippet | grep '^#include'
    printf 'int main(int, char** argv) {\nstd::ifstream file(argv[1]);\n'
    printf 'const std::string text{std::istreambuf_iterator<char>(file), {}};\n'
    snippet | grep -v '^#include'
    printf 'std::puts(to_string(tumble::sim::state_hash(world->bodies())).c_str());\n}\n'
  } >pkg/readme.cc
  read -ra flags <<<"$(pkg-config --cflags --libs tumble-sim)"
  "$cxx" -std=c++20 -O1 pkg/readme.cc "${flags[@]}" -o pkg/readme
  pkg/readme "$scene" >readme.out
  same_hash readme
  read -ra flags <<<"$(pkg-config --cflags --libs tumble-recorder)"
  "$cc" -std=c99 "$source/engine/main.c" "${flags[@]}" -o pkg/engine
  pkg/engine again.tumblestream
  read -ra flags <<<"$(pkg-config --cflags --libs tumble-replay)"
  "$cc" -std=c99 "$source/log_in_c/main.c" "${flags[@]}" -o pkg/log_in_c && pkg/log_in_c again.tumble &&
    cmp -s fall.tumble again.tumble || fail 'pkg-config: the log of an engine in C'
  cmp -s ball.tumblestream again.tumblestream || fail 'pkg-config: the recorder wrote another stream than by find_package'
fi
printf 'installed: program, headers, libraries, manual pages and completions work; final hash %s\n' "$expected"
