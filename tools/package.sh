#!/usr/bin/env bash
# Builds the packages: .deb files for Debian 12, and an archive of the program for any Linux with glibc 2.36 or newer.
# Usage: tools/package.sh [FOLDER]        FOLDER: where they go; build/packages if not given
#
# Two runs for one commit give the same bytes, in whatever folder the tree lies: all dates are the commit's, or
# SOURCE_DATE_EPOCH's where that is set. tools/scripts/packages/ has what checks the packages.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if [[ ${1-} == -h || ${1-} == --help ]]; then
  sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}"
  exit 0
fi
folder=${1:-build/packages}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
umask 022
commit_date=$(git log -1 --format=%ct 2>/dev/null || stat -c %Y CHANGES.md) # a source archive has no commits
export LC_ALL=C TZ=UTC SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$commit_date}

tools/setup.sh --only program --only export --only live --only python --only packages
cmake --preset package
cmake --build --preset package --parallel "${TUMBLE_JOBS:-$(nproc)}" --target all tumble-portable
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cpack --config build/package/CPackConfig.cmake -B "$work" -G 'DEB;TZST'
made=$(cd "$work" && printf '%s\n' *.deb *.tar.zst)
# Of another version; other packages that lie there stay.
rm -f "$folder"/{tumble,tumble-live,libtumble-dev,python3-tumble}_*.deb "$folder"/tumble-*-linux-*.tar.zst
mv "$work"/*.deb "$work"/*.tar.zst "$folder"
cd "$folder"
mapfile -t made <<<"$made"
sha256sum -- "${made[@]}"
