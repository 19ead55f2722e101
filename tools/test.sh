#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests: unit, golden, determinism, report and lint.format.
# Usage: tools/test.sh [--all] [ctest arguments, such as -L unit or -R world_test]
#   --all   also builds the benchmarks and runs the tests with the labels slow (take long) and extra (need more packages)
# At the end: the ten slowest tests, the time that building and testing took, and how many tests passed and failed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

targets=(all) leave_out=(-LE '^(slow|extra)$')
if [[ ${1-} == --all ]]; then
  targets=(all bench/all) leave_out=()
  tools/setup.sh --only packages --only python
  shift
fi

tools/setup.sh --only program --only pictures --only live --only tests --only export --only report
cmake --preset release
cmake --build --preset release --parallel "$(nproc)" --target "${targets[@]}"
built=$SECONDS

log=build/release/Testing/test.log
mkdir -p build/release/Testing
status=0
ctest --preset release --parallel "$(nproc)" --no-tests=error ${leave_out[@]+"${leave_out[@]}"} "$@" | tee "$log" || status=$?

printf '\nThe slowest tests, in seconds:\n'
sed -nE 's|^ *[0-9]+/[0-9]+ Test +#[0-9]+: ([^ ]+) .* ([0-9.]+) sec.*$|\2 \1|p' "$log" | sort -rn | sed -n '1,10s/^/  /p'
printf 'Installing and building took %d s, testing %d s.\n' "$built" $((SECONDS - built))
summary=$(sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests? failed out of ([0-9]+)$/\1 \2/p' "$log" | tail -n 1)
read -r failed total <<<"${summary:-0 0}"
if ((status == 0 && total == 0)); then
  status=1
fi
printf '%d passed, %d failed\n' $((total - failed)) "$failed"
exit "$status"
