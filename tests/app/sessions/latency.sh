#!/usr/bin/env bash
# latency.sh CAROM CONFIG: a session in real time says how even its frames were, node by node, keeps it in its file by
# the second, and goes on where the driver has no swap groups.
. "$(dirname "$0")/../../session.sh"
sed 's/^pixels = .*/pixels = [64, 64]/; s/^\(window = .*size = \).*/\1[64, 32] }/
  s/^display_hz = .*/display_hz = 20.0\nframe_lock = "swap-group"/
  s/^lower_right/lower__right/; s/^upper_left/lower_right/; s/^lower__right/upper_left/' \
  "$config/rigs/four-walls-cluster.toml" >"$out/room.toml" # seen from outside: black, and drawn at once
grep -q swap-group "$out/room.toml" || fail "the rig has no display_hz to go by"

mpirun --allow-run-as-root --oversubscribe -n 2 "$carom" cave --rig "$out/room.toml" --scenario three-pucks --session "$out/game.db" \
  2>"$out/stderr" &
job=$!
for _ in $(seq 900); do
  [ -s "$out/game.db" ] && [ "$(sqlite3 "$out/game.db" 'SELECT count(*) FROM latency WHERE node = 1' 2>/dev/null)" -ge 16 ] 2>/dev/null && break
  sleep 0.1
done
kill -INT "$(pgrep -P "$job" | head -1)" # one node that wants to end ends all
wait "$job" || fail "the session: $(cat "$out/stderr")"
job=

for node in "node 0" "node 1"; do
  grep -qE "^$node \([a-z, ]+\): [0-9]+ frames, [0-9]+ missed, 99 % at most [0-9.]+ ms late\.$" "$out/stderr" ||
    fail "$node: no word of how it went: $(cat "$out/stderr")"
  grep -qE "^warning: $node .*frame_lock = \"swap-group\": the driver lacks GLX_NV_swap_group" "$out/stderr" ||
    grep -qE "^$node .*frame lock: swap group" "$out/stderr" || fail "$node: no word of the lock: $(cat "$out/stderr")"
done
grep -qE "^12 empty frames were swapped on every node" "$out/stderr" || fail "no word of the warming up"

# Parts follow each other within a frame: those of node 1, which waits for the next one, add up to the interval between
# swaps: the display's period and what was late. Node 0 sleeps between frames.
rows() { sqlite3 "$out/game.db" "$1"; }
[ "$(rows "SELECT count(*) FROM latency WHERE node = 0 AND part IN ('sample', 'decide')")" -ge 4 ] || fail "node 0 decides"
[ "$(rows "SELECT count(*) FROM latency WHERE node = 1 AND part IN ('sample', 'decide')")" -eq 0 ] || fail "node 1 does not"
[ "$(rows "SELECT count(*) FROM latency WHERE NOT (median_s <= p99_s AND p99_s <= most_s AND jitter_s >= 0 AND frames <= 21)")" -eq 0 ] ||
  fail "rows that cannot be: $(rows 'SELECT * FROM latency')"
sums() { # NODE: the parts of a frame, an interval, in seconds; the first, in which drivers still compile, has no interval
  rows "SELECT (SELECT sum(m) FROM (SELECT avg(median_s) AS m FROM latency WHERE node = $1 AND frame > 0 AND
    part IN ('share', 'submit', 'draw', 'wait', 'swap') GROUP BY part)),
    (SELECT avg(median_s) FROM latency WHERE node = $1 AND part = 'late') + 0.05"
}
IFS='|' read -r parts_s interval_s < <(sums 1)
awk -v parts="$parts_s" -v interval="$interval_s" 'BEGIN { exit !(parts > 0.7 * interval && parts < 1.3 * interval) }' ||
  fail "node 1: its parts add up to $parts_s s in an interval of $interval_s s: $(rows 'SELECT * FROM latency')"
IFS='|' read -r parts_s interval_s < <(sums 0)
awk -v parts="$parts_s" -v interval="$interval_s" 'BEGIN { exit !(parts > 0 && parts < 1.3 * interval) }' ||
  fail "node 0: its parts add up to $parts_s s in an interval of $interval_s s"
grep -E "late\.$" "$out/stderr"
