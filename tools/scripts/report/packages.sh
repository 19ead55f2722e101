#!/usr/bin/env bash
# Installs the locked npm packages of a folder and prints the folder they are in (its node_modules).
# Usage: tools/scripts/report/packages.sh [FOLDER]      golden/report/page unless said; status 77 and the reason on stderr where they cannot be had
# They go to TUMBLE_NPM (by default under ~/.cache), never into the tree. Needs node and npm.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."

skip() {
  printf 'report_packages: SKIPPED, %s\n' "$*" >&2
  exit 77
}

sources=${1:-golden/report/page}
(($# <= 1)) || { sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
for command in node npm; do
  command -v $command >/dev/null || skip "$command is missing; run tools/setup.sh --with report"
done

# One folder for each lock file, so that another version never meets leftovers; one installation at a time.
key=$(sha256sum $sources/package-lock.json | cut -c 1-16)
packages=${TUMBLE_NPM:-${XDG_CACHE_HOME:-$HOME/.cache}/tumble/npm}/$key
mkdir -p "$packages"
exec 9>"$packages/lock"
flock 9
if [[ ! -e $packages/complete ]]; then
  cp $sources/package.json $sources/package-lock.json "$packages/"
  (cd "$packages" && npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1 9>&-) ||
    skip "npm could not install the packages of $sources/package-lock.json; its words are in $packages/npm.log"
  touch "$packages/complete"
fi
printf '%s\n' "$packages/node_modules"
