#!/usr/bin/env bash
# console_clicks.sh CAROM CONFIG: the operator's console opens where the rig says, and clicks and keys in it are the
# session's: they are in its file. Skipped without xdotool.
. "$(dirname "$0")/../../session.sh"
needs xdotool sqlite3

# Where the console is, and in it the middles of what is clicked (app/console/console.cpp lays it out).
left=20 top=20
retardation="209 168" my_light="224 339" board_now="31 421" keys="1060 42" black="1185 42" again="500 717"

sed "s/^pixels = .*/pixels = [64, 36]/; s/^window = .*/window = { position = [1500, 900], size = [64, 36] }/" \
  "$config/rigs/single-screen.toml" >"$out/room.toml"
printf '\n[console]\nwindow = { position = [%d, %d], size = [1280, 860] }\n' $left $top >>"$out/room.toml"

rows() { [ -s "$out/game.db" ] && sqlite3 -cmd '.timeout 5000' "$out/game.db" "$1" 2>/dev/null; }
await() { # WHAT SQL VALUE [FILE]: until the file says so
  for _ in $(seq 1200); do
    [ "$(rows "$2")" = "$3" ] && return
    kill -0 "$job" 2>/dev/null || fail "$1: the session has ended"
    sleep 0.1
  done
  fail "$1: '$(rows "$2")', expected '$3'; done so far: $(rows 'SELECT what, value FROM input')"
}
click() { # X Y
  xdotool mousemove $((left + $1)) $((top + $2)) click 1
}
frames() { # N: until so many more frames were shown, and the console with them
  local shown
  shown=$(rows 'SELECT count(*) FROM frame')
  await "$1 more frames" "SELECT count(*) >= $((shown + $1)) FROM frame" 1
}
newest() { echo "SELECT value FROM input WHERE what = '$1' ORDER BY rowid DESC LIMIT 1"; }

"$carom" cave --rig "$out/room.toml" --scenario three-pucks --console --session "$out/game.db" 2>"$out/stderr" &
job=$!
await "the session begins" 'SELECT count(*) > 5 FROM frame' 1

click $retardation
await "a switch" "$(newest retardation)" off
click $retardation
await "the switch again" "$(newest retardation)" on
click $board_now
await "a view" "$(newest board-now)" on
click $black
await "black walls" "$(newest walls)" black
click $black
await "walls that are lit again" "$(newest walls)" lit
click $my_light
await "the speed of light" "SELECT value + 0 > 10 FROM input WHERE what = 'light speed'" 1

# While the keys are shown they are for that list alone, and Escape closes it.
click $keys
frames 40
xdotool key p
frames 20
xdotool key Escape
frames 40
xdotool key c
await "a key" "$(newest clocks)" on
[ "$(rows "SELECT count(*) FROM input WHERE what = 'paths'")" -eq 0 ] || fail "a key went past the list of keys"

click $again
await "the game from its beginning, as another one of the same file" \
  'SELECT count(*) = 2 AND (SELECT max(number) FROM frame) > max(first_frame) + 5 FROM game' 1
xdotool key Escape Escape
wait "$job" || fail "the session did not end well"
job=
[ "$(rows 'PRAGMA integrity_check')" = ok ] || fail "the session file is not whole"
# The last frame of the first game is drawn as it was wanted: retardation, contraction, aberration; now on the board, clocks.
[ "$(rows 'SELECT switches, views FROM frame WHERE number < (SELECT max(first_frame) FROM game) ORDER BY number DESC LIMIT 1')" = "7|17" ] ||
  fail "the last frame: $(rows 'SELECT switches, views FROM frame ORDER BY number DESC LIMIT 1')"
rows 'SELECT frame, what, value FROM input'
