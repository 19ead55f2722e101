#!/usr/bin/env bash
# Makes golden/report/page/bundle.js, the script of the report page, from its sources and the locked npm packages.
# Usage: tools/scripts/report/bundle.sh           writes it
#        tools/scripts/report/bundle.sh --check   only says whether it is current; status 77 where the packages cannot be had
# Needs node and npm (tools/setup.sh --with report).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."

sources=golden/report/page
bundle=$sources/bundle.js
case "${1-}" in
  "" | --check) ;;
  *) sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
esac
modules=$(tools/scripts/report/packages.sh)

made=$(mktemp)
trap 'rm -f "$made"' EXIT
# Short lines and no template literals, tabs or blanks at line ends: the file is text of the tree like any other. The
# tabs are those of shaders, where a blank means the same.
NODE_PATH=$modules "$modules/.bin/esbuild" $sources/main.js --bundle --minify --format=iife \
  --target=es2022 --loader:.css=text --legal-comments=eof --charset=ascii --supported:template-literal=false \
  --line-limit=160 --log-level=warning | sed 's/\t/ /g; s/ *$//' >"$made"

if [[ ${1-} == --check ]]; then
  cmp -s "$made" $bundle || {
    printf 'report_bundle: %s is not what its sources make; run tools/scripts/report/bundle.sh\n' $bundle >&2
    exit 1
  }
  printf 'report_bundle: %s is current\n' $bundle
else
  cp "$made" $bundle
  chmod 644 $bundle
  printf 'report_bundle: %s, %d bytes\n' $bundle "$(stat -c %s $bundle)"
fi
