#!/usr/bin/env bash
# Looks at compiled physics for what would make its bits depend on the machine (docs/determinism.md).
# Usage: tools/scripts/checks/check_disassembly.sh [--binutils PREFIX] OBJECT|LIBRARY...
#   --binutils   the prefix of objdump, nm and ld for another machine, such as aarch64-linux-gnu-
# Prints every finding with its function. Exit status: 0 clean, 1 something found, 2 bad usage or nothing to look at.
set -euo pipefail
export LC_ALL=C

prefix=""
while [[ ${1-} == --* ]]; do
  case "$1" in
    --binutils) prefix=$2 ;;
    *) printf 'check_disassembly: unknown option %s\n' "$1" >&2; exit 2 ;;
  esac
  shift 2
done
if (($# == 0)); then
  printf 'check_disassembly: no objects given\n' >&2
  exit 2
fi

# Reads objdump's listing; tabs separate address, bytes and instruction. Prints "what: instruction in function".
instructions='
  /file format / { x86 = /x86-64|i386/; next }
  /^[0-9a-f]+ <.*>:$/ { name = $0; sub(/^[0-9a-f]+ </, "", name); sub(/>:$/, "", name); functions++; next }
  {
    n = split($0, part, "\t")
    if (n < 2) next
    op = part[n > 2 && part[3] ~ /^[a-z]/ && part[2] ~ /^[0-9a-f ]+$/ ? 3 : 2]
    sub(/^(rep[nz]* |lock |notrack )/, "", op); sub(/[ \t].*/, "", op)
    seen++
    what = ""
    # x86 FMA3 and FMA4; ARM, RISC-V and s390x spell theirs differently. vmla of 32-bit ARM rounds in between.
    if (op ~ /^vfn?m(add|sub|addsub|subadd)/ || op ~ /^fn?m(add|sub)(\.[a-z.]+)?$/ || op ~ /^f(c?mla|mls)/ ||
        op ~ /^vfn?m[as]\./ || op ~ /^(wf|vf)n?m[as][ds]?b$/ || op ~ /^m[as][de]br?$/) what = "fused multiply-add"
    else if (op ~ /^fi?(add|sub|mul|div)r?p?[sl]?$/ || op ~ /^f(ld|st|ild|ist|istt)p?(t|s|l|ll)?$/ ||
             op ~ /^f(sqrt|sin|cos|sincos|ptan|patan|prem1?|yl2x|yl2xp1|2xm1|scale|rndint)$/)
      what = x86 ? "x87 instruction" : ""
    else if (op ~ /^v?r(cp|sqrt)(14|28)?[sp][sdh]$/ || op ~ /^v?(frecp|frsqrt|vrecp|vrsqrt)[es]/) what = "approximate instruction"
    else if (op ~ /^v?dpp[sd]$/) what = "dot-product instruction"
    if (what != "" && !((what, op, name) in told)) { told[what, op, name] = 1; print what ": " op " in " name }
  }
  END { if (seen == 0 || functions == 0) print "nothing to look at" }'

libm='a?(sin|cos|tan)h?|atan2|sincos|exp(2|10|m1)?|log(2|10|1p)?|pow|cbrt|hypot|fma|erfc?|[lt]gamma'
clocks='time|clock|gettimeofday|clock_gettime|localtime(_r)?|gmtime(_r)?|_ZNSt6chrono.*3nowEv'
random='s?rand(om)?(_r)?|[dlm]rand48|getrandom|getentropy|arc4random.*|_ZNSt13random_device.*'
surroundings='(secure_)?getenv|setlocale|uselocale|newlocale'
threads='pthread_(create|join|mutex_lock|cond_wait|self).*|_ZNSt6thread.*|__cxa_thread_atexit|omp_.*|GOMP_.*'
symbols="^((${libm})[fl]?|__(${libm})[fl]?_finite|${clocks}|${random}|${surroundings}|${threads})\$"

# objdump's time grows with sections times symbols, and every inline function has a section: an object is read with its
# code in one section, fifty times as fast. A library is read as it is.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf 'SECTIONS { .text : { *(.text .text.*) } }\n' >"$work/one_section.ld"
in_one_section() { # file
  if [[ $1 == *.o ]] && "${prefix}ld" -r --force-group-allocation -T "$work/one_section.ld" -o "$work/object.o" "$1" 2>/dev/null; then
    printf '%s\n' "$work/object.o"
  else
    printf '%s\n' "$1"
  fi
}

found=$(
  for file in "$@"; do
    "${prefix}objdump" -d --no-show-raw-insn -C "$(in_one_section "$file")" | awk "$instructions"
    "${prefix}nm" -u "$file" | awk -v wanted="$symbols" '
      ($1 == "U" || $1 == "w") { sub(/@.*/, "", $2); if ($2 ~ wanted) print "call: " $2 }'
  done
) || {
  printf 'check_disassembly: cannot read %s\n' "$*" >&2
  exit 2
}
if [[ -z $found ]]; then
  printf 'clean: no fused, x87, approximate or dot-product instruction, and no call of libm (but sqrt), clocks, random\n'
  printf 'numbers, the environment or threads in %s\n' "${*##*/}"
  exit 0
fi
printf '%s\n' "$found" | sort -u
[[ $found != *"nothing to look at"* ]] || exit 2
exit 1
