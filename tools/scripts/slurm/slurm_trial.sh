#!/usr/bin/env bash
# Runs docs/ci/slurm.sbatch in a Slurm of this machine's own (cluster.sh): a suite and a hunt in shards. One task kills itself
# half way and is requeued, the node is drained and resumed, one bundle is damaged. Each time the merge must say
# what the bundles say. Status 77 and the reason where Slurm cannot run here.
# Usage: tools/scripts/slurm/slurm_trial.sh PROGRAM FOLDER [SHARDS]        200 shards if not given
set -euo pipefail
here=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
[[ $# == 2 || $# == 3 ]] || { sed -n '5s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
program=$(realpath "$1")
mkdir -p "$2"
work=$(realpath "$2")
export SHARDS=${3:-200}
recipe=$here/../../../docs/ci/slurm.sbatch

fail() {
  printf 'FAILED  %s\n' "$*" >&2
  exit 1
}
passed() { printf 'passed  %s (%d s)\n' "$*" "$SECONDS"; }

settings=$("$here/cluster.sh" start "$work/cluster")
trap '"$here/cluster.sh" stop "$work/cluster"' EXIT
eval "$settings"
node=$(sinfo -h -o %n)

# A suite of cases of one step, blessed here.
export SUITE=$work/suite OUT=$work/out COUNT=60 SEED=5
for ((k = 0; k < 2 * SHARDS; ++k)); do
  mkdir -p "$SUITE/cases/case_$k"
  printf 'title = "a box falls"\ncategory = "impact"\n[world]\nmethod = "thesis"\ndt = 0.0078125\nsteps = 1\n[[box]]\nposition = [0.0, 0.0, %d.5]\n' \
    $((k + 1)) >"$SUITE/cases/case_$k/scene.toml"
  printf '[[metric]]\nname = "lost"\nmax = 0\nwhy = "nothing falls through the ground"\n' >"$SUITE/cases/case_$k/metrics.toml"
done
names=()
for ((k = 0; k < 2 * SHARDS; ++k)); do names+=("case_$k"); done
"$program" bless --suite "$SUITE" "${names[@]}" --reason 'a trial' >"$work/bless.txt"

# The program, but in shard 5 it ends half way, once, and so does its task.
export TUMBLE=$work/tumble
cat >"$TUMBLE" <<PROGRAM
#!/usr/bin/env bash
if [[ \${TUMBLE_SHARD:-} == 5/* && ! -e $work/killed ]]; then
  touch $work/killed
  setsid "$program" "\$@" & pid=\$!
  sleep 0.02
  kill -KILL -- -\$pid
  kill -KILL \$\$
fi
exec "$program" "\$@"
PROGRAM
chmod +x "$TUMBLE"
mkdir -p "$OUT"

ended() { # JOB: waits until nothing of it is in the queue
  for ((i = 0; i < 6000; ++i)); do
    [[ -n $(squeue -h -j "$1" -o %i 2>/dev/null) ]] || return 0
    sleep 0.2
  done
  fail "job $1 does not end: $(squeue -h -j "$1")"
}
merged() { # MODE NAME: submits the merge, waits, prints its status; its output is NAME.txt
  local status=0
  sbatch --wait --parsable -o "$work/$2.txt" "$recipe" "$1" >/dev/null || status=$?
  printf '%d' "$status"
}
says() { grep -qF -- "$2" "$work/$1.txt" || fail "$1: nothing says \"$2\": $(tail -n 20 "$work/$1.txt")"; }

array=$(sbatch --parsable -o "$work/tasks.txt" --array=1-"$SHARDS"%2 "$recipe" check)
first=$(sbatch --parsable -o "$work/first.txt" --dependency=afterany:"$array" "$recipe" check)
sleep 5
scontrol update nodename="$node" state=drain reason='a trial'
for ((i = 0; i < 600; ++i)); do
  [[ -n $(squeue -h -t running -o %i) ]] || break
  sleep 0.2
done
[[ $(sinfo -h -o %T) == drained ]] || fail "the node is $(sinfo -h -o %T), wanted drained"
before=$(find "$OUT" -name bundle.json | wc -l)
sleep 3
after=$(find "$OUT" -name bundle.json | wc -l)
((before == after && before < SHARDS)) || fail "drained: found $before, then $after bundles of $SHARDS"
scontrol update nodename="$node" state=resume
ended "$array"
ended "$first"
passed "$SHARDS tasks, the node drained at $before of them and resumed"

says first "$OUT/check-5: "
passed "the dependent merge names the shard that was killed"

scontrol requeue "${array}_5"
ended "$array"
[[ -e $OUT/check-5/bundle.json ]] || fail "shard 5 was requeued and has no bundle"
printf 'x' >>"$OUT/check-9/report.json"
status=$(merged check damaged)
[[ $status == 3 ]] || fail "damaged: status $status, wanted 3: $(<"$work/damaged.txt")"
says damaged "$OUT/check-9: shard 9 of $SHARDS: report.json: found"
passed 'the killed shard was requeued; the damaged one is named'

sbatch --wait --parsable -o "$work/tasks.txt" --array=9 "$recipe" check >/dev/null
status=$(merged check last)
[[ $status == 0 ]] || fail "last: status $status, wanted 0: $(<"$work/last.txt")"
says last "$((2 * SHARDS)) cases passed: $((2 * SHARDS)) unchanged"
"$program" check --suite "$SUITE" --report "$work/whole" >"$work/whole.txt"
same='del(.seconds, .run, .folder, .cases[].seconds)'
cmp <(jq -S "$same" "$work/whole/report.json") <(jq -S "$same" "$OUT/report/report.json") ||
  fail 'the merged report is not that of the whole suite'
passed 'the merged report is that of the whole suite'

export SHARDS=4
array=$(sbatch --parsable -o "$work/tasks.txt" --array=1-4%2 "$recipe" hunt)
ended "$array"
status=$(merged hunt hunt)
[[ $status == 0 || $status == 1 ]] || fail "hunt: status $status: $(<"$work/hunt.txt")"
"$program" hunt --seed "$SEED" --count "$COUNT" --folder "$work/hunt" >/dev/null || true
same='{scenes, no_scenes, relations, findings: [.findings[] | {number, relation}] | sort}'
cmp <(jq -S "$same" "$work/hunt/hunt.json") <(jq -S "$same" "$OUT/hunt/hunt.json") ||
  fail 'the merged hunt is not that of one machine'
rm "$OUT/hunt-3/hunt.json"
rm -r "$OUT/hunt"
status=$(merged hunt lost)
[[ $status == 2 ]] || fail "hunt without a shard: status $status, wanted 2"
says lost "$OUT/hunt-3: holds no hunt.json"
passed 'a hunt in 4 shards is the hunt of one machine; a lost shard is named'
