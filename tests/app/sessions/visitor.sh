#!/usr/bin/env bash
# visitor.sh CAROM CONFIG [PICTURES]: a visitor with a mouse and nothing else: a stroke at the ringed puck, the tasks, Show me,
# the colour, back to play, on a small and on a large screen (visitor.py). With PICTURES, screenshots of each step are
# left there to be looked at.
. "$(dirname "$0")/../../session.sh"
needs xvfb-run xdotool sqlite3 python3 ffmpeg
for size in 1280x720 1920x1200; do
  xvfb-run -a -s "-screen 0 ${size}x24" python3 "$(dirname "$0")/visitor.py" "$carom" "$out/$size" "$size" "${3:-}" ||
    fail "on a screen of $size"
done
