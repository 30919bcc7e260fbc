#!/usr/bin/env bash
# one_hour.sh [PROGRAM [DRAWN [FOLDER]]]: an hour of a session on five nodes, 216 000 frames at 60 Hz in simulated time,
# as fast as it goes, written to a session file; 64 × 64 pixels a wall, one eye. First with the walls turned away from
# the person, so that nothing is drawn and all else is as ever; then DRAWN frames (an hour if left out) with them as
# they are. Each frame's digests are compared between the nodes, as always: a session of exit status 0 had no node that
# ever drew from other numbers. What each node holds in memory goes to FOLDER/*.csv and is said at the end; exit status
# 1 where a node's grew by over 8 MiB from one twelfth of the session (five minutes of an hour) on.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
program=${1:-$here/../../build/release/bin/carom}
hour=216000
drawn=${2:-$hour}
out=${3:-$(mktemp -d)}
config=$here/../../config
mkdir -p "$out"
sed 's/^pixels = .*/pixels = [64, 64]/; s/^stereo = .*/stereo = "mono"/; s/^kind = .*/kind = "simulated"/
  /^source = /d; /^room_from_tracker = /d' "$config/rigs/five-walls-cluster.toml" >"$out/drawn.toml"
# Two corners exchanged: the wall is seen from outside.
sed 's/^lower_right/lower__right/; s/^upper_left/lower_right/; s/^lower__right/upper_left/' "$out/drawn.toml" \
  >"$out/turned-away.toml"

job=
trap '[ -z "$job" ] || kill "$job" 2>/dev/null || true' EXIT

sampleMemory() {  # NAME: every five seconds while the job runs; its processes are those of mpirun, in order of rank
  local process node frame resident
  echo "elapsed_s,frame,node,resident_kib" >"$out/$1.csv"
  while kill -0 "$job" 2>/dev/null; do
    frame=$(sed -n 's/^frame \([0-9]*\) of.*/\1/p' "$out/$1.said" | tail -1)
    node=0
    for process in $(pgrep -P "$job" | sort -n); do
      resident=$(awk '/^VmRSS/ { print $2 }' "/proc/$process/status" 2>/dev/null || true)
      [ -z "$resident" ] || echo "$((SECONDS - start)),${frame:-0},$node,$resident" >>"$out/$1.csv"
      node=$((node + 1))
    done
    sleep 5
  done
}

play() {  # NAME FRAMES
  start=$SECONDS
  mpirun --allow-run-as-root --oversubscribe -n 5 "$program" cave --rig "$out/$1.toml" --frames "$2" --no-window \
    --scenario "$config/scenarios/three-pucks.toml" --session "$out/$1.db" 2>"$out/$1.said" &
  job=$!
  sampleMemory "$1"
  wait "$job" || { echo "$1: the session failed:"; tail -5 "$out/$1.said"; exit 1; }
  job=
  echo "$1: $2 frames in $((SECONDS - start)) s, every digest the same on all five nodes"
  awk -F, -v from=$(($2 / 12)) '
    NR > 1 && $2 >= from { if (!($3 in first)) first[$3] = $4; last[$3] = $4 }
    END {
      for (node = 0; node < 5; ++node) {
        printf "  node %d: %.1f MiB after frame %d, %.1f MiB at the end (%+.2f)\n", node, first[node] / 1024, from,
               last[node] / 1024, (last[node] - first[node]) / 1024
        if (!(node in first) || last[node] - first[node] > 8192) grew = 1
      }
      exit grew
    }' "$out/$1.csv" || { echo "memory grew"; exit 1; }
}

play turned-away $hour
play drawn "$drawn"
echo "the samples are in $out"
