#!/usr/bin/env bash
# soft_session.sh CAROM CONFIG: a game with soft pucks, one of them rigid at first, gives the same pictures in 1, 2 and 4
# processes, and when it is replayed, from its beginning or from a later moment; a session that is resumed goes on with
# the same game, and so does one with the pucks in another order in the file. Touches and far sides are among its events.
. "$(dirname "$0")/../../session.sh"
needs python3
set -e
sed 's/^pixels = .*/pixels = [120, 120]/' "$config/rigs/four-walls-cluster.toml" >"$out/room.toml"

head='light_speed_m_s = 1.42
[board]
length_m = 0.9
width_m = 0.6
[observer]
position_m = [0.0, -0.6, -0.75]
'
soft='[[puck]]
name = "white"
radius_m = 0.06
height_m = 0.04
mass_kg = 0.2
position_m = [0.3, 0.05]
beta = [0.6, 0.0]
[puck.soft]
cells = 6
'
rigid='[[puck]]
name = "red"
radius_m = 0.06
height_m = 0.04
mass_kg = 0.2
position_m = [0.1, -0.02]
beta = [0.3, 0.0]
'
stroke='[[stroke]]
at_s = 0.02
from_m = [-0.2, -0.3, 0.1]
puck = "red"
momentum_kg_m_s = [0.05, 0.02]
'
echo "$head$soft$rigid$stroke" >"$out/one.toml"
echo "$head$rigid$soft$stroke" >"$out/two.toml"

play() { # RANKS SCENARIO FOLDER [MORE …]: retardation is off, so that what happens is on the walls at once
  local ranks=$1 scenario=$2 folder=$3
  shift 3
  "${mpi[@]}" -n "$ranks" "$carom" cave --rig "$out/room.toml" --scenario "$out/$scenario.toml" --frames 48 \
    --capture "$out/$folder" --no-window --switch retardation=off --switch colour=on "$@" 2>"$out/stderr" ||
    fail "a session in $ranks processes"
}
play 1 one one --session "$out/game.db"
for ranks in 2 4; do
  play "$ranks" one "of-$ranks"
  diff -rq "$out/one" "$out/of-$ranks" || fail "pictures differ: 1 and $ranks processes"
done
cmp -s "$out/one/front-left-000004.png" "$out/one/front-left-000047.png" && fail "nothing moved"

for order in one two; do
  "$carom" simulate "$out/$order.toml" --until 1.5 --json "$out/$order.json" 2>"$out/stderr" || fail "simulate $order"
done
python3 - "$out/one.json" "$out/two.json" <<'PYTHON' || fail "another order of the file gives another game"
import json, sys
one, two = (sorted(json.load(open(name))["pucks"], key=lambda puck: puck["name"]) for name in sys.argv[1:])
sys.exit(one != two or not all("heat_j" in puck for puck in one))
PYTHON

"$carom" replay "$out/game.db" --capture "$out/again" --no-window 2>"$out/stderr" || fail "a replay"
diff -rq "$out/one" "$out/again" || fail "pictures differ: replayed"
"$carom" replay "$out/game.db" --at 0.5 --capture "$out/later" --no-window 2>"$out/stderr" || fail "a replay from later on"
last=$(find "$out/later" -name 'front-left-*.png' | sort | tail -1)
cmp "$last" "$out/one/front-left-000047.png" || fail "pictures differ: replayed from a later moment"

# Its meshes for ParaView are those that the program sees: `observe` of the same moment has as many points.
"$carom" export "$out/game.db" --paraview "$out/meshes" --every 40 >"$out/table" 2>"$out/stderr" || fail "an export"
[ "$(find "$out/meshes" -name 'seen_*.vtp' | wc -l)" = 2 ] || fail "an export of $(ls "$out/meshes")"

"$carom" events "$out/game.db" --csv "$out/events.csv" >"$out/table"
for kind in soft-cushion soft-soft far-side; do
  grep -q ",$kind," "$out/events.csv" || fail "no event $kind in $(cut -d, -f2 "$out/events.csv" | tr '\n' ' ')"
done
"$carom" cave --rig "$out/room.toml" --scenario "$out/one.toml" --frames 24 --no-window --session "$out/parts.db" \
  2>"$out/stderr" || fail "the first part"
"$carom" cave --session "$out/parts.db" --resume --frames 24 --no-window 2>"$out/stderr" || fail "the second part"
"$carom" events "$out/parts.db" --until 0.6 --csv "$out/parts.csv" >"$out/table"
"$carom" events "$out/game.db" --until 0.6 --csv "$out/whole.csv" >"$out/table"
[ "$(cut -d, -f1-9 "$out/parts.csv")" = "$(cut -d, -f1-9 "$out/whole.csv")" ] || fail "a resumed session has other events"
echo "the same pictures of soft pucks in 1, 2 and 4 processes and replayed, the same game resumed and in another order"
