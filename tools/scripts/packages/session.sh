#!/usr/bin/env bash
# Run by try.sh inside a clean system: installs the packages of /packages and uses them. Usage: session.sh deb|archive
set -euo pipefail
cd "$HOME"
fail() {
  printf 'session: %s\n' "$*"
  exit 1
}
# The times of a command are shown and added up: of the wall and, for a machine that does other things too, of the
# processors. Its output is shown where it fails.
total=0 total_cpu=0 TIMEFORMAT='%R %U %S'
timed() { # name, command
  local name=$1 status=0 wall user system
  shift
  { time "$@" >log 2>&1 || status=$?; } 2>time
  ((status == 0)) || { cat log; fail "$name: $*"; }
  read -r wall user system <time
  total=$(awk "BEGIN { print $total + $wall }") total_cpu=$(awk "BEGIN { print $total_cpu + $user + $system }")
  printf 'session: %-28s %7.1f s, of processors %7.1f s\n' "$name" "$wall" "$(awk "BEGIN { print $user + $system }")"
}
so_far() {
  printf 'session: %-28s %7.1f s, of processors %7.1f s\n' "$1" "$total" "$total_cpu"
}

apt-get -q update >/dev/null 2>&1 || fail 'apt-get update'
if [[ $1 == deb ]]; then
  timed 'apt-get install ./*.deb' apt-get -q install -y /packages/*.deb
  tumble=tumble data=/usr/share/tumble
else
  apt-get -q install -y --no-install-recommends zstd >/dev/null 2>&1 || fail 'apt-get install zstd'
  timed 'tar --zstd -xf' tar -C /opt --zstd -xf /packages/*.tar.zst
  mv /opt/tumble-* /opt/moved
  tumble=/opt/moved/bin/tumble data=/opt/moved/share/tumble
fi
timed 'record' "$tumble" record brick_wall -o wall.tumble --quiet
timed 'replay' "$tumble" replay wall.tumble
so_far 'to a replayed session'
require=() # of the archive, which brings no OpenGL; another Mesa may draw other pixels
[[ $1 == deb ]] || require=(--require exact --require behaviour)
timed 'check' "$tumble" check --suite "$data/golden" --report report ${require[@]+"${require[@]}"}
so_far 'to a checked suite'
[[ -s $data/schema/json/check.schema.json ]] || fail "no JSON schemas in $data/schema"
[[ -s report/index.html && -s report/junit.xml ]] || fail 'check wrote no report'
if [[ $1 == archive ]]; then
  apt-get -q install -y --no-install-recommends libosmesa6 >/dev/null 2>&1 ||
    apt-get -q install -y --no-install-recommends libegl1 libegl-mesa0 libgl1-mesa-dri >/dev/null 2>&1 ||
    fail 'no package with OpenGL in software'
fi
timed 'render' "$tumble" render wall.tumble --step 60 -o wall.png --size 640x480
timed 'view' "$tumble" view wall.tumble -o wall.html
[[ -s wall.png && -s wall.html ]] || fail 'render or view wrote no file'
for ending in csv npz glb mcap; do
  timed "export to .$ending" "$tumble" export wall.tumble -o "wall.$ending"
done
[[ $1 == deb ]] || exit 0

[[ -x /usr/bin/tumble-live ]] || fail 'no window: package tumble-live'
apt-get -q install -y --no-install-recommends g++ cmake make pkg-config >/dev/null 2>&1 || fail 'apt-get install g++ cmake'
timed 'programs by find_package' bash -c 'cmake -S consumer -B b && cmake --build b && cmake -S engine -B e && cmake --build e'
expected=$(tumble info --json wall.tumble | sed -nE 's/.*"final_hash": "([0-9a-f]+)".*/\1/p')
[[ $(b/consumer "$data/golden/cases/brick_wall/scene.toml" wall.tumble | sort -u) == "$expected" ]] ||
  fail "the consumer printed other hashes than $expected"
e/engine ball.tumblestream && tumble import ball.tumblestream -o ball.tumble >import.log || fail 'the recorded engine'
read -ra flags <<<"$(pkg-config --cflags --libs tumble-replay)"
g++ -std=c++20 consumer/main.cc "${flags[@]}" -o by_pkg_config || fail 'a program by pkg-config'
if [[ -e /usr/share/doc/python3-tumble ]]; then
  timed 'import tumble' python3 -c 'import tumble; print(tumble.Log("wall.tumble").steps[120].position[0])'
fi
names=$(cd /packages && printf '%s ' *.deb | sed -E 's/_[^ ]*//g')
read -ra names <<<"$names"
apt-get -q purge -y "${names[@]}" >/dev/null 2>&1 || fail "apt-get purge ${names[*]}"
[[ -z $(find /usr -name '*tumble*' | head -n 1) ]] || fail "purge left $(find /usr -name '*tumble*' | head -n 1)"
