#!/usr/bin/env bash
# replay_proofs.sh CAROM CONFIG: a session with views of time on, a lesson that repeats what it shows or holds its moment,
# and a session with keys pressed are replayed by 1 and 4 processes with the same pictures, byte for byte; a visitor is
# shown what a session of their own would have shown them.
. "$(dirname "$0")/../../session.sh"
mpi=(mpirun --allow-run-as-root --oversubscribe -n 4)
command -v xdotool >/dev/null || {
  echo "replay_proofs: the package xdotool is not installed: there is nobody to press keys"
  exit 77
}
sed 's/^pixels = .*/pixels = [64, 64]/; s/^window = .*/window = { position = [0, 0], size = [192, 96] }/' \
  "$config/rigs/four-walls-cluster.toml" >"$out/room.toml"
rows() { sqlite3 "$out/$1.db" "$2"; }

# NAME: session NAME.db, whose pictures are in NAME, again.
proves() {
  "$carom" replay "$out/$1.db" --capture "$out/$1-one" --no-window 2>"$out/stderr" || fail "$1: $(cat "$out/stderr")"
  "${mpi[@]}" "$carom" replay "$out/$1.db" --capture "$out/$1-four" --no-window 2>"$out/stderr" ||
    fail "$1 on four processes: $(cat "$out/stderr")"
  local pictures
  pictures=$(find "$out/$1" -name '*.png' | wc -l)
  [ "$pictures" -eq $((8 * $(rows "$1" "SELECT count(*) FROM frame"))) ] || fail "$1: $pictures pictures of four walls"
  diff -r "$out/$1" "$out/$1-one" || fail "$1: a replay differs from what was seen"
  diff -r "$out/$1" "$out/$1-four" || fail "$1: a replay on four processes differs from what was seen"
}

"$carom" cave --rig "$out/room.toml" --frames 6 --session "$out/views.db" --capture "$out/views" --no-window \
  --view board-now --view my-now --view paths --view events --view clocks --view spacetime --view split \
  --switch colour=on \
  --switch searchlight=on 2>"$out/stderr" || fail "a session with views: $(cat "$out/stderr")"
"$carom" cave --rig "$out/room.toml" --frames 6 --capture "$out/plain" --no-window 2>"$out/stderr" ||
  fail "a session without: $(cat "$out/stderr")"
cmp -s "$out/views/front-left-000005.png" "$out/plain/front-left-000005.png" && fail "views and switches change nothing"
proves views

# A lesson that repeats what it shows, and one that holds its moment for an observer in motion.
sed 's/^display_hz = .*/display_hz = 2.0/' "$out/room.toml" >"$out/slow-room.toml"
for phase in shows explains; do
  frames=26
  [ "$phase" = shows ] || frames=3
  "$carom" cave --rig "$out/slow-room.toml" --scenario two-cushions --lesson "$phase" --frames "$frames" \
    --session "$out/$phase.db" --capture "$out/$phase" --no-window 2>"$out/stderr" || fail "$phase: $(cat "$out/stderr")"
  proves "$phase"
done
again=$(rows shows "SELECT count(*) FROM frame a JOIN frame b ON b.number = a.number + 1 WHERE b.t_s < a.t_s")
[ "$again" -eq 1 ] || fail "a lesson of two passes began again $again times"
"$carom" export "$out/shows.db" --csv "$out/shows.csv" 2>"$out/stderr" || fail "export of two passes: $(cat "$out/stderr")"
"$carom" replay "$out/shows.db" --at 11 --capture "$out/at" --no-window 2>"$out/stderr" || fail "--at: $(cat "$out/stderr")"
for picture in "$out"/at/*.png; do
  cmp "$picture" "$out/shows/$(basename "$picture")" || fail "the second pass, begun in its middle, differs from what was seen"
done

# Keys: colour, paths, ghosts, a frozen sight and on, patterns and back, slower light, eyes further apart; the end.
"$carom" cave --rig "$out/room.toml" --frames 1000000 --session "$out/keys.db" --capture "$out/keys" 2>"$out/stderr" &
job=$!
window=
for _ in $(seq 600); do
  [ -e "$out/keys/front-left-000002.png" ] && window=$(xdotool search --onlyvisible --name . 2>/dev/null | head -1)
  [ -n "$window" ] && break
  sleep 0.1
done
[ -n "$window" ] || fail "no window of a session: $(cat "$out/stderr")"
changes() { grep -cE '^[a-z -]+: [^ ]' "$out/stderr"; } # each is said
for key in 4 p n f f t t t bracketleft plus; do
  before=$(changes)
  xdotool key --window "$window" "$key"
  for _ in $(seq 100); do
    [ "$(changes)" -gt "$before" ] && break
    sleep 0.05
  done
done
xdotool key --window "$window" q q
wait "$job" || fail "a session with keys: $(cat "$out/stderr")"
job=
kinds=$(rows keys "SELECT count(DISTINCT what) FROM input")
[ "$kinds" -ge 7 ] || fail "only $kinds kinds of keys were noticed: $(rows keys 'SELECT * FROM input') $(cat "$out/stderr")"
proves keys

# A visitor with another head, and what they see who walk so in a session of their own.
awk 'BEGIN { print "time_s,x_m,y_m,z_m"
  for (i = 0; i <= 40; ++i) printf "%.2f,%.6f,1.6,%.6f\n", i / 50, 0.2 * sin(i / 12), -0.01 * i }' >"$out/other.csv"
sed 's/^source = .*/source = "other.csv"/' "$out/room.toml" >"$out/others-room.toml"
grep -q '^eyes_from_sensor' "$out/others-room.toml" && sed -i '/^eyes_from_sensor/d' "$out/others-room.toml"
"$carom" cave --rig "$out/room.toml" --frames 60 --session "$out/game.db" --no-window 2>"$out/stderr" ||
  fail "a session: $(cat "$out/stderr")"
"$carom" replay "$out/game.db" --observer "$out/other.csv" --capture "$out/visit" --no-window 2>"$out/stderr" ||
  fail "a visit: $(cat "$out/stderr")"
frames=$(find "$out/visit" -name 'front-left-*.png' | wc -l)
[ "$frames" -ge 40 ] || fail "a visit of $frames frames to a trace of 0.8 s"
"$carom" cave --rig "$out/others-room.toml" --frames "$frames" --capture "$out/lived" --no-window 2>"$out/stderr" ||
  fail "a session of the other's own: $(cat "$out/stderr")"
diff -r "$out/visit" "$out/lived" || fail "a visitor sees otherwise than who lives there"
"$carom" replay "$out/game.db" --capture "$out/seen" --no-window 2>"$out/stderr" || fail "a replay: $(cat "$out/stderr")"
cmp -s "$out/visit/front-left-000030.png" "$out/seen/front-left-000030.png" && fail "a visitor sees the other's pictures"
echo "the same again: $(find "$out/views" "$out/keys" -name '*.png' | wc -l) pictures with views and keys, $kinds kinds of" \
  "keys; $((8 * frames)) pictures of a visitor are those of a session of their own"
