#!/usr/bin/env bash
# by_mouse.sh CAROM CONFIG: a dry run of a room of four walls without its trackers. Real keys and a real mouse move head
# and wand, the wand strikes a puck, no tracker of the rig is opened, and the recording is replayed with the same
# pictures. On two processes, too.
. "$(dirname "$0")/../../session.sh"
needs python3 xdotool sqlite3
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1

# What the rig's trackers would be: a server that notes whoever calls, and a port that is taken.
python3 - "$out" <<'PYTHON' &
import socket, sys, time
server = socket.create_server(("127.0.0.1", 0))
taken = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
taken.bind(("0.0.0.0", 0))
with open(sys.argv[1] + "/ports.new", "w") as file:
    print(server.getsockname()[1], taken.getsockname()[1], file=file)
import os
os.rename(sys.argv[1] + "/ports.new", sys.argv[1] + "/ports")
server.accept()
open(sys.argv[1] + "/called", "w").close()
PYTHON
listener=$!
trap '[ -z "$job" ] || kill -9 "$job" 2>/dev/null; kill "$listener" 2>/dev/null; rm -rf "$out"' EXIT
for _ in $(seq 100); do [ -s "$out/ports" ] && break; sleep 0.1; done
read -r vrpn dtrack <"$out/ports" || fail "the listener did not begin"

room() { # TRACKERS: a room of four walls in four windows, for the trackers that follow
  cat <<RIG
axes = "x-right y-up z-back"
unit = "m"
$1
RIG
  local x=0 name
  for name in front left right floor; do
    cat <<RIG
[[wall]]
name = "$name"
$(sed -n "/^name = \"$name\"/,/^pixels/p" "$config/rigs/four-walls-cluster.toml" | grep -E "^(lower|upper)")
pixels = [96, 96]
node = $((x / 720))
window = { position = [$x, 0], size = [360, 360] }
stereo = "mono"
RIG
    x=$((x + 360))
  done
}
room "[head]
tracker = \"art\"
eyes_from_sensor = { translation = [0, -0.1, 0.1], rotation_deg = [10, 20, 30] }
[hand]
tracker = \"wand\"
buttons = \"wand-buttons\"
[[tracker]]
name = \"art\"
kind = \"dtrack\"
source = \"udp://0.0.0.0:$dtrack\"
room_from_tracker = { translation = [1, 2, 3], rotation_deg = [90, 0, 0] }
[[tracker]]
name = \"wand\"
kind = \"vrpn\"
source = \"Wand@tcp://127.0.0.1:$vrpn\"
[[tracker]]
name = \"wand-buttons\"
kind = \"vrpn\"
source = \"Buttons@tcp://127.0.0.1:$vrpn\"" >"$out/room.toml"
room '[head]
tracker = "usb"
[[tracker]]
name = "usb"
kind = "polhemus-usb"
source = "0f44:ff12"' >"$out/no-hand.toml"

db=$out/game.db
rows() { [ -s "$db" ] && sqlite3 -cmd '.timeout 5000' "$db" "$1" 2>/dev/null; }
await() { # WHAT SQL VALUE: until the session file says so
  for _ in $(seq 1200); do
    [ "$(rows "$2")" = "$3" ] && return
    kill -0 "$job" 2>/dev/null || fail "$1: the session has ended"
    sleep 0.1
  done
  fail "$1: '$(rows "$2")', expected '$3'"
}
newest() { echo "SELECT $1 FROM $2 WHERE frame = (SELECT max(number) FROM frame)"; }
frame() { echo "SELECT $1 FROM frame ORDER BY number DESC LIMIT 1"; }
focus() { xdotool windowfocus "$(xdotool search --name "Carom: front" | head -1)" 2>/dev/null || true; }

play() { # RIG: starts a session
  rm -f "$db"
  "$carom" cave --by-mouse --rig "$1" --scenario table --silent --session "$db" --capture "$out/live" 2>"$out/stderr" &
  job=$!
  await "the session begins" 'SELECT count(*) > 5 FROM frame' 1
  focus
}
finish() {
  kill -TERM "$job"
  wait "$job" || fail "the session did not end well"
  job=
}
replayed() { # the pictures of the replay are those of the session, of which some came too fast to be written
  "$carom" replay "$db" --capture "$out/again" --no-window 2>"$out/stderr" || fail "the session cannot be replayed"
  local count other
  count=$(find "$out/live" -name '*.png' | wc -l)
  other=$(diff -rq "$out/live" "$out/again" 2>&1 | grep -v "^Only in $out/again" | head -3)  # a busy machine makes many thousands
  [ -z "$other" ] || fail "another picture in the replay: $other"
  [ $count -gt 40 ] || fail "only $count pictures"
  echo "$count pictures, the same again"
  rm -rf "$out/live" "$out/again"
}

