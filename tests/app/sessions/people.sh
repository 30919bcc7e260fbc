#!/usr/bin/env bash
# people.sh CAROM CONFIG: several people in one room. One [[viewer]] is what [head] is, row for row and byte for byte.
# Two and three people who walk as recorded, without thrust and with thrust to half the lapse: people.py proves their
# clocks from the session file alone. Two people's pictures, with both people's presents in the spacetime that
# stands in the room, are the same on 1, 2 and 4 processes and in a replay; a replay as either of them shows their
# pictures again.
. "$(dirname "$0")/../../session.sh"
set -e
here=$(dirname "$(readlink -f "$0")")
quietly() { "$@" 2>"$out/stderr" || fail "$*"; }
small='s/^pixels = .*/pixels = [64, 64]/'

# One viewer.
sed "$small" "$config/rigs/desk.toml" >"$out/head.toml"
sed 's/^\[head\]/[[viewer]]\nname = "viewer"/' "$out/head.toml" >"$out/viewer.toml"
for rig in head viewer; do
  quietly "$carom" cave --rig "$out/$rig.toml" --frames 8 --session "$out/$rig.db" --capture "$out/$rig" --no-window
  sqlite3 "$out/$rig.db" .dump | grep -vE "INTO (session|run|game) VALUES" >"$out/$rig.sql"
done
cmp "$out/head.sql" "$out/viewer.sql" || fail "one [[viewer]] has other tables than [head]"
diff -r "$out/head" "$out/viewer" || fail "one [[viewer]] sees otherwise than [head]"
[ "$(sqlite3 "$out/head.db" "SELECT count(*) FROM viewer")" -eq 8 ] || fail "not one row a frame in the table viewer"
[ "$(sqlite3 "$out/head.db" "SELECT count(*) FROM other_viewer")" -eq 0 ] || fail "there is another viewer"

# Two and three, their clocks.
python3 "$here/people.py" write "$out" "$config"
for people in two three; do
  for thrust in none half; do
    quietly "$carom" cave --rig "$out/$people.toml" --scenario "$out/$thrust.toml" --frames 100 \
      --session "$out/$people-$thrust.db" --no-window
    python3 "$here/people.py" prove "$out/$people-$thrust.db" "$thrust" || fail "$people people, thrust: $thrust"
  done
done

# Pictures on 1, 2 and 4 processes, and replayed as either.
sed "$small" "$config/rigs/desk-two.toml" |
  awk '/^\[\[wall\]\]/ { n++ } { print } /^stereo =/ { print "node = " (n - 1) % 4 }' >"$out/desk-two.toml"
for ranks in 1 2 4; do
  quietly mpirun --allow-run-as-root --oversubscribe -n "$ranks" "$carom" cave --rig "$out/desk-two.toml" --frames 6 \
    --view my-now --view clocks --view spacetime --session "$out/ranks-$ranks.db" --capture "$out/ranks-$ranks" --no-window
done
pictures=$(find "$out/ranks-1" -name '*.png' | wc -l)
[ "$pictures" -eq 96 ] || fail "expected 2 people x 4 walls x 2 eyes x 6 frames = 96 pictures, found $pictures"
for ranks in 2 4; do
  diff -r "$out/ranks-1" "$out/ranks-$ranks" || fail "pictures differ between 1 and $ranks processes"
done
cmp -s "$out/ranks-1/front-anna-left-000005.png" "$out/ranks-1/front-ben-left-000005.png" &&
  fail "both see the same pictures"
quietly "$carom" replay "$out/ranks-1.db" --capture "$out/again" --no-window
diff -r "$out/ranks-1" "$out/again" || fail "a replay differs from what both saw"
for name in anna ben; do
  quietly mpirun --allow-run-as-root --oversubscribe -n 2 "$carom" replay "$out/ranks-1.db" --as "$name" \
    --capture "$out/as-$name" --no-window
  [ "$(find "$out/as-$name" -name "*-$name-*.png" | wc -l)" -eq 48 ] || fail "not all pictures of $name"
  [ "$(find "$out/as-$name" -name '*.png' | wc -l)" -eq 48 ] || fail "pictures of others than $name"
  for picture in "$out/as-$name"/*.png; do
    cmp "$picture" "$out/ranks-1/$(basename "$picture")" || fail "as $name a replay differs from what $name saw"
  done
done
"$carom" replay "$out/ranks-1.db" --as cleo --no-window 2>"$out/stderr" && fail "there is no cleo"
grep -q "there is no viewer 'cleo', expected anna or ben" "$out/stderr" || fail "a name that nobody has"

# Events, numbers and a diagram of both.
quietly "$carom" events "$out/two-none.db" --csv "$out/events.csv"
head -1 "$out/events.csv" | grep -q 'seen_frame,.*seen_by_ben_frame,seen_by_ben_t_s,seen_by_ben_proper_time_s' ||
  fail "when each saw an event is not in the table"
for name in anna ben; do quietly "$carom" export "$out/two-none.db" --as "$name" --csv "$out/$name.csv" --every 50; done
cmp -s "$out/anna.csv" "$out/ben.csv" && fail "both saw the same"
quietly "$carom" diagram "$out/two-none.db" -o "$out/both.svg"
[ -s "$out/both.svg" ] || fail "there is no diagram"
echo "one viewer as before; the clocks of two and three; $pictures pictures on 1, 2 and 4 processes, again as either"
