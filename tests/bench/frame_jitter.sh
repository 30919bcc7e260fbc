#!/usr/bin/env bash
# frame_jitter.sh [PROGRAM [SECONDS]]: how evenly the frames of a session follow each other: one wall in a window, in real
# time at 60 Hz, 96 × 54 pixels. First with the wall turned away from the person, so that nothing is drawn and any
# machine keeps up: exit status 1 where over 1 % of the frames came more than 2 ms late. Then with the scene, as far as
# the machine sustains it. What the program says at the end of its node. Needs an X display.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
program=${1:-$here/../../build/release/bin/carom}
seconds=${2:-60}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
sed 's/^pixels = .*/pixels = [96, 54]/; s/size = \[1280, 720\]/size = [96, 54]/' \
  "$here/../../config/rigs/single-screen.toml" >"$out/scene.toml"
# Two corners exchanged: the wall is seen from outside.
sed 's/^lower_right/lower__right/; s/^upper_left/lower_right/; s/^lower__right/upper_left/' "$out/scene.toml" \
  >"$out/turned-away.toml"
for rig in turned-away scene; do
  timeout -s TERM "$seconds" "$program" cave --rig "$out/$rig.toml" 2>"$out/$rig.said" || true
  line=$(grep '^node 0' "$out/$rig.said") || { cat "$out/$rig.said"; exit 1; }
  echo "$rig: $line"
done
late_ms=$(sed -n 's/^node 0.*99 % at most \([0-9.]*\) ms late.*/\1/p' "$out/turned-away.said")
awk "BEGIN { exit !($late_ms <= 2) }" || { echo "expected 99 % at most 2 ms late"; exit 1; }
