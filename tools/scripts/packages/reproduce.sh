#!/usr/bin/env bash
# Builds the packages of the last commit twice, in two folders and without a compiler cache, and compares their hashes.
# Usage: reproduce.sh [FOLDER]      takes two builds' time
#   FOLDER    keeps the packages of both builds as FOLDER/first and FOLDER/second, to be compared where they differ
set -euo pipefail
tree=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
kept=${1:-$work/packages}
mkdir -p "$kept"
kept=$(cd "$kept" && pwd)
commit=$(git -C "$tree" rev-parse HEAD)
export CCACHE_DISABLE=1
for folder in first second/of/another/depth; do
  began=$SECONDS name=${folder%%/*}
  mkdir -p "$work/$folder"
  git clone -q "$tree" "$work/$folder/tumble"
  git -C "$work/$folder/tumble" checkout -q "$commit"
  rm -rf "${kept:?}/$name"
  "$work/$folder/tumble/tools/package.sh" "$kept/$name" >"$work/log" 2>&1 || { tail -n 30 "$work/log" >&2; exit 1; }
  (cd "$kept/$name" && sha256sum -- *) >"$work/$name.sums"
  rm -rf "${work:?}/${folder%%/*}"
  printf 'reproduce: built in %s after %d s\n' "$folder" $((SECONDS - began))
done
cat "$work/first.sums"
diff "$work/first.sums" "$work/second.sums" || { printf 'reproduce: two builds of one commit differ\n' >&2; exit 1; }
printf 'reproduce: both builds of %s gave these hashes\n' "${commit:0:12}"
