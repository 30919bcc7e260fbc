#!/usr/bin/env bash
# session_file.sh CAROM CONFIG: a session that is killed and gone on with is one session; replayed by 1 and 4
# processes it gives the same pictures, byte for byte.
. "$(dirname "$0")/../../session.sh"
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
# Its first frame follows the last one: a period later for the walls and for the person, and the step between the two
# events lasts that long for the person: dt² - dr²/c² = dτ², c = 1.42 m/s.
follows=$(sqlite3 "$out/game.db" "
  SELECT abs(b.display_s - a.display_s - 1 / 60.0) < 1e-9 AND abs(b.proper_time_s - a.proper_time_s - 1 / 60.0) < 1e-9
    AND abs(dt * dt - dr2 / (1.42 * 1.42) - 1 / 3600.0) < 1e-9
  FROM frame a, frame b, (SELECT y.t_s - x.t_s AS dt, (y.x_m - x.x_m) * (y.x_m - x.x_m)
      + (y.y_m - x.y_m) * (y.y_m - x.y_m) + (y.z_m - x.z_m) * (y.z_m - x.z_m) AS dr2
    FROM frame x, frame y WHERE x.number = $last AND y.number = $last + 1)
  WHERE a.number = $last AND b.number = $last + 1")
[ "$follows" = 1 ] || fail "a session gone on with: its first frame does not follow frame $last: $(
  sqlite3 "$out/game.db" "SELECT * FROM frame WHERE number BETWEEN $last AND $last + 1" | cut -c1-200)"

"$carom" replay "$out/game.db" --capture "$out/one" --no-window 2>"$out/stderr" || fail "replay: $(cat "$out/stderr")"
"${mpi[@]}" -n 4 "$carom" replay "$out/game.db" --capture "$out/four" --no-window 2>"$out/stderr" ||
  fail "replay on four processes: $(cat "$out/stderr")"
for picture in "$out"/seen/*.png; do # the last ones before the kill were not written
  cmp "$picture" "$out/one/$(basename "$picture")" || fail "a replay differs from what was seen"
done
[ "$(find "$out/one" -name '*.png' | wc -l)" -eq $((8 * (last + 7))) ] || fail "a replay has not every picture"
diff -r "$out/one" "$out/four" || fail "a replay on four processes differs from one on one"
"$carom" events "$out/game.db" --csv "$out/events.csv" 2>"$out/stderr" || fail "its events: $(cat "$out/stderr")"
[ "$(sqlite3 "$out/game.db" "SELECT count(*) FROM event WHERE t_s <= (SELECT max(t_s) FROM frame)")" = \
  "$(($(wc -l <"$out/events.csv") - 1))" ] || fail "its events: $(cat "$out/events.csv")"
[ "$(sqlite3 "$out/game.db" "SELECT group_concat(first_frame) FROM run")" = "0,$((last + 1))" ] || fail "its runs"
"$carom" diagram "$out/game.db" -o "$out/game.svg" 2>"$out/stderr" || fail "its diagram: $(cat "$out/stderr")"
# A visit begins, goes on where its file ended, and begins anew beside a file that is damaged, which stays as it is.
visit() { # goes on or begins
  "$carom" cave --rig "$out/room.toml" --session "$out/visit.db" --resume-or-new --frames 5 --no-window \
    2>"$out/stderr" || fail "--resume-or-new: $(cat "$out/stderr")"
}
visit
visit
[ "$(sqlite3 "$out/visit.db" "SELECT count(*), max(number) FROM frame")" = "10|9" ] || fail "a visit did not go on"
[ "$(sqlite3 "$out/visit.db" "SELECT group_concat(first_frame) FROM run")" = "0,5" ] || fail "the runs of a visit"
head -c 3000 /dev/urandom >"$out/visit.db"
cp "$out/visit.db" "$out/damaged"
visit
grep -q "visit.db.*The session begins anew in another file" "$out/stderr" || fail "a damaged visit: $(cat "$out/stderr")"
cmp "$out/visit.db" "$out/damaged" || fail "a damaged visit was written to"
[ "$(sqlite3 "$out/visit-2.db" "SELECT count(*) FROM frame")" = 5 ] || fail "no visit began beside the damaged one"
# A scenario whose mesh is gone is named, with its line.
cp "$out/game.db" "$out/bare.db"
sqlite3 "$out/bare.db" "UPDATE game SET scenario = replace(scenario, 'mass_kg = 0.2', 'mass_kg = 0.2' || char(10) ||
  'mesh = \"gone.obj\"')"
for command in "replay $out/bare.db --no-window" "events $out/bare.db"; do
  "$carom" $command 2>"$out/stderr" && fail "$command: without its mesh"
  grep -q "^error: .*three-pucks.toml:[0-9]*:[0-9]*: mesh 'gone.obj'" "$out/stderr" || fail "$command: $(cat "$out/stderr")"
done
echo "killed after frame $last, gone on with to $((last + 6)), $(find "$out/seen" -name '*.png' | wc -l) pictures the same again"
