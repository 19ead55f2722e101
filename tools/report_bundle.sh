#!/usr/bin/env bash
# Makes golden/report/bundle.js, the script of the report page, from its sources and the locked npm packages.
# Usage: tools/report_bundle.sh           writes it
#        tools/report_bundle.sh --check   only says whether it is current; status 77 where the packages cannot be had
# The packages go to TUMBLE_NPM (by default under ~/.cache), never into the tree. Needs node and npm.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

skip() {
  printf 'report_bundle: SKIPPED, %s\n' "$*" >&2
  exit 77
}

sources=golden/report
bundle=$sources/bundle.js
case "${1-}" in
  "" | --check) ;;
  *) sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
esac
command -v node >/dev/null || skip "node is missing; run tools/setup.sh --with report"
command -v npm >/dev/null || skip "npm is missing; run tools/setup.sh --with report"

# One folder for each lock file, so that another version never meets leftovers.
key=$(sha256sum $sources/package-lock.json | cut -c 1-16)
packages=${TUMBLE_NPM:-${XDG_CACHE_HOME:-$HOME/.cache}/tumble/npm}/$key
if [[ ! -e $packages/complete ]]; then
  mkdir -p "$packages"
  cp $sources/package.json $sources/package-lock.json "$packages/"
  (cd "$packages" && npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1) ||
    skip "npm could not install the packages of $sources/package-lock.json; its words are in $packages/npm.log"
  touch "$packages/complete"
fi

made=$(mktemp)
trap 'rm -f "$made"' EXIT
# Short lines and no template literals, tabs or blanks at line ends: the file is text of the tree like any other. The
# tabs are those of shaders, where a blank means the same.
NODE_PATH=$packages/node_modules "$packages/node_modules/.bin/esbuild" $sources/main.js --bundle --minify --format=iife \
  --target=es2022 --loader:.css=text --legal-comments=eof --charset=ascii --supported:template-literal=false \
  --line-limit=160 --log-level=warning | sed 's/\t/ /g; s/ *$//' >"$made"

if [[ ${1-} == --check ]]; then
  cmp -s "$made" $bundle || {
    printf 'report_bundle: %s is not what its sources make; run tools/report_bundle.sh\n' $bundle >&2
    exit 1
  }
  printf 'report_bundle: %s is current\n' $bundle
else
  cp "$made" $bundle
  chmod 644 $bundle
  printf 'report_bundle: %s, %d bytes\n' $bundle "$(stat -c %s $bundle)"
fi
