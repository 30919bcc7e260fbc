#!/usr/bin/env bash
# frame_jitter.sh [PROGRAM [SECONDS]]: how evenly the frames of a session follow each other: one wall in a window, in real
# time at 60 Hz, 96 × 54 pixels, so that a processor that stands in for a graphics card keeps up. What the program says
# at the end of its node. Needs an X display. Exit status 1 where over 1 % of the frames came more than 2 ms late.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
program=${1:-$here/../../build/release/bin/carom}
seconds=${2:-60}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
sed 's/^pixels = .*/pixels = [96, 54]/; s/size = \[1280, 720\]/size = [96, 54]/' \
  "$here/../../config/rigs/single-screen.toml" >"$out/screen.toml"
timeout -s TERM "$seconds" "$program" cave --rig "$out/screen.toml" 2>"$out/said" || true
grep '^node 0' "$out/said" || { cat "$out/said"; exit 1; }
late_ms=$(sed -n 's/^node 0.*99 % at most \([0-9.]*\) ms late.*/\1/p' "$out/said")
awk "BEGIN { exit !($late_ms <= 2) }" || { echo "expected 99 % at most 2 ms late"; exit 1; }
