#!/usr/bin/env bash
# Works the page of a failing check in a browser, by mouse and keyboard: tests/report_page/.
# Usage: tools/scripts/report/page.sh [TUMBLE]   TUMBLE: the program, build/release/tools/tumble unless said
# Status 77 where node, npm's packages or chromium cannot be had (tools/setup.sh --with report; CHROMIUM names another).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
tumble=$(realpath "${1:-build/release/tools/tumble}")

chromium=$(command -v "${CHROMIUM:-chromium}") || {
  printf 'report_page: SKIPPED, %s is missing; run tools/setup.sh --with report\n' "${CHROMIUM:-chromium}" >&2
  exit 77
}
modules=$(tools/scripts/report/packages.sh)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
TUMBLE=$tumble CHROMIUM=$chromium MODULES=$modules WORK=$work node --test tests/report_page/page.test.js
