#!/usr/bin/env bash
# page_faults.sh CAROM CONFIG: what carom page says of what it cannot make a page of: one sentence each, and no file. A page
# holds nothing of this machine, of its people and of other games. Needs no browser.
. "$(dirname "$0")/../../session.sh"
needs sqlite3
pixels='s/^pixels = .*/pixels = [64, 36]/'
sed "$pixels" "$config/rigs/single-screen.toml" >"$out/room.toml"
play() { # FILE SCENARIO FRAMES [OPTION …]
  "$carom" cave --rig "$out/room.toml" --scenario "$2" --session "$out/$1" --frames "$3" --no-window --silent "${@:4}" 2>"$out/stderr" || fail "the session $1"
}
refused() { # WORDS ARGUMENT …: the command fails, says this, and leaves nothing
  local words=$1
  "$carom" page "${@:2}" -o "$out/none.html" 2>"$out/stderr" && fail "made a page of: ${*:2}"
  grep -q -- "$words" "$out/stderr" || fail "expected '$words' of: ${*:2}"
  [ ! -e "$out/none.html" ] || fail "left a file: ${*:2}"
}
# Two games, of two visitors; the page is that of the second.
sed -e 's/^title = .*/title = "Zebra, the game before"/; s/"white"/"okapi"/' "$config/scenarios/three-pucks.toml" >"$out/before.toml"
printf '[[game]]\nscenario = "%s"\nfor_s = 5\n' "$out/before.toml" three-pucks >"$out/two.toml"
"$carom" cave --rig "$out/room.toml" --playlist "$out/two.toml" --session "$out/game.db" --frames 342 --no-window --silent 2>"$out/stderr" || fail "two games"
"$carom" page "$out/game.db" -o "$out/page.html" 2>"$out/stderr" || { grep -q 'without the engine for browsers' "$out/stderr" &&
  { echo "skipped: $(cat "$out/stderr")"; exit 77; }; fail "carom page"; }

# Sessions.
head -c 20000 "$out/game.db" >"$out/cut.db"
refused 'session file .*cut.db: ' "$out/cut.db"
echo "no session" >"$out/words.db"
refused 'this is no session file' "$out/words.db"
cp "$out/game.db" "$out/older.db" && sqlite3 "$out/older.db" "PRAGMA user_version = 3"
refused 'version' "$out/older.db"
cp "$out/game.db" "$out/empty.db" && sqlite3 "$out/empty.db" "DELETE FROM frame"
refused 'it ended before its first frame' "$out/empty.db"
refused 'no frame of this game lies between' "$out/game.db" --from 1000
refused 'is not before --until' "$out/game.db" --from 2 --until 1
refused 'nobody' "$out/game.db" --as nobody
refused 'it has 2 games' "$out/game.db" --game 7

# Games.
refused 'soft bodies, which a page does not show' jellies
refused 'expected at most 3600 s' two-cushions --until 86400
refused 'are for sessions' two-cushions --from 3
{ sed -n '1,/^\[board\]/p' "$config/scenarios/three-pucks.toml" | sed '$d'; echo '[board]'; echo 'length_m = 200.0'; echo 'width_m = 200.0'
  for i in $(seq 0 999); do
    printf '[[puck]]\nname = "p%d"\nradius_m = 0.05\nheight_m = 0.02\nmass_kg = 0.1\nposition_m = [%d.0, %d.0]\nbeta = [0.0, 0.0]\n' \
      "$i" $((i % 40 * 4 - 80)) $((i / 40 * 4 - 50))
  done; } | grep -v '^#' >"$out/thousand.toml"
refused 'the game has 1000 pucks, expected at most 200' "$out/thousand.toml"

# A mesh that is gone.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 3 4\n' >"$out/shape.obj"
awk -v mesh="$out/shape.obj" '{ print } !done && /^name = "white"/ { print "mesh = \"" mesh "\""; done = 1 }' \
  "$config/scenarios/three-pucks.toml" >"$out/meshed.toml"
play meshed.db "$out/meshed.toml" 6
rm "$out/shape.obj"
refused 'shape.obj' "$out/meshed.db"

# Several people: whose visit it is, is said.
sed "$pixels" "$config/rigs/two-people-quad-buffer.toml" >"$out/two.toml"
"$carom" cave --rig "$out/two.toml" --scenario three-pucks --session "$out/two.db" --frames 6 --no-window --silent 2>"$out/stderr" || fail "two people"
"$carom" page "$out/two.db" -o "$out/two.html" 2>"$out/stderr" || fail "a page of two people"
grep -q -- 'shows the visit of .*; --as chooses another of the 2' "$out/stderr" || fail "whose visit it is"

# What a page holds.
"$carom" page "$out/game.db" --game 1 -o "$out/before.html" 2>"$out/stderr" || fail "the page of the game before"
/usr/bin/python3 - "$out/page.html" "$out" "$config" "$(hostname)" "$(id -un)" <<'END' || fail "what a page holds"
import base64, pathlib, sys, zlib
def held_by(page):
    text = pathlib.Path(page).read_text()
    def letters(part):
        return base64.b64decode(text.split(f'id="{part}"', 1)[1].split(">", 1)[1].split("<", 1)[0])
    return [text.encode(), zlib.decompress(letters("visit")), zlib.decompress(letters("engine"), 31)]
held = held_by(sys.argv[1])
other_game = ["Zebra", "okapi"]
assert all(any(word.encode() in part for part in held_by(sys.argv[2] + "/before.html")) for word in other_game)
# Names of hosts and users as short as "vm" are in any text.
words = [*sys.argv[2:4], "/home/", "/tmp/", "/usr/", "head_sensor", ".toml", *other_game, *[name for name in sys.argv[4:] if len(name) > 4]]
for word in words:
    assert not any(word.encode() in part for part in held), word
assert b"default-src 'none'" in held[0] and b"MIT License" in held[0]
print("the page holds none of", ", ".join(words))
END
echo "faults: all said, none left a file"
