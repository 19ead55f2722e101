#!/usr/bin/env bash
# Fuzzes everything that reads bytes from outside, with libFuzzer, AddressSanitizer and UndefinedBehaviorSanitizer.
# Usage: tools/scripts/checks/fuzz.sh MINUTES [TARGET...]     the minutes are shared out; targets:
#        log messages codec scene commands stream import
# Needs tools/setup.sh --with fuzz (clang 14: later ones do not take Cap'n Proto 0.9 in C++20). What was tried lies in
# build/fuzz/corpus and is gone on from; what fails lies in build/fuzz/findings.
# Exit status: 0 nothing found, 1 a finding, 2 bad usage.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."

usage() {
  sed -n '2,7s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
}
[[ ${1-} =~ ^[0-9]+$ ]] || usage
minutes=$1
shift
targets=("$@")
((${#targets[@]} > 0)) || targets=(log messages codec scene commands stream import)

cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target "${targets[@]/#/fuzz_}" >/dev/null
scratch=$(mktemp -d -p "$([[ -d /dev/shm ]] && echo /dev/shm || echo "${TMPDIR:-.}")")
trap 'rm -rf "$scratch"' EXIT
export TMPDIR=$scratch

# Bytes that an input may have: a log of a few bodies shows every path, and small ones run often.
declare -A longest=([log]=16384 [messages]=32768 [codec]=16384 [scene]=4096 [commands]=32768 [stream]=16384 [import]=4096)
# Memory: no piece above 128 MB. The sum has room for AddressSanitizer's shadow, for freed memory that it keeps back,
# and for libFuzzer's corpus.
limits=(-malloc_limit_mb=128 -rss_limit_mb=640)
export ASAN_OPTIONS=quarantine_size_mb=16
found=0
seconds=$((minutes * 60 / ${#targets[@]}))
for target in "${targets[@]}"; do
  corpus=build/fuzz/corpus/$target
  findings=build/fuzz/findings/$target
  mkdir -p "$corpus" "$findings"
  seeds=("tests/fuzz/corpus/$target")
  [[ $target == scene ]] && seeds+=(golden/cases)
  log=build/fuzz/$target.log
  rm -f "$log"
  # Goes on after a finding: the next run avoids nothing, but draws other numbers.
  end=$((SECONDS + seconds))
  while left=$((end - SECONDS)) && ((left > 0)); do
    nice -n 19 "build/fuzz/tests/fuzz/fuzz_$target" "$corpus" "${seeds[@]}" -dict=tests/fuzz/tumble.dict \
      -max_total_time="$left" -max_len="${longest[$target]}" -timeout=25 "${limits[@]}" \
      -artifact_prefix="$findings/" -print_final_stats=1 -verbosity=1 >>"$log" 2>&1 || true
    tail -n 30 "$log" | grep -q 'SUMMARY: ' || break
  done
  executions=$(awk '/stat::number_of_executed_units/ { n += $2 } END { print n + 0 }' "$log")
  coverage=$(grep -oE 'cov: [0-9]+' "$log" | sort -k 2n | tail -1)
  bad=$(find "$findings" -type f | wc -l)
  printf '%-9s %9d executions in %d s, %s, corpus %d inputs, findings %d\n' "$target" "$executions" "$seconds" \
    "$coverage" "$(find "$corpus" -type f | wc -l)" "$bad"
  ((bad == 0)) || found=1
done
exit "$found"
