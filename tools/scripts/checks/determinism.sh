#!/usr/bin/env bash
# Compiles the simulation with many compilers, flags and machines, runs cases of both methods under each, and compares
# the bits they end in: docs/determinism.md. Machines that this one is not are emulated by qemu.
# Usage: tools/scripts/checks/determinism.sh [--subset] [--only PATTERN] [--out FOLDER]
#   --subset   g++ -O0, g++ -O3 -march=x86-64-v3 and clang -O2 only, fewer steps, with what is installed (part of the tests)
#   --only     the rows whose names match an extended regular expression, compared with the first of them
#   --out      where to build (build/determinism)
# Exit status: 0 all rows have one hash a case; 1 a row differs, fails or is missing; 2 bad usage.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."

# Chosen so that every phase has work in every case, and short enough for an emulator: method thesis, then layered.
cases=(tilted_grid:400 brick_wall:120 thin_long:150 pile:90)
layered_cases=(layered_tower:60 layered_wall:60 layered_tumble:90 layered_ramp:60)

subset=false only=.
out=build/determinism
while (($#)); do
  case "$1" in
    --subset) subset=true; shift ;;
    --only) only=${2:?--only needs a pattern}; shift 2 ;;
    --out) out=${2:?--out needs a folder}; shift 2 ;;
    *) sed -n '2,8s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
  esac
done

# Without optimisation a step takes seventy times as long; these end soon after the bodies met.
"$subset" && cases=(tilted_grid:300 brick_wall:56 thin_long:48 pile:90)
cases+=("${layered_cases[@]}")

# A row: name | compiler | its flags | flags of determinism.flags for | what runs it | cpu flags it needs | must differ?
rows=()
row() { [[ ! $1 =~ $only ]] || rows+=("$(IFS='|'; printf '%s' "$*")"); }
if "$subset"; then
  row "g++ -O0" g++ "-O0" "all gcc" "" "" ""
  row "g++ -O3 x86-64-v3" g++ "-O3 -march=x86-64-v3 -DNDEBUG" "all gcc" "" "avx2 fma" ""
  row "clang-16 -O2" clang++-16 "-O2 -DNDEBUG" "all" "" "" ""
else
  for compiler in g++ clang++-16 clang++-19; do
    kinds=all
    [[ $compiler == g++ ]] && kinds="all gcc"
    row "$compiler -O0" "$compiler" "-O0" "$kinds" "" "" ""
    for level in -O1 -O2 -O3 -Os; do
      row "$compiler $level" "$compiler" "$level -DNDEBUG" "$kinds" "" "" ""
    done
    row "$compiler -O3 x86-64-v3" "$compiler" "-O3 -march=x86-64-v3 -DNDEBUG" "$kinds" "" "avx2 fma" ""
    row "$compiler -O3 x86-64-v4" "$compiler" "-O3 -march=x86-64-v4 -DNDEBUG" "$kinds" "" "avx512f avx512vl" ""
    row "$compiler -O3 native" "$compiler" "-O3 -march=native -DNDEBUG" "$kinds" "" "" ""
  done
  cross() { # machine, compiler's prefix, emulator, flags, kinds
    row "$1" "$2-g++" "$4 -static -DNDEBUG" "$5" "$3" "" ""
  }
  cross "aarch64" aarch64-linux-gnu qemu-aarch64 "-O2" "all gcc"
  cross "aarch64 v8.3" aarch64-linux-gnu qemu-aarch64 "-O3 -march=armv8.3-a" "all gcc"
  cross "riscv64" riscv64-linux-gnu qemu-riscv64 "-O2" "all gcc"
  cross "s390x (big-endian)" s390x-linux-gnu qemu-s390x "-O2" "all gcc"
  cross "armhf" arm-linux-gnueabihf qemu-arm "-O2 -mfpu=neon-vfpv4" "all gcc"
  cross "i686" i686-linux-gnu qemu-i386 "-O2" "all gcc i386"
fi
# A comparison that must fail: with fused operations the same cases have to end elsewhere, or they would prove nothing.
row "canary: g++, contraction on" g++ "-O1 -fexpensive-optimizations -march=x86-64-v3 -ffp-contract=fast -DNDEBUG" canary "" "avx2 fma" differs

