#!/usr/bin/env bash
# Bisects a history of 64 commits made of the real sources: most are harmless, two do not compile, one plants a fault in
# the physics and moves a case's camera. The fault must be found by exact equality, by a metric and by an image.
# Builds about eight revisions a question.
# Usage: tools/scripts/checks/bisect_trial.sh [FOLDER]    where to work; a temporary folder that is removed if not given
# TUMBLE names the program that bisects; build/release/tools/tumble if it is not set.
# Exit status: 0 found each time; 1 not.
set -euo pipefail
export LC_ALL=C
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
tumble=${TUMBLE:-$source/build/release/tools/tumble}
[[ -x $tumble ]] || { printf 'bisect_trial: %s is missing; build it first\n' "$tumble" >&2; exit 1; }

if (($#)); then
  work=$1
  mkdir -p "$work"
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
clone=$work/clone
[[ ! -e $clone ]] || { printf 'bisect_trial: %s is there already\n' "$clone" >&2; exit 1; }
git clone --quiet --shared "$source" "$clone"
cd "$clone"
git config user.name Trial
git config user.email trial@example.org

commits=64 fault=41 broken=(32 33)
# Files to which harmless commits add a constant that nothing uses: building them is work, and no bit moves.
harmless=(src/world/free_flight.cc src/thesis/find_pairs.cc replay/format/chain.cc tools/output/progress.cc golden/suite/text_files.cc)

replace() { # file text new-text; the text must be there
  local content
  content=$(<"$1")
  [[ $content == *"$2"* ]] || { printf 'bisect_trial: %s has no "%s" any more\n' "$1" "$2" >&2; exit 1; }
  printf '%s\n' "${content/"$2"/"$3"}" >"$1"
}
make_commit() { # number
  local file=${harmless[$1 % ${#harmless[@]}]} subject="notes: entry $1"
  printf 'namespace tumble { [[maybe_unused]] static constexpr int kTrialEntry%d = %d; }\n' "$1" "$1" >>"$file"
  if (($1 == fault)); then
    subject="solve: a harmless clean-up"
    # Bodies drift along x by a nanometre a sub-step, some more than others.
    replace src/world/free_flight.cc "Vec3((before + after) * (0.5 * dt_s))" \
      "Vec3((before + after) * (0.5 * dt_s) + Vec3((i % 7) * 1e-9, 0, 0))"
    replace golden/cases/brick_wall/scene.toml "position = [20.0, -30.0, 14.0]" "position = [20.0, -30.0, 12.0]"
  elif (($1 == ${broken[0]})); then
    printf '#error "not finished"\n' >>src/world/free_flight.cc
  elif (($1 == ${broken[1]} + 1)); then
    sed -i '/^#error/d' src/world/free_flight.cc
  fi
  git commit --quiet --all --message "$subject"
}

for ((n = 1; n <= commits; n++)); do make_commit "$n"; done
good=$(git rev-parse "HEAD~$((commits - 1))")
wanted=$(git rev-parse "HEAD~$((commits - fault))")
"$tumble" record tilted_grid -o "$work/grid.tumble" --quiet

failed=0
ask() { # name, arguments...
  local name=$1 begin=$SECONDS found=""
  shift
  printf '\n== %s\n' "$name"
  "$tumble" bisect --good "$good" --bad HEAD --work "$work/bisect" "$@" --json >"$work/$name.json" || true
  found=$(sed -n 's/^ *"commit": "\([0-9a-f]*\)".*/\1/p' "$work/$name.json" | head -n 1)
  if [[ $found == "$wanted" ]]; then
    printf '== %s: found, %d s, %d revisions asked\n' "$name" $((SECONDS - begin)) \
      "$(grep -c '"verdict"' "$work/$name.json")"
  else
    printf '== %s: NOT FOUND, see %s\n' "$name" "$work/$name.json"
    failed=1
  fi
}
ask exact "$work/grid.tumble"
ask metric "$work/grid.tumble" --metric 'lateral_max<=0'
ask image --case brick_wall --image
exit "$failed"
