#!/bin/sh
# Symmetry of the thesis's comparison scene at every size, step and number of sub-steps, with both methods: prints a table in Markdown and
# fails unless lateral error and column spread are exactly 0 everywhere.
#
#   tools/scripts/checks/exactness.sh [BUILD_DIR]        BUILD_DIR: a configured build; build/release unless said
set -eu
root=$(cd "$(dirname "$0")/../../.." && pwd)
build=${1:-$root/build/release}
if [ ! -f "$build/CMakeCache.txt" ]; then
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release >&2
fi
cmake --build "$build" --target exactness_sweep >&2
status=0
for method in thesis layered; do
  "$build/tests/exactness_sweep" $method 6,10,15,20 1,4,10,40,200 || status=1
  "$build/tests/exactness_sweep" $method 40,60,80 1,4,10 || status=1
done
exit $status