((${#rows[@]} > 0)) || { printf 'determinism: --only %s matches no row\n' "$only" >&2; exit 2; }

flags_for() { # kinds
  [[ $1 == canary ]] && { printf -- '-DEIGEN_DONT_VECTORIZE -DEIGEN_FAST_MATH=0'; return; }
  awk -v kinds=" $1 " '!/^#/ && NF == 2 && index(kinds, " " $1 " ") { printf "%s ", $2 }' cmake/determinism.flags
}

problem() { printf '%s\n' "$*" >"$folder/problem"; } # of the row in $folder

# Compiles one row; leaves `program` or `problem` in its folder.
build_row() { # folder, row
  local folder=$1 name compiler flags kinds runner needs differs
  IFS='|' read -r name compiler flags kinds runner needs differs <<<"$2"
  rm -rf "$folder" && mkdir -p "$folder"
  local program
  for program in "$compiler" $runner; do
    command -v "$program" >/dev/null || { problem "MISSING: no $program on this machine"; return; }
  done

  local launcher=() source sources=() objects=()
  command -v ccache >/dev/null && launcher=(ccache)
  mapfile -t sources <"$TUMBLE_DETERMINISM_OUT/sources"
  for source in "${sources[@]}"; do
    objects+=("$folder/${#objects[@]}.${source##*/}.o")
    # shellcheck disable=SC2046,SC2086 -- flags are words
    "${launcher[@]}" "$compiler" -std=c++20 -w $flags $(flags_for "$kinds") -I. -isystem "$TUMBLE_DETERMINISM_OUT/include" \
      -c "$source" -o "${objects[-1]}" 2>>"$folder/log" || { problem "FAILED to compile $source, see $folder/log"; return; }
  done
  # shellcheck disable=SC2086
  "$compiler" $flags -pthread "${objects[@]}" -o "$folder/program" 2>>"$folder/log" || { problem "FAILED to link, see $folder/log"; return; }

  if [[ -z $differs && $compiler != i686-* ]]; then # i686 returns doubles in x87 registers, which changes no bit
    local binutils=""
    [[ $compiler == *-linux-gnu* ]] && binutils=${compiler%g++}
    tools/scripts/checks/check_disassembly.sh --binutils "$binutils" "${objects[@]:TUMBLE_DETERMINISM_OTHERS}" >"$folder/disassembly" ||
      { problem "FAILED: disassembly, see $folder/disassembly"; return; }
  fi
}

# Runs a row that was built; leaves `hashes` (the program's lines) or `problem` in its folder.
run_row() { # folder, row
  local folder=$1 name compiler flags kinds runner needs differs need
  IFS='|' read -r name compiler flags kinds runner needs differs <<<"$2"
  [[ ! -f $folder/problem ]] || return 0
  for need in $needs; do
    grep -qw "$need" /proc/cpuinfo || { problem "not run: this CPU has no $need (built only)"; return; }
  done
  # shellcheck disable=SC2086
  $runner "$folder/program" ${differs:+--one-lane} $TUMBLE_DETERMINISM_CASES >"$folder/output" 2>>"$folder/log" || { problem "FAILED to run, see $folder/log"; return; }
  mv "$folder/output" "$folder/hashes"
}

if ! "$subset"; then
  tools/setup.sh --with determinism || printf 'determinism: going on with what is installed\n' >&2
fi
mkdir -p "$out"
out=$(cd "$out" && pwd)
# Header-only libraries through a folder of their own: a cross compiler must not see this machine's other headers.
mkdir -p "$out/include"
cmake -DOUT="$out/include" -P cmake/public_headers.cmake
for header in eigen3/Eigen fmt toml++ xxhash.h xxh3.h; do
  ln -sfn "/usr/include/$header" "$out/include/${header##*/}"
done
# Files of a folder are compiled as one unit, which halves the time, where they do not use one name for two things;
# otherwise its halves are tried.
add_units() { # name, file...
  local name=$1 unit=$out/units/$1.cc half=$((($# - 1) / 2))
  shift
  printf '#include "%s"\n' "$@" >"$unit"
  # shellcheck disable=SC2046 -- flags are words
  if (($# == 1)) || g++ -std=c++20 -w -fsyntax-only $(flags_for all) -I. -isystem "$out/include" "$unit" 2>/dev/null; then
    printf '%s\n' "$unit" >>"$out/sources"
  else
    add_units "${name}_1" "${@:1:half}"
    add_units "${name}_2" "${@:half+1}"
  fi
}
rm -rf "$out/units" && mkdir "$out/units"
printf '%s\n' tests/determinism/main.cc src/threads/worker_threads.cc src/base/{check,large_vector,text,utf8}.cc >"$out/sources" # not physics
export TUMBLE_DETERMINISM_OTHERS
TUMBLE_DETERMINISM_OTHERS=$(wc -l <"$out/sources")
add_units small src/base/hash*.cc src/{sharing,math,model,step}/*.cc # one unit, for most of its time goes into the headers
mapfile -t any_width < <(find src/kernels -name '*.cc' ! -name kernels.cc | sort)
add_units kernels "${any_width[@]}"
for lanes in 1 2 4 8; do # of widths for which a row's flags allow no instructions nothing is left
  printf '#define TUMBLE_LANES %d\n#include "src/kernels/kernels.cc"\n' "$lanes" >"$out/units/kernels_$lanes.cc"
  printf '%s\n' "$out/units/kernels_$lanes.cc" >>"$out/sources"
done
for folder in world collide thesis thesis/ground layered/find layered/islands layered/order layered/batch layered/solve scenes; do
  add_units "${folder//\//_}" src/"$folder"/*.cc
done
for folder in src/*/ src/*/*/; do # a folder that came since would be missed without a word
  case "$folder" in
    src/base/ | src/sharing/ | src/math/ | src/model/ | src/kernels/* | src/step/ | src/world/ | src/collide/ | src/thesis/ | src/thesis/ground/) ;;
    src/layered/ | src/layered/find/ | src/layered/islands/ | src/layered/order/ | src/layered/batch/ | src/layered/solve/ | src/scenes/ | src/files/ | src/process/ | src/threads/ | src/render/*) ;;
    *) printf 'determinism: %s is not compiled; add it to the list\n' "$folder" >&2; exit 2 ;;
  esac
done

arguments=()
for entry in "${cases[@]}"; do
  scene=golden/cases/${entry%:*}/scene.toml
  [[ $entry == layered_* ]] && scene=tests/determinism/scenes/${entry%:*}.toml
  arguments+=("$scene:${entry#*:}")
done

export TUMBLE_DETERMINISM_OUT=$out TUMBLE_DETERMINISM_CASES="${arguments[*]}"
export -f problem build_row run_row flags_for
each_row() { # function, how many at a time
  for i in "${!rows[@]}"; do
    printf '%s\0%s\0' "$out/$i" "${rows[i]}"
  done | xargs -0 -n 2 -P "$2" bash -c 'set -euo pipefail; "$0" "$@"' "$1"
}
each_row build_row "$(nproc)"
each_row run_row $(($(nproc) > 3 ? $(nproc) / 2 : 1)) # threads that wait for a processor make a row a hundred times as long

# The table, in Markdown, and the verdict.
reference=$out/0/hashes
printf '| build |'
printf ' %s |' "${cases[@]/:/, step }"
printf ' verdict |\n|---|'
printf -- '---|%.0s' "${cases[@]}" verdict
printf '\n'
same=0 bad=0 not_run=0
for i in "${!rows[@]}"; do
  IFS='|' read -r name _ _ _ _ _ differs <<<"${rows[i]}"
  if [[ -f $out/$i/hashes ]]; then
    verdict=same
    cmp -s "$reference" "$out/$i/hashes" || verdict=DIFFERS
    if [[ -n $differs ]]; then
      if grep -qxFf "$reference" "$out/$i/hashes"; then verdict="SAME, but must differ"; else verdict="differs, as it must"; fi
    fi
    cells=$(awk '{ printf " %s |", substr($3, 1, 12) }' "$out/$i/hashes")
  else
    verdict=$(cat "$out/$i/problem" 2>/dev/null || printf 'FAILED: no result')
    cells=$(printf ' - |%.0s' "${cases[@]}")
  fi
  case "$verdict" in
    same | "differs, as it must") same=$((same + 1)) ;;
    "not run"*) not_run=$((not_run + 1)) ;;
    *) bad=$((bad + 1)) ;;
  esac
  printf '| %s |%s %s |\n' "$name" "$cells" "$verdict"
done

printf '\n'
[[ -f $reference ]] && sed 's/^/final hash: /' "$reference"
printf '%d rows as they must be, %d wrong or missing, %d not run; %d s\n' "$same" "$bad" "$not_run" "$SECONDS"
if ((not_run > 0)); then
  printf 'NOT RUN: %d rows were built but this CPU cannot run them; see the table\n' "$not_run"
fi
((bad == 0))