play "$out/room.toml"
grep -q "walk in the room" "$out/stderr" || fail "the keys are not listed"
[ "$(rows "$(newest 'abs(room_y_m - 1.7) < 0.01 AND abs(room_z_m) < 0.01' viewer)")" = 1 ] || fail "the head does not stand in the middle"
xdotool keydown Up
await "walking to the front" "$(newest 'room_z_m < -0.4' viewer)" 1
xdotool keyup Up
xdotool keydown Right
await "walking to the right" "$(newest 'room_x_m > 0.2' viewer)" 1
xdotool keyup Right
xdotool keydown Page_Down
await "a lower head" "$(newest 'room_y_m < 1.6' viewer)" 1
xdotool keyup Page_Down
await "standing still" "$(newest 'celerity_x_m_s*celerity_x_m_s + celerity_z_m_s*celerity_z_m_s < 1e-4' viewer)" 1
grep -q "This key does nothing" <(rows "SELECT value FROM input") && fail "an arrow is said to do nothing"
# The wand points where the mouse does, on each wall: to the walls' planes.
for wall in "180 front cue_to_z_m<-1.4" "540 left cue_to_x_m<-1.4" "900 right cue_to_x_m>1.4"; do
  read -r x name condition <<<"$wall"
  xdotool mousemove $((x + 20)) 60
  sleep 0.2
  xdotool mousemove "$x" 60
  await "the wand points to the wall $name" "$(frame "cue_shown = 1 AND ${condition}")" 1
done
# A puck is struck with the wand. The mouse moves to where the line from the wand through the white puck (at rest, so seen
# where it is: config/scenarios/table.toml) meets a wall; as the wand turns with the head, it takes a few steps.
puck_behind() { # prints the pixel of the display
  rows "$(frame "cue_from_x_m || ' ' || cue_from_y_m || ' ' || cue_from_z_m")" | python3 -c '
wand = [float(number) for number in input().split()]
way = [to - at for to, at in zip((-0.5, 0.75 + 0.01, -1.3), wand)]
# Each wall: its window, the coordinate of its plane and where that is, and where on it a place is: right and up.
walls = [(0, 2, -1.5, lambda m: (m[0] + 1.5, m[1])), (360, 0, -1.5, lambda m: (1.5 - m[2], m[1])),
         (720, 0, 1.5, lambda m: (m[2] + 1.5, m[1])), (1080, 1, 0.0, lambda m: (m[0] + 1.5, 1.5 - m[2]))]
met = []
for window, axis, plane, on in walls:
    share = (plane - wand[axis]) / way[axis] if way[axis] else -1
    if share > 0:
        met.append((share, window, on([at + share * along for at, along in zip(wand, way)])))
share, window, (right, up) = min(met)
print(window + round(right * 120), round((3 - up) * 120))'
}
for _ in $(seq 100); do
  read -r x y < <(puck_behind)
  xdotool mousemove "$x" "$y"
  sleep 0.5
  [ "$(rows "$(frame 'cue_target > 0')")" = 1 ] && [ "$(puck_behind)" = "$x $y" ] && break
done
[ "$(rows "$(frame 'cue_target > 0')")" = 1 ] || fail "the wand does not find the puck: the mouse is at $x $y"
xdotool mousedown 1
await "the cue is held" "$(frame 'cue_pulling')" 1
for step in 1 2 3 4 5; do
  xdotool mousemove $((x + 6 * step)) $((y + 12 * step < 355 ? y + 12 * step : 355))
  sleep 0.1
done
await "the cue is drawn" "$(frame 'cue_u > 0.05')" 1
xdotool mouseup 1
await "the stroke" 'SELECT count(*) FROM stroke' 1
xdotool keydown Delete
sleep 0.5
xdotool keyup Delete
finish
[ -e "$out/called" ] && fail "the rig's VRPN server was called"
grep -E "^(warning: )?Tracker|silent since|delivers" "$out/stderr" && fail "something was said about trackers"
[ "$(rows "SELECT group_concat(DISTINCT tracker) FROM sample")" = "mouse and keys" ] ||
  fail "samples of $(rows "SELECT group_concat(DISTINCT tracker) FROM sample")"
replayed

# A rig without a wand, whose tracker is not plugged in, gets one as well.
play "$out/no-hand.toml"
xdotool mousemove 180 60
sleep 0.3
xdotool mousemove 200 80
await "the wand of a rig without one" "$(frame 'cue_shown')" 1
finish
grep -E "^Tracker|plugged" "$out/stderr" && fail "a device was looked for"
replayed

# On two processes.
rm -f "$db"
"$carom" room "$out/room.toml" --by-mouse --scenario table --silent --session "$db" 2>"$out/stderr" &
job=$!
await "a session on two nodes" 'SELECT count(*) > 5 FROM frame' 1
focus
xdotool keydown Left
await "walking on two nodes" "$(newest 'room_x_m < -0.3' viewer)" 1
xdotool keyup Left
finish
[ -e "$out/called" ] && fail "the rig's VRPN server was called"

# A headset has no walls to stand between.
"$carom" cave --by-mouse --rig headset --frames 1 --no-window 2>"$out/stderr" && fail "a headset was taken"
grep -q "^error: --by-mouse: this rig is a headset" "$out/stderr" || fail "of a headset"
echo "a dry run without trackers"
