#!/usr/bin/env bash
# another_game.sh CAROM CONFIG: the key Y begins the game again in the same windows, on two nodes: in a session file
# of its own, whose frames go on counting while the game and the person's clock begin anew. A scenario that has
# become faulty meanwhile is refused with its place, and the game at hand goes on.
set -uo pipefail
. "$(dirname "$0")/session_in_window.sh"
sed -e 's/^pixels = .*/pixels = [64, 64]/' "$config/rigs/four-walls-cluster.toml" >"$out/room.toml"
cp "$config/scenarios/three-pucks.toml" "$out/game.toml"
mpirun --allow-run-as-root --oversubscribe -n 2 "$carom" cave --rig "$out/room.toml" --scenario "$out/game.toml" \
  --session "$out/visit.db" 2>"$out/stderr" &
job=$!
frames() { # of a file that may not be there yet
  [ -e "$1" ] && sqlite3 "$1" "SELECT count(*) FROM frame" 2>/dev/null || echo 0
}
await_frames() {
  for _ in $(seq 600); do
    [ "$(frames "$1")" -ge "$2" ] && return
    sleep 0.1
  done
  fail "$1 has too few frames: $(frames "$1")"
}

await_frames "$out/visit.db" 20
press y front
await_frames "$out/visit-2.db" 20
echo 'light_speed_m_s = "slow"' >"$out/game.toml"
press y front
for _ in $(seq 100); do grep -q 'game.toml:1:' "$out/stderr" && break; sleep 0.1; done
grep -q 'error: .*game.toml:1:' "$out/stderr" || fail "a faulty scenario was not refused"
await_frames "$out/visit-2.db" $(($(frames "$out/visit-2.db") + 20))
press Escape front
wait "$job" || fail "the session did not end well"
job=
[ ! -e "$out/visit-3.db" ] || fail "a faulty scenario has a session file"

last=$(sqlite3 "$out/visit.db" "SELECT max(number) FROM frame")
IFS='|' read -r first t_s proper_s < <(
  sqlite3 "$out/visit-2.db" "SELECT number, t_s, proper_time_s FROM frame ORDER BY number LIMIT 1")
[ "$first" = $((last + 1)) ] || fail "the second game begins with frame $first, the first ended with $last"
begun=$(sqlite3 "$out/visit-2.db" "SELECT $proper_s = 0 AND abs($t_s) < 2")
[ "$begun" = 1 ] || fail "the second game begins at board time $t_s, my clock $proper_s"
for game in visit visit-2; do
  "$carom" events "$out/$game.db" --csv "$out/$game.csv" 2>"$out/stderr" || fail "events of $game"
done
echo "two games, $(frames "$out/visit.db") and $(frames "$out/visit-2.db") frames; a faulty third was refused"
