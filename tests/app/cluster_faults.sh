#!/usr/bin/env bash
# cluster_faults.sh CAROM CONFIG: what a room of four nodes says and does when one of them dies, stops, differs
# from the others or has no display.
set -uo pipefail
carom=$1
config=$2
out=$(mktemp -d)
job=
trap '[ -z "$job" ] || kill -9 "$job" 2>/dev/null; rm -rf "$out"' EXIT
failures=0
mpi=(mpirun --allow-run-as-root --oversubscribe)
sed 's/^pixels = .*/pixels = [64, 64]/' "$config/rigs/four-walls-cluster.toml" >"$out/room.toml"
sed 's/^eye_separation = .*/eye_separation = 0.06/' "$out/room.toml" >"$out/other.toml"

fail() {
  echo "FAILED: $1; it said:"
  cat "$out/stderr"
  failures=$((failures + 1))
}
says() { grep -qE "$1" "$out/stderr"; }

# A session that goes on until something happens to it; returns when it draws.
start() {
  "${mpi[@]}" -n 4 "$carom" cave --rig "$out/room.toml" --frames 1000000 --no-window >"$out/stdout" 2>"$out/stderr" &
  job=$!
  for _ in $(seq 300); do
    says '^frame [0-9]+ of' && break
    sleep 0.1
  done
  mapfile -t nodes < <(pgrep -P "$job" | sort -n)
  [ "${#nodes[@]}" -eq 4 ] || fail "expected four nodes, found ${#nodes[@]}"
}
# Milliseconds until the whole job has ended, or 20 000.
millisecondsToEnd() {
  local from=${EPOCHREALTIME/./}
  for _ in $(seq 400); do
    kill -0 "$job" 2>/dev/null || break
    sleep 0.05
  done
  echo $(((${EPOCHREALTIME/./} - from) / 1000))
}
ended() {  # NAME MILLISECONDS PATTERN: the job is gone within so long, nothing of it is left, one line of ours
  local took
  took=$(millisecondsToEnd)
  [ "$took" -lt "$2" ] || fail "$1: the job took $took ms to end, expected under $2"
  pgrep -f "$out/room.toml" >/dev/null && fail "$1: a process is left"
  [ "$(grep -cE '^error: ' "$out/stderr")" -eq 1 ] && says "$3" || fail "$1: expected one line of ours like '$3'"
  echo "$1: $(grep -E '^error: ' "$out/stderr") ($took ms)"
  job=
}

start
kill -KILL "${nodes[2]}"
ended "a node dies" 2000 '^error: node 2 \(.+\) is gone'

start
kill -KILL "${nodes[0]}"
ended "the node of the devices dies" 2000 '^error: node 0 \(.+\) is gone'

start
kill -STOP "${nodes[1]}"
sleep 3
kill -CONT "${nodes[1]}"
sleep 1.5
says '^node 1 \(.+\) is late' && says '^node 1 \(.+\) is back after [23]\.[0-9] s' ||
  fail "a node stops for 3 s: expected to hear that it is late, and that it is back"
says '^error' && fail "a node stops for 3 s: the session must go on"
echo "a node stops: $(grep -E '^node 1' "$out/stderr" | tr '\n' ' ')"
kill -TERM "$job"
millisecondsToEnd >/dev/null
pgrep -f "$out/room.toml" >/dev/null && fail "asked to end: a process is left"
job=

"${mpi[@]}" -n 3 "$carom" cave --rig "$out/room.toml" --frames 3 --no-window : \
  -n 1 "$carom" cave --rig "$out/other.toml" --frames 3 --no-window 2>"$out/stderr" && fail "a node with another rig: expected exit status 1"
says '^error: node 3 .*rig' || fail "a node with another rig: expected to hear which"

printf '\n[[node]]\nrank = 2\ndisplay = ":4711"\n' >>"$out/room.toml"
"${mpi[@]}" -n 4 "$carom" cave --rig "$out/room.toml" --frames 3 --no-window 2>"$out/stderr" && fail "a node without a display: expected exit status 1"
says '^error: .*:4711.*node 2' || fail "a node without a display: expected to hear which"

[ "$failures" -eq 0 ] && echo "every fault ended, or went on, as it should, and was named"
exit "$failures"
