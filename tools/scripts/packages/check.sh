#!/usr/bin/env bash
# Builds the packages and checks them: no lintian error, no path of this machine in any file, and they work in a clean
# Debian 12 (try.sh). Usage: check.sh [FOLDER]       FOLDER: where the packages go; build/packages if not given
# Exits with 77, and says why, where no clean system can be made; all else was right then.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(cd "$here/../../.." && pwd)
folder=${1:-$tree/build/packages}
fail() {
  printf 'check: %s\n' "$*" >&2
  exit 1
}

"$tree/tools/package.sh" "$folder"
lintian --fail-on error "$folder"/*.deb || fail 'lintian reports errors'

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for package in "$folder"/*.deb; do
  dpkg-deb -x "$package" "$work/$(basename "$package" .deb)"
done
mkdir "$work/archive"
tar -C "$work/archive" --zstd -xf "$folder"/*.tar.zst
found=$(grep -rlF -e "$tree" "$work" || true)
[[ -z $found ]] || fail "a path of this machine is in ${found//$'\n'/, }"
needed=$(objdump -p "$work"/archive/*/bin/tumble | awk '$1 == "NEEDED" { print $2 }' | grep -vE '^(libc|libm|ld-linux-x86-64)\.so\.' || true)
[[ -z $needed ]] || fail "the archive's program needs ${needed//$'\n'/, }"
printf 'check: %s\n' "$(objdump -T "$work"/archive/*/bin/tumble | grep -oE 'GLIBC_[0-9.]+' | sort -V | tail -n 1) is the newest glibc that the archive's program needs"
"$here/try.sh" "$folder"
