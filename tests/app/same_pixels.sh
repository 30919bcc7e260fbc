#!/usr/bin/env bash
# same_pixels.sh CAROM CONFIG: four walls drawn by 1, 2 and 4 processes, and twice by 1, are the same files,
# byte for byte, and there is something on them.
set -euo pipefail
carom=$1
config=$2
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

play() {  # RANKS FOLDER
  mpirun --allow-run-as-root --oversubscribe -n "$1" "$carom" cave --rig "$config/rigs/four-walls-cluster.toml" \
    --scenario "$config/scenarios/three-pucks.toml" --frames 6 --capture "$out/$2" --no-window
}

play 1 one
play 1 again
play 2 two
play 4 four

count=$(find "$out/one" -name '*.png' | wc -l)
[ "$count" -eq 48 ] || { echo "expected 4 walls x 2 eyes x 6 frames = 48 pictures, found $count"; exit 1; }
for other in again two four; do
  diff -r "$out/one" "$out/$other" || { echo "pictures differ: one process and '$other'"; exit 1; }
done
views=$(md5sum "$out"/one/*-000005.png | cut -d' ' -f1 | sort -u | wc -l)
[ "$views" -eq 8 ] || { echo "only $views of the 8 views of one frame are different from each other"; exit 1; }
if cmp -s "$out/one/front-left-000000.png" "$out/one/front-left-000005.png"; then
  echo "nothing moved between the first and the last frame"; exit 1
fi
echo "48 pictures, the same on 1, 2 and 4 processes and in a second run"
