#!/usr/bin/env bash
# same_pixels.sh CAROM CONFIG: five walls drawn by 1, 2, 4 and 5 processes, twice by 1, and with 1 and with 2 threads
# to draw with, are the same files, byte for byte, and there is something on them. With every effect on; by 1, 2 and 4
# processes also with spacetime in the room. What a projector does to a wall's picture is not in its file.
. "$(dirname "$0")/../../session.sh"
set -e
sed 's/^pixels = .*/pixels = [240, 240]/' "$config/rigs/five-walls-cluster.toml" >"$out/room.toml"

play() {  # RANKS FOLDER [THREADS of the processor that stands in for a graphics card] [VIEW]
  mpirun --allow-run-as-root --oversubscribe -n "$1" ${3:+-x LP_NUM_THREADS=$3} \
    "$carom" cave --rig "$out/room.toml" --scenario "$config/scenarios/three-pucks.toml" --frames 3 \
    --capture "$out/$2" --no-window --switch colour=on --switch searchlight=on ${4:+--view $4}
}

play 1 one
play 1 again
play 2 two
play 4 four
play 5 five
play 1 one-thread 1
play 5 two-threads 2
play 1 glass-one "" spacetime
play 2 glass-two "" spacetime
play 4 glass-four 2 spacetime

count=$(find "$out/one" -name '*.png' | wc -l)
[ "$count" -eq 30 ] || { echo "expected 5 walls x 2 eyes x 3 frames = 30 pictures, found $count"; exit 1; }
for other in again two four five one-thread two-threads; do
  diff -r "$out/one" "$out/$other" || { echo "pictures differ: one process and '$other'"; exit 1; }
done
for other in glass-two glass-four; do
  diff -r "$out/glass-one" "$out/$other" || { echo "pictures of spacetime differ: one process and '$other'"; exit 1; }
done
cmp -s "$out/one/right-left-000002.png" "$out/glass-one/right-left-000002.png" &&
  { echo "spacetime does not stand in the room"; exit 1; }
views=$(md5sum "$out"/one/*-000002.png | cut -d' ' -f1 | sort -u | wc -l)
[ "$views" -eq 10 ] || { echo "only $views of the 10 views of one frame are different from each other"; exit 1; }
if cmp -s "$out/one/front-left-000000.png" "$out/one/front-left-000002.png"; then
  echo "nothing moved between the first and the last frame"; exit 1
fi

rig=$config/rigs/single-screen.toml
sed 's/^pixels = .*/&\nflip = "both"\nblack_level = 0.3/' "$rig" >"$out/projector.toml"
"$carom" cave --rig "$rig" --frames 2 --capture "$out/plain"
"$carom" cave --rig "$out/projector.toml" --frames 2 --capture "$out/projected"
[ -e "$out/plain/screen-mono-000001.png" ] || { echo "nothing was captured beside a window"; exit 1; }
diff -r "$out/plain" "$out/projected" || { echo "captured pictures differ where there is a projector"; exit 1; }
echo "30 pictures, the same on 1, 2, 4 and 5 processes, with 1 and 2 threads, and in a second run; 30 with spacetime"
