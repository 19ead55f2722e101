#!/usr/bin/env bash
# Installs the Debian packages that the build, the tests and the checks need, and only those that are missing.
# Usage: tools/setup.sh [--with determinism] [--with fuzz] [--with report] [--with peers]
#   --with determinism   also the compilers and emulators that tools/scripts/checks/determinism.sh uses
#   --with fuzz          also what tools/scripts/checks/fuzz.sh uses
#   --with report        also what makes and tests the script of the report page; without it those tests are skipped
#   --with peers         also other engines that bench/peers can run our scenes through
set -euo pipefail
export LC_ALL=C # comm and sort must agree on the order

packages=(
  g++ binutils cmake ninja-build ccache pkg-config
  libeigen3-dev capnproto libcapnp-dev libzstd-dev libxxhash-dev libtomlplusplus-dev libcli11-dev libfmt-dev nlohmann-json3-dev libpugixml-dev
  libgtest-dev libbenchmark-dev
  libpng-dev libgl-dev libegl-dev libosmesa6 # pictures: headers, and the OpenGL that draws them
  ffmpeg # movies
  gnuplot-nox # measure --plot
  clang-format clang-tidy
  clang-16 # one of the compilers that must agree to the bit, also in the short form that is part of the tests
)
determinism_packages=(
  clang-19
  g++-aarch64-linux-gnu g++-riscv64-linux-gnu g++-s390x-linux-gnu g++-arm-linux-gnueabihf g++-i686-linux-gnu
  qemu-user
)
peer_packages=(libbullet-dev libode-dev libmujoco-dev)
fuzz_packages=(clang-14 libclang-rt-14-dev)
report_commands=(node:nodejs npm:npm chromium:chromium) # from wherever the machine has them, else from Debian

fail() {
  printf 'setup: %s\n' "$*" >&2
  exit 4
}

while (($#)); do
  case "$1 ${2-}" in
    "--with determinism") packages+=("${determinism_packages[@]}"); shift 2 ;;
    "--with peers") packages+=("${peer_packages[@]}"); shift 2 ;;
    "--with fuzz") packages+=("${fuzz_packages[@]}"); shift 2 ;;
    "--with report")
      for pair in "${report_commands[@]}"; do
        command -v "${pair%%:*}" >/dev/null || packages+=("${pair#*:}")
      done
      shift 2
      ;;
    "-h "* | "--help "*) sed -n '2,7s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
    *) printf 'setup: unknown argument "%s"; usage: tools/setup.sh [--with determinism] [--with fuzz] [--with report] [--with peers]\n' "$*" >&2; exit 2 ;;
  esac
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
