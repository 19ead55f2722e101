#!/usr/bin/env bash
# Compiles the recorder and its check as an engine would, strictly, and runs the check in an empty folder.
# Usage: with_compiler.sh COMPILER FOLDER
# Exit status: 0 the check passed, 1 it failed or does not compile, 77 the compiler, or wine for a Windows program, is
# not here.
set -euo pipefail
export LC_ALL=C
compiler=$1 folder=$2
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

command -v "$compiler" >/dev/null || {
  printf 'skipped: %s is not here\n' "$compiler"
  exit 77
}
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
for program in recorder_check recorder_share; do
  "$compiler" -std=c99 -pedantic -Wall -Wextra -Werror -O2 -I "$root/replay/recorder" \
    "$root/tests/recorder/$program.c" "$root/replay/recorder/tumble_recorder.c" -o "$program.exe" || exit 1
done
case $compiler in
  *mingw*)
    command -v wine >/dev/null || {
      printf 'compiled; skipped the run: wine is not here\n'
      exit 77
    }
    export WINEPREFIX=$folder/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml='
    wine ./recorder_check.exe 2>/dev/null && wine ./recorder_share.exe 2>/dev/null || exit 1
    ;;
  *) ./recorder_check.exe && ./recorder_share.exe || exit 1 ;;
esac
