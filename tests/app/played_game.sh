#!/usr/bin/env bash
# played_game.sh CAROM CONFIG [PICTURES]: a game played with the mouse in a real window: aim at the white puck, draw
# back, shoot it at the red one, see them collide, end; then the same game replayed from the other side of the
# table, paused, gone back in, ended. With PICTURES, screenshots of each step are left there to be looked at.
set -uo pipefail
for tool in xdotool ffmpeg python3; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
python3 "$(dirname "$0")/played_game.py" "$1" "$2" "$out" "${3:-$out}"
