#!/usr/bin/env bash
# french_keyboard.sh CAROM CONFIG [PICTURE]: on a French keyboard the list of keys names Z Q S D and ^ $ where a US one has
# W A S D and [ ], and these keys, really pressed, steer and change the light's speed. After a change to a German layout the
# list names its keys. Without a window, and in a replay, the keys are a US keyboard's. With PICTURE, a screenshot of the
# list is left there.
. "$(dirname "$0")/../../session.sh"
needs xdotool sqlite3 setxkbmap
picture=${3:-}
trap '[ -z "$job" ] || kill -9 "$job" 2>/dev/null; setxkbmap us 2>/dev/null; rm -rf "$out"' EXIT
setxkbmap fr || { echo "skipped: this display's keyboard has no layouts"; exit 77; }
"$carom" cave --scenario table --silent --session "$out/game.db" 2>"$out/stderr" &
job=$!
rows() { [ -s "$out/game.db" ] && sqlite3 -cmd '.timeout 5000' "$out/game.db" "$1" 2>/dev/null; }
await() { # WHAT SQL VALUE: until the session file says so
  for _ in $(seq 600); do
    [ "$(rows "$2")" = "$3" ] && return
    kill -0 "$job" 2>/dev/null || fail "$1: the session has ended"
    sleep 0.1
  done
  fail "$1: '$(rows "$2")', expected '$3'"
}
said() { # WORDS: in the newest list of keys
  for _ in $(seq 100); do
    grep "^Keys:" "$out/stderr" | tail -1 | grep -qF -- "$1" && return
    sleep 0.1
  done
  fail "the keys are not named '$1': $(grep "^Keys:" "$out/stderr" | tail -1)"
}
newest() { echo "SELECT $1 FROM frame ORDER BY number DESC LIMIT 1"; }
lists() { xdotool key h; await "key H" "SELECT count(*) FROM input WHERE what = 'keys'" "$1"; }

await "the session begins" 'SELECT count(*) > 5 FROM frame' 1
xdotool windowfocus "$(xdotool search --name "Carom: screen" | head -1)" 2>/dev/null
said "Z Q S D steer: forward, left, back, right"
said "^ $ slower and faster light"
said "Escape A end"
said ", ghosts: now, in my frame"
said "F9 the next language"
for step in "z thrust_z<0" "q thrust_x<0" "s thrust_z>0" "d thrust_x>0"; do
  read -r key steers <<<"$step"
  xdotool keydown "$key"
  await "$key steers" "$(newest "$steers")" 1
  xdotool keyup "$key"
  await "$key no longer steers" "$(newest 'thrust_x = 0 AND thrust_z = 0')" 1
done
xdotool key 35 # the code of X for the key of $, since another one has it with AltGr
await "\$ makes light faster" "SELECT count(*) FROM input WHERE what = 'light speed'" 1
await "light is faster" "$(newest 'light_speed_m_s > 1.43')" 1
xdotool key 34
await "^ makes light slower again" "$(newest 'abs(light_speed_m_s - 1.42) < 1e-9')" 1
lists 1
if [ -n "$picture" ]; then
  sleep 1
  ffmpeg -y -loglevel error -f x11grab -video_size 1920x1200 -i "$DISPLAY" -frames:v 1 "$picture"
fi
setxkbmap de
lists 2
lists 3 # the key with which the change was noticed came first
said "Z restart this game"
said "Y strain of soft pucks"
said "W A S D steer"
end_session screen
wait "$job" || fail "the session did not end well"
job=

setxkbmap fr
"$carom" replay "$out/game.db" --silent 2>"$out/replayed" & # in a window
job=$!
for _ in $(seq 300); do grep -q "^Keys:" "$out/replayed" && break; sleep 0.1; done
grep "^Keys:" "$out/replayed" | grep -qF "Z strain of soft pucks" || fail "a replay names the keys of this keyboard"
kill -TERM "$job"
wait "$job"
job=
echo "Z Q S D and ^ \$ are named, and steer; a German layout is noticed; a replay has US names"
