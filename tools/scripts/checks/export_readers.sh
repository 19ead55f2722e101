#!/usr/bin/env bash
# Reads what `tumble export` writes with foreign programs: @mcap/core, protobufjs, gltf-validator, three.js in chromium.
# Usage: tools/scripts/checks/export_readers.sh gltf|mcap [TUMBLE] [FOLDER]   TUMBLE: build/release/tools/tumble unless
# said; FOLDER: keeps the files and pictures. Status 77 where node, npm's packages or chromium cannot be had
# (tools/setup.sh --with report), or where the program was built without libprotobuf.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
[[ ${1-} == gltf || ${1-} == mcap ]] || { sed -n '3,5s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
TUMBLE=$(realpath "${2:-build/release/tools/tumble}")

CHROMIUM=$(command -v "${CHROMIUM:-chromium}") || [[ $1 != gltf ]] || {
  printf 'export_readers: SKIPPED, chromium is missing; run tools/setup.sh --with report\n' >&2
  exit 77
}
MODULES=$(tools/scripts/report/packages.sh tests/export/readers)
if (($# > 2)); then
  WORK=$(realpath -m "$3")
  mkdir -p "$WORK"
else
  WORK=$(mktemp -d)
  trap 'rm -rf "$WORK"' EXIT
fi
export TUMBLE CHROMIUM MODULES WORK
tests/export/readers/sessions.sh
if [[ $1 == mcap ]]; then
  for name in session channels; do
    "$TUMBLE" export "$WORK/$name.tumble" -o "$WORK/$name.mcap" >/dev/null 2>"$WORK/error" && continue
    grep -q 'without libprotobuf' "$WORK/error" || { cat "$WORK/error" >&2; exit 1; }
    printf 'export_readers: SKIPPED, %s\n' "$(cat "$WORK/error")" >&2
    exit 77
  done
fi
node --test "tests/export/readers/$1.test.js"
