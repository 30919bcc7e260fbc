#!/usr/bin/env bash
# welcome.sh CAROM CONFIG [PICTURES]: a visitor's first minute: `carom cave` opens on a game that already runs; the right
# mouse button turns the room; a click on "Show me", then F6, F7 and F6 lead to the show, the first lesson, back, and
# to the second lesson; F8 puts everything back for the next visitor. With PICTURES, screenshots of each step are left there to be looked at.
. "$(dirname "$0")/../../session.sh"
needs xdotool sqlite3
pictures=${3:-}
"$carom" cave --session "$out/visit.db" 2>"$out/stderr" &
job=$!
sql() { # 0 of a file that is not there yet
  if [ -s "$out/visit.db" ]; then sqlite3 "$out/visit.db" "$1" 2>/dev/null || echo 0; else echo 0; fi
}
frames() { # since the game of this number began
  sql "SELECT count(*) FROM frame WHERE number >= (SELECT first_frame FROM game ORDER BY first_frame LIMIT 1 OFFSET $1 - 1)"
}
await_frames() { # GAME COUNT
  for _ in $(seq 900); do
    [ "$(frames "$1")" -ge "$2" ] && return
    sleep 0.1
  done
  fail "game $1 has too few frames: $(frames "$1")"
}
picture() { # NAME
  [ -z "$pictures" ] || ffmpeg -y -loglevel error -f x11grab -video_size 1920x1200 -i "$DISPLAY" -frames:v 1 "$pictures/$1.png"
}

await_frames 1 10
picture 1-first
window=$(xdotool search --name "Carom: screen" | head -1)
eval "$(xdotool getwindowgeometry --shell "$window")"
before=$(frames 1)
xdotool mousemove $((X + 900)) $((Y + 360)) mousedown 3
await_frames 1 $((before + 3))
xdotool mousemove $((X + 500)) $((Y + 360))
await_frames 1 $((before + 8))
xdotool mouseup 3
picture 2-turned
press 4 screen
await_frames 1 $((before + 12))

xdotool mousemove $((X + 1143)) $((Y + 66)) # Show me
await_frames 1 $((before + 16))
picture 3-pointed
xdotool mousedown 1
await_frames 2 5
xdotool mouseup 1
picture 3-show-me
game=2
for key in F6 F7 F6 F8; do
  press $key screen
  game=$((game + 1))
  await_frames $game 5
  picture "3-$key"
done
end_session screen
wait "$job" || fail "the session did not end well"
job=
second=$(sql "SELECT first_frame FROM game ORDER BY first_frame LIMIT 1 OFFSET 1")
turned=$(sql "SELECT max(board_from_room_xx) - min(board_from_room_xx) > 0.01 FROM frame WHERE number < $second")
[ "$turned" = 1 ] || fail "the right mouse button did not turn the room"
for expected in "2 show-me" "3 comes-and-goes" "4 welcome" "5 seen-at-once" "6 welcome"; do
  read -r number name <<<"$expected"
  played=$(sql "SELECT scenario FROM game ORDER BY first_frame LIMIT 1 OFFSET $number - 1")
  [ "$played" = "$(cat "$config/scenarios/$name.toml")" ] || fail "game $number is not $name"
done
first=$(sql "SELECT switches FROM frame ORDER BY number LIMIT 1")
[ "$(sql "SELECT switches FROM frame WHERE number < $second ORDER BY number DESC LIMIT 1")" != "$first" ] ||
  fail "key 4 changed no switch"
[ "$(sql "SELECT switches FROM frame ORDER BY number DESC LIMIT 1")" = "$first" ] ||
  fail "the next visitor has other switches"
echo "a running game, a turn, a choice on the wall, and four keys"
