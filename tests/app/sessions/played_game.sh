#!/usr/bin/env bash
# played_game.sh CAROM CONFIG [PICTURES]: a game played with the mouse in a real window: aim at the white puck, draw
# back, shoot it at the red one, see them collide, end; then the same game replayed from the other side of the
# table, paused, gone back in, ended. With PICTURES, screenshots of each step are left there to be looked at.
. "$(dirname "$0")/../../session.sh"
needs xdotool ffmpeg python3
python3 "$(dirname "$0")/played_game.py" "$1" "$2" "$out" "${3:-$out}"
