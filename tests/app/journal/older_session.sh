#!/usr/bin/env bash
# older_session.sh CAROM CONFIG: a session file of version 3 is replayed and gone on with; replayed then, it shows the
# pictures that it showed before.
. "$(dirname "$0")/../../session.sh"
cp "$(dirname "$0")/../data/session-version-3.db" "$out/game.db"
chmod u+w "$out/game.db"
rows() { sqlite3 "$out/game.db" "$1"; }
replay() { "$carom" replay "$out/game.db" --capture "$out/$1" --no-window 2>"$out/stderr" || fail "$1: $(cat "$out/stderr")"; }

replay before
[ "$(rows 'PRAGMA user_version')" = 3 ] || fail "a replay has changed the file"
"$carom" cave --session "$out/game.db" --resume --frames 5 --no-window 2>"$out/stderr" || fail "resume: $(cat "$out/stderr")"
grep -q "game.db is of version 3 and becomes one of version 8" "$out/stderr" || fail "not a word: $(cat "$out/stderr")"
[ "$(rows 'PRAGMA user_version')" = 8 ] || fail "its version is $(rows 'PRAGMA user_version')"
[ "$(rows 'SELECT count(*), max(number) FROM frame')" = "25|24" ] || fail "its frames: $(rows 'SELECT number FROM frame')"
replay after
pictures=$(find "$out/before" -name '*.png' | wc -l)
[ "$pictures" -ge 20 ] || fail "$pictures pictures of 20 frames"
for picture in "$out"/before/*.png; do
  cmp "$picture" "$out/after/$(basename "$picture")" || fail "a replay differs after the session was gone on with"
done
echo "$pictures pictures the same again, 5 frames more"
