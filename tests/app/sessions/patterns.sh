#!/usr/bin/env bash
# patterns.sh CAROM CONFIG: the patterns of a cluster's rig are the same files on 1 and on 2 processes, each wall's
# and eye's own; on windows they stay until somebody ends them; what has no walls is refused.
. "$(dirname "$0")/../../session.sh"
set -e
rig=$config/rigs/four-walls-cluster.toml

for ranks in 1 2; do
  mpirun --allow-run-as-root --oversubscribe -n $ranks "$carom" check "$rig" --pattern --capture "$out/$ranks"
done
diff -r "$out/1" "$out/2" || { echo "the pictures differ between 1 and 2 processes"; exit 1; }
count=$(find "$out/1" -name '*.png' | wc -l)
[ "$count" -eq 32 ] || { echo "expected 4 walls x 2 eyes x 4 frames = 32 pictures, found $count"; exit 1; }
stills=$(md5sum "$out"/1/*-000000.png | cut -d' ' -f1 | sort -u | wc -l)
[ "$stills" -eq 8 ] || { echo "only $stills of the 8 test patterns are different from each other"; exit 1; }
cmp -s "$out"/1/front-left-00000{1,2}.png && { echo "the seam pattern stands still"; exit 1; }

"$carom" check "$config/rigs/desk.toml" --pattern 2>"$out/said" &
shown=$!
for _ in $(seq 600); do
  grep -q '^Keys: T' "$out/said" && break
  sleep 0.1
done
grep -q '^Keys: T' "$out/said" || { echo "the keys are not said"; cat "$out/said"; exit 1; }
sleep 2
kill -0 "$shown" 2>/dev/null || { echo "the windows did not stay"; cat "$out/said"; exit 1; }
kill "$shown"
wait "$shown" || true

if "$carom" check "$config/scenarios/three-pucks.toml" --pattern 2>"$out/said"; then
  echo "a scenario has no walls, but its pattern was shown"; exit 1
fi
grep -q 'there is no wall here' "$out/said" || { cat "$out/said"; exit 1; }
echo "the patterns are the same on 1 and 2 processes; windows stay; a scenario is refused"
