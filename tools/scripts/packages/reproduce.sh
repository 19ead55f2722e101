#!/usr/bin/env bash
# Builds the packages of the last commit twice, in two folders and without a compiler cache, and compares their hashes.
# Usage: reproduce.sh      takes two builds' time
set -euo pipefail
tree=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CCACHE_DISABLE=1
for folder in first second/of/another/depth; do
  mkdir -p "$work/$folder"
  git clone -q "$tree" "$work/$folder/tumble"
  git -C "$work/$folder/tumble" checkout -q "$(git -C "$tree" rev-parse HEAD)"
  "$work/$folder/tumble/tools/package.sh" "$work/$folder/packages" >"$work/log" 2>&1 || { tail -n 30 "$work/log" >&2; exit 1; }
  (cd "$work/$folder/packages" && sha256sum -- *) >"$work/${folder%%/*}.sums"
done
cat "$work/first.sums"
diff "$work/first.sums" "$work/second.sums" || { printf 'reproduce: two builds of one commit differ\n' >&2; exit 1; }
printf 'reproduce: both builds gave these hashes\n'
