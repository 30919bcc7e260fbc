#!/usr/bin/env bash
# session_file.sh CAROM CONFIG: a session that is killed and gone on with is one session; replayed by 1 and 4
# processes it gives the same pictures, byte for byte.
set -uo pipefail
carom=$1
config=$2
out=$(mktemp -d)
job=
trap '[ -z "$job" ] || kill -9 "$job" 2>/dev/null; rm -rf "$out"' EXIT
fail() {
  echo "FAILED: $1"
  exit 1
}
mpi=(mpirun --allow-run-as-root --oversubscribe)
sed 's/^pixels = .*/pixels = [64, 64]/' "$config/rigs/four-walls-cluster.toml" >"$out/room.toml"
session=("$carom" cave --session "$out/game.db" --capture "$out/seen" --no-window)
frames() { sqlite3 "$out/game.db" "SELECT count(*), min(number), max(number) FROM frame"; }

"${session[@]}" --rig "$out/room.toml" --frames 1000000 2>"$out/stderr" &
job=$!
for _ in $(seq 600); do
  [ -e "$out/seen/front-left-000075.png" ] && break
  sleep 0.1
done
kill -KILL "$job"
wait "$job" 2>/dev/null
job=
shown=$(find "$out/seen" -name 'front-left-*.png' | sort | tail -1 | sed 's/.*-0*\([0-9]*\)\.png/\1/')
IFS='|' read -r count first last < <(frames)
[ "$first" = 0 ] && [ "$count" = $((last + 1)) ] || fail "a killed session: its $count frames go from $first to $last"
[ "$last" -ge $((shown - 2)) ] || fail "a killed session: frame $shown was shown, the last in the file is $last"
[ "$(sqlite3 "$out/game.db" 'PRAGMA integrity_check')" = ok ] || fail "a killed session: its file is damaged"
find "$out/seen" -name '*.png' | while read -r picture; do
  number=$(basename "$picture" .png | sed 's/.*-0*\([0-9]\)/\1/')
  [ "$number" -le "$last" ] || rm "$picture" # shown, not yet written
done

"${session[@]}" --resume --frames 6 2>"$out/stderr" || fail "a session gone on with: $(cat "$out/stderr")"
[ "$(frames)" = "$((last + 7))|0|$((last + 6))" ] || fail "a session gone on with: $(frames)"

"$carom" replay "$out/game.db" --capture "$out/one" --no-window 2>"$out/stderr" || fail "replay: $(cat "$out/stderr")"
"${mpi[@]}" -n 4 "$carom" replay "$out/game.db" --capture "$out/four" --no-window 2>"$out/stderr" ||
  fail "replay on four processes: $(cat "$out/stderr")"
diff -r "$out/seen" "$out/one" || fail "a replay differs from what was seen"
diff -r "$out/seen" "$out/four" || fail "a replay on four processes differs from what was seen"
"$carom" diagram "$out/game.db" -o "$out/game.svg" 2>"$out/stderr" || fail "its diagram: $(cat "$out/stderr")"
echo "killed after frame $last, gone on with to $((last + 6)), $(find "$out/seen" -name '*.png' | wc -l) pictures the same again"
