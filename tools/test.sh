#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. The last line says how many passed and failed.
# Usage: tools/test.sh [ctest arguments, such as -L unit or -R world_test]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tools/setup.sh --with report
cmake --preset release
cmake --build --preset release --parallel "$(nproc)"

log=build/release/Testing/test.log
mkdir -p build/release/Testing
status=0
ctest --preset release --parallel "$(nproc)" --no-tests=error "$@" | tee "$log" || status=$?

summary=$(sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests? failed out of ([0-9]+)$/\1 \2/p' "$log" | tail -n 1)
read -r failed total <<<"${summary:-0 0}"
if ((status == 0 && total == 0)); then
  status=1
fi
printf '%d passed, %d failed\n' $((total - failed)) "$failed"
exit "$status"
