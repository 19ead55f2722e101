#!/usr/bin/env bash
# What the program is linked with, and what is known of its weaknesses without asking anybody: Debian's package and version
# of each library, whether the package lists have a newer one, and the CVEs that its changelog says are mended.
# Usage: tools/scripts/checks/dependencies.sh [PROGRAM]     build/release/tools/tumble if not said otherwise
# Exit status: 0 nothing newer is known, 1 a newer version of a library is, 2 bad usage.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
program=${1:-build/release/tools/tumble}
[[ -x $program ]] || { printf 'dependencies: %s is not a program; build it or name another\n' "$program" >&2; exit 2; }

# Packages with code that is compiled into the program: headers only, so the linker does not show them.
headers=(libeigen3-dev libtomlplusplus-dev libcli11-dev libfmt-dev nlohmann-json3-dev)
lists=$(find /var/lib/apt/lists -name '*_Packages*' -printf '%TY-%Tm-%Td\n' 2>/dev/null | sort | tail -1)
printf 'package lists of %s, %s\n' "${lists:-no date}" "$(sed -n 's/^PRETTY_NAME="\(.*\)"/\1/p' /etc/os-release)"

libraries=$(ldd "$program" | awk '$3 ~ /^\// { print $3 }' | while read -r file; do
  dpkg-query -S "$(realpath "$file")" 2>/dev/null || dpkg-query -S "$file"
done | cut -d : -f 1 | sort -u)
newer=0
for package in $libraries "${headers[@]}"; do
  version=$(dpkg-query -W -f '${Version}' "$package")
  candidate=$(apt-cache policy "$package" | awk '/Candidate:/ { print $2 }')
  changelog=$(find "/usr/share/doc/$package/" -name 'changelog.Debian*' 2>/dev/null | head -1)
  cves=$([[ -n $changelog ]] && zcat -f "$changelog" | grep -oE 'CVE-[0-9]+-[0-9]+' | sort -u | tail -3 | tr '\n' ' ') || true
  note=newest
  if [[ $version != "$candidate" ]]; then
    note="newer: $candidate"
    newer=1
  fi
  printf '%-22s %-24s %-10s %s\n' "$package" "$version" "$note" "${cves:+mended, the latest: $cves}"
done
exit "$newer"
