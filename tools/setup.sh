#!/usr/bin/env bash
# Installs Debian packages, only those that are missing.
# Usage: tools/setup.sh [--only GROUP]... [--with GROUP]...     without --only: program, pictures, live,
#        tests, export and lint
#   program      what builds and runs the program
#   pictures     OpenGL in software, movies and plots
#   tests        what builds and runs the tests
#   live         the window of `tumble live`, and what plays it in tests; without it both are left out
#   export       what `tumble export` writes MCAP files with, and what its tests read files with; left out without it
#   lint         clang-tidy
#   report       what makes and tests the script of the report page; without it those tests are skipped
#   determinism  the compilers and emulators that tools/scripts/checks/determinism.sh uses
#   packages     what tools/package.sh and the scripts that try its packages use
#   fuzz         what tools/scripts/checks/fuzz.sh uses
#   faults       what tools/scripts/faults/faults.sh uses
#   peers        other engines that bench/peers can run our scenes through
#   python       what builds and tests the package for Python; without it that is left out
#   slurm        what tools/scripts/slurm/slurm_trial.sh runs a cluster with on this machine
#   recorder     further compilers of the recorder's check, and wine to run what one of them makes for Windows
set -euo pipefail
export LC_ALL=C # comm and sort must agree on the order

declare -A groups=(
  [program]="g++ binutils cmake ninja-build ccache pkg-config libeigen3-dev capnproto libcapnp-dev libzstd-dev
             libxxhash-dev libtomlplusplus-dev libcli11-dev libfmt-dev nlohmann-json3-dev libpugixml-dev
             libpng-dev libgl-dev libegl-dev zlib1g-dev libcpp-httplib-dev"
  [pictures]="libosmesa6 ffmpeg gnuplot-nox"
  # clang-16: one of the compilers that must agree to the bit, also in the short form that is part of the tests
  [tests]="libgtest-dev libbenchmark-dev clang-format clang-16 python3-yaml"
  [live]="libglfw3-dev libimgui-dev libgl1-mesa-dri xvfb xauth xdotool"
  [export]="libprotobuf-dev protobuf-compiler libtinygltf-dev python3-numpy python3-jsonschema"
  [lint]="clang-tidy"
  [report]="" # commands, from wherever the machine has them, else from Debian
  [determinism]="clang-16 clang-19 qemu-user g++-aarch64-linux-gnu g++-riscv64-linux-gnu g++-s390x-linux-gnu
                 g++-arm-linux-gnueabihf g++-i686-linux-gnu"
  [packages]="dpkg-dev file lintian debootstrap"
  [fuzz]="clang-14 libclang-rt-14-dev"
  [faults]="jq"
  [peers]="libbullet-dev libode-dev libmujoco-dev"
  [python]="pybind11-dev python3-dev python3-numpy python3-pytest python3-setuptools python3-wheel python3-pip
            python3-venv python3-matplotlib"
  [slurm]="slurm-wlm munge jq"
  [recorder]="clang gcc-mingw-w64-x86-64 wine64 wine"
)
for pair in node:nodejs npm:npm chromium:chromium; do
  command -v "${pair%%:*}" >/dev/null || groups[report]+=" ${pair#*:}"
done

fail() {
  printf 'setup: %s\n' "$*" >&2
  exit 4
}
usage() {
  sed -n '3,19s/^# //p' "${BASH_SOURCE[0]}"
}

only=() with=()
while (($#)); do
  [[ $1 != -h && $1 != --help ]] || { usage; exit 0; }
  if [[ $1 != --only && $1 != --with ]] || [[ -z ${2-} || -z ${groups[$2]+known} ]]; then
    printf 'setup: found "%s", wanted --only or --with and one of the groups below\n' "$*" >&2
    usage >&2
    exit 2
  fi
  if [[ $1 == --only ]]; then only+=("$2"); else with+=("$2"); fi
  shift 2
done
((${#only[@]})) || only=(program pictures live tests export lint)
packages=()
for group in "${only[@]}" ${with[@]+"${with[@]}"}; do
  read -r -d '' -a more <<<"${groups[$group]}" || true
  packages+=(${more[@]+"${more[@]}"})
done

command -v dpkg-query >/dev/null ||
  fail "this machine has no dpkg. On a system other than Debian install what corresponds to: ${packages[*]}"

installed=$(dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' | sed -n 's/^.i. //p' | sort -u)
mapfile -t missing < <(comm -13 <(printf '%s\n' "$installed") <(printf '%s\n' "${packages[@]}" | sort -u))
if ((${#missing[@]} == 0)); then
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null ||
    fail "packages are missing, and installing them takes root or sudo. Run as root: apt-get install ${missing[*]}"
  as_root=(sudo)
fi
printf 'setup: installing %s\n' "${missing[*]}"
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q)
"${apt[@]}" update >/dev/null ||
  printf 'setup: apt-get update reported errors; trying with the package lists as they are\n' >&2
"${apt[@]}" install -y --no-install-recommends "${missing[@]}" ||
  fail "apt-get could not install: ${missing[*]} (they are in Debian 12, component main)"
