#!/usr/bin/env bash
# Damages logs of all golden cases and kills recorders, and counts what was not found or was lost.
# Usage: tools/scripts/checks/damage.sh [TRIALS [KILLS]]     a million flips and cuts and 2000 kills if not said otherwise
# The logs are short versions of the cases (12 steps). Exit status: 0 nothing undetected, nothing lost, no crash; else not.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
trials=${1:-1000000}
kills=${2:-2000}
[[ $trials =~ ^[0-9]+$ && $kills =~ ^[0-9]+$ ]] || { sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }

cmake --preset release >/dev/null
cmake --build --preset release --target tumble damage_trial >/dev/null
build=build/release
folder=$build/damage
mkdir -p "$folder"
for scene in golden/cases/*/scene.toml; do
  name=$(basename "$(dirname "$scene")")
  [[ -f $folder/$name.tumble ]] || "$build/tools/tumble" record "$scene" --steps 12 -o "$folder/$name.tumble" --quiet
done
printf '%s flips and cuts over %d logs:\n' "$trials" "$(find "$folder" -name '*.tumble' | wc -l)"
time "$build/tests/damage_trial" flips "$trials" 1 "$folder"/*.tumble
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
printf '%s kills:\n' "$kills"
time "$build/tests/damage_trial" kills "$kills" 1 "$build/tools/tumble" golden/cases/layered_tower_5/scene.toml "$scratch"
