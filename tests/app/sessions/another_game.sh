#!/usr/bin/env bash
# another_game.sh CAROM CONFIG: the key Y begins the game again in the same windows, on two nodes, and in the same
# session file, whose frames go on counting while the game and the person's clock begin anew. A scenario that has
# become faulty meanwhile is refused with its place, and the game at hand goes on.
. "$(dirname "$0")/../../session.sh"
needs xdotool sqlite3
sed -e 's/^pixels = .*/pixels = [64, 64]/' "$config/rigs/four-walls-cluster.toml" >"$out/room.toml"
cp "$config/scenarios/three-pucks.toml" "$out/game.toml"
mpirun --allow-run-as-root --oversubscribe -n 2 "$carom" cave --rig "$out/room.toml" --scenario "$out/game.toml" \
  --session "$out/visit.db" 2>"$out/stderr" &
job=$!
sql() { # 0 of a file that is not there yet
  if [ -s "$out/visit.db" ]; then sqlite3 "$out/visit.db" "$1" 2>/dev/null || echo 0; else echo 0; fi
}
frames() { # since the newest game began
  sql "SELECT count(*) FROM frame WHERE number >= (SELECT max(first_frame) FROM game)"
}
await() { # GAMES FRAMES
  for _ in $(seq 600); do
    [ "$(sql "SELECT count(*) FROM game")" -eq "$1" ] && [ "$(frames)" -ge "$2" ] && return
    sleep 0.1
  done
  fail "expected $1 games and $2 frames: $(sql "SELECT count(*) FROM game"), $(frames)"
}

await 1 20
press y front
await 2 20
echo 'light_speed_m_s = "slow"' >"$out/game.toml"
press y front
for _ in $(seq 100); do grep -q 'game.toml:1:' "$out/stderr" && break; sleep 0.1; done
grep -q 'error: .*game.toml:1:' "$out/stderr" || fail "a faulty scenario was not refused"
await 2 $(($(frames) + 20))
end_session front
wait "$job" || fail "the session did not end well"
job=

first=$(sql "SELECT max(first_frame) FROM game")
last=$(sql "SELECT max(number) FROM frame WHERE number < $first")
[ "$first" = $((last + 1)) ] || fail "the second game begins with frame $first, the first ended with $last"
begun=$(sql "SELECT proper_time_s = 0 AND abs(t_s) < 2 FROM frame WHERE number = $first")
[ "$begun" = 1 ] || fail "the second game does not begin anew"
[ "$(sql "SELECT fade FROM frame WHERE number = $last")" = 1.0 ] || fail "the walls were not dark before it"
for game in 1 2; do
  "$carom" events "$out/visit.db" --game $game --csv "$out/$game.csv" 2>"$out/stderr" || fail "events of game $game"
  grep -q "Game $game of 2" "$out/stderr" || fail "it is not said which game: $(cat "$out/stderr")"
done
"$carom" events "$out/visit.db" --game 3 2>"$out/stderr" && fail "there is a third game"
grep -q "it has 2 games" "$out/stderr" || fail "a game that is not there: $(cat "$out/stderr")"
[ "$("$carom" list "$out/visit.db" | grep -c '^ *[12]  ')" = 2 ] || fail "not two games are listed"
echo "two games in one file, $(sql "SELECT count(*) FROM frame") frames; a faulty third was refused"
