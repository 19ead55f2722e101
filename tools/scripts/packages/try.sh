#!/usr/bin/env bash
# Installs the packages of tools/package.sh into a clean system and uses them there: record, replay, check, render, a
# program built against libtumble-dev. Prints how long each took.
# Usage: try.sh FOLDER [--release NAME] [--archive]
#   FOLDER       of the packages; the commands run in a folder of their own of the new system
#   --release    bookworm, trixie, noble …; bookworm if not given. debootstrap fetches it from Debian's or Ubuntu's mirror
#   --archive    tries the .tar.zst instead of the .deb files
#   --keep DIR   keeps the clean system as DIR/NAME.tar and starts from there next time
# Exits with 77, and says why, where no clean system can be made; with 1 at the first thing that is wrong.
set -euo pipefail
script=$(readlink -f "${BASH_SOURCE[0]}")
skip() {
  printf 'try: skipped: %s\n' "$*"
  exit 77
}
fail() {
  printf 'try: %s\n' "$*" >&2
  exit 1
}
usage() {
  sed -n '4,9s/^# //p' "$script"
}

folder='' release=bookworm kind=deb keep=''
while (($#)); do
  case $1 in
    -h | --help) usage && exit 0 ;;
    --release) release=${2-} && shift ;;
    --keep) keep=${2-} && shift ;;
    --archive) kind=archive ;;
    *) folder=$1 ;;
  esac
  shift
done
[[ -d $folder ]] || { usage >&2; fail "found no folder \"$folder\", wanted the packages of tools/package.sh"; }
folder=$(cd "$folder" && pwd)
[[ $release =~ ^[a-z]+$ ]] || fail "--release: found \"$release\", wanted a release's name, such as bookworm"

((EUID == 0)) || skip 'making a clean system takes root'
command -v debootstrap >/dev/null || skip 'debootstrap is missing (tools/setup.sh --only packages)'
# Mounts in a namespace of their own end with this script.
if [[ ${TUMBLE_TRY_INSIDE-} != 1 ]]; then
  unshare -m true 2>/dev/null || skip 'this machine lets nobody mount file systems'
  arguments=("$folder" --release "$release")
  [[ $kind == deb ]] || arguments+=(--archive)
  [[ -z $keep ]] || arguments+=(--keep "$keep")
  TUMBLE_TRY_INSIDE=1 exec unshare -m --propagation private "$script" "${arguments[@]}"
fi

options=() source=() # the mirror that debootstrap knows
case $release in
  jammy | noble | plucky)
    options=(--components=main,universe) source=(http://archive.ubuntu.com/ubuntu gutsy)
    # Packages that are tried on and thrown away.
    [[ -e /usr/share/keyrings/ubuntu-archive-keyring.gpg ]] || options+=(--no-check-gpg)
    ;;
esac
work=$(mktemp -d)
trap 'umount -R "$work/root/proc" "$work/root/dev" 2>/dev/null || true; rm -rf --one-file-system "$work"' EXIT
root=$work/root
began=$SECONDS
if [[ -n $keep && -s $keep/$release.tar ]]; then
  mkdir "$root"
  tar -C "$root" -xpf "$keep/$release.tar"
else
  debootstrap --variant=minbase ${options[@]+"${options[@]}"} "$release" "$root" ${source[@]+"${source[@]}"} \
    >"$work/log" 2>&1 || skip "debootstrap $release: $(tail -n 1 "$work/log")"
  if [[ -n $keep ]]; then
    mkdir -p "$keep"
    tar -C "$root" -cf "$keep/$release.tar.new" . && mv "$keep/$release.tar.new" "$keep/$release.tar"
  fi
fi
printf 'try: a clean %s after %d s\n' "$release" $((SECONDS - began))

mount -t proc proc "$root/proc" || skip 'this machine lets nobody mount /proc'
mount --rbind /dev "$root/dev"
cp /etc/resolv.conf "$root/etc/resolv.conf"
mkdir "$root/packages" "$root/opt/try"
cp "$folder"/* "$root/packages/"
install -m 755 "${script%/*}/session.sh" "$root/opt/try/session.sh"
cp -r "${script%/*}/../../../tests/install/consumer" "${script%/*}/../../../tests/install/engine" "$root/opt/try/"
env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/opt/try LC_ALL=C.UTF-8 \
  DEBIAN_FRONTEND=noninteractive chroot "$root" /opt/try/session.sh "$kind" ||
  fail "on $release: the step above failed"
