#!/usr/bin/env bash
# first_minute.sh CAROM PICTURES: the first minute of a new user, by hand, to be looked at: on a display of 1920 × 1080
# opens `carom cave --console`, strikes a puck, turns the view and asks for the show, and leaves screenshots at 0, 10, 30
# and 60 s in PICTURES. Says what the session file holds then. Needs xvfb-run, xdotool, ffmpeg and sqlite3.
set -euo pipefail
if [ -z "${FIRST_MINUTE_DISPLAY:-}" ]; then
  export FIRST_MINUTE_DISPLAY=1
  exec xvfb-run -a -s "-screen 0 1920x1080x24" "$0" "$@"
fi
carom=$1
pictures=$2
mkdir -p "$pictures"
out=$(mktemp -d)
trap 'kill "$job" 2>/dev/null || true; rm -rf "$out"' EXIT
export XDG_CONFIG_HOME=$out
"$carom" cave --console --session "$out/visit.db" 2>"$pictures/stderr.txt" &
job=$!
until [ -n "$(xdotool search --name "Carom: screen" 2>/dev/null)" ]; do kill -0 "$job" && sleep 0.2; done
frames() { if [ -e "$out/visit.db" ]; then sqlite3 "$out/visit.db" 'SELECT count(*) FROM frame' 2>/dev/null || echo 0; else echo 0; fi; }
until [ "$(frames)" -ge 3 ]; do sleep 0.2; done
begun=$SECONDS
picture() { # SECOND
  while [ $((SECONDS - begun)) -lt "$1" ]; do sleep 0.1; done
  ffmpeg -y -loglevel error -f x11grab -video_size 1920x1080 -i "$DISPLAY" -frames:v 1 "$pictures/second-$1.png"
}
window=$(xdotool search --name "Carom: screen" | head -1)
eval "$(xdotool getwindowgeometry --shell "$window")"
at() { xdotool mousemove $((X + WIDTH * $1 / 1000)) $((Y + HEIGHT * $2 / 1000)); } # in thousandths of the window
picture 0
# Draws back from the marked puck, in the lower middle of the picture.
for stroke in "500 700" "480 690" "520 720"; do
  at $stroke
  sleep 1
  xdotool mousedown 1
  for step in 1 2 3 4; do
    read -r x y <<<"$stroke"
    at $x $((y + 30 * step))
    sleep 0.4
  done
  xdotool mouseup 1
done
picture 10
at 700 500
xdotool mousedown 3
for x in 650 600 550 500; do at $x 500; sleep 0.5; done
xdotool mouseup 3
picture 30
xdotool key --window "$window" F5
picture 60
xdotool key --window "$window" Escape Escape
wait "$job" || true
for game in "$out/visit.db"; do
  echo "$(basename "$game"): $(sqlite3 "$game" "SELECT count(*) || ' frames, ' || (SELECT count(*) FROM stroke) ||
    ' strokes, turned: ' || (max(board_from_room_xx) - min(board_from_room_xx) > 0.01) FROM frame")"
done
