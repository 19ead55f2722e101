#!/usr/bin/env bash
# Works the page of `tumble view` in a browser, sent and served: tests/session_page/.
# Usage: tools/scripts/report/session_page.sh [TUMBLE]   TUMBLE: the program, build/release/tools/tumble unless said
# Status 77 where node, npm's packages or chromium cannot be had (tools/setup.sh --with report; CHROMIUM names another),
# or where the program was built without libcpp-httplib-dev.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
tumble=$(realpath "${1:-build/release/tools/tumble}")

chromium=$(command -v "${CHROMIUM:-chromium}") || {
  printf 'session_page: SKIPPED, %s is missing; run tools/setup.sh --with report\n' "${CHROMIUM:-chromium}" >&2
  exit 77
}
modules=$(tools/scripts/report/packages.sh)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export TUMBLE=$tumble CHROMIUM=$chromium MODULES=$modules
# One after the other: two browsers at once would wait for each other's pictures.
for part in session effect search gaps server engine caps access; do
  mkdir "$work/$part"
  WORK=$work/$part node --test tests/session_page/$part.test.js
done
