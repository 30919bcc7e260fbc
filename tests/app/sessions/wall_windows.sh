#!/usr/bin/env bash
# wall_windows.sh CAROM CONFIG: windows of walls on the named monitors of one display: exact to the pixel, without
# border; and a monitor that is missing is named
# before any window opens.
. "$(dirname "$0")/../../session.sh"
set -e
needs xrandr xdotool xwininfo xprop sqlite3

# Two monitors beside each other, the second lower by 100 pixels, and one window on both.
xrandr --setmonitor left 960/254x600/159+0+0 screen
xrandr --setmonitor right 960/254x800/212+960+100 none

wall() { # NAME WINDOW STEREO
  cat <<RIG
[[wall]]
name = "$1"
lower_left = [-1.5, 0.0, -1.5]
lower_right = [1.5, 0.0, -1.5]
upper_left = [-1.5, 3.0, -1.5]
pixels = [64, 64]
window = { $2 }
stereo = "mono"
RIG
}
rig() { # WALLS: on standard output
  printf 'axes = "x-right y-up z-back"\nunit = "m"\n[head]\ntracker = "person"\n[[tracker]]\nname = "person"\nkind = "simulated"\n'
  cat
}
# Runs a session and holds it while its windows are looked at.
begin() { # RIG
  "$carom" cave --rig "$1" --scenario three-pucks --silent 2>"$out/stderr" &
  job=$!
  for _ in $(seq 600); do
    grep -q "empty frames were swapped" "$out/stderr" && return
    kill -0 $job 2>/dev/null || fail "the session ended"
    sleep 0.1
  done
  fail "the session did not begin"
}
end() {
  kill -TERM $job
  wait $job || true
  job=
}
lies() { # WALL WIDTHxHEIGHT+X+Y
  local id place
  id=$(xdotool search --limit 1 --name "Carom: $1") || fail "there is no window of $1"
  place=$(xwininfo -id "$id" | awk '/Absolute upper-left X/ {x = $4} /Absolute upper-left Y/ {y = $4} /Width:/ {w = $2}
    /Height:/ {h = $2} END {printf "%dx%d+%d+%d", w, h, x, y}')
  [ "$place" = "$2" ] || fail "the window of $1 is $place, expected $2"
  [ "$(xwininfo -id "$id" | awk '/Border width/ {print $3}')" = 0 ] || fail "the window of $1 has a border"
  xprop -id "$id" _MOTIF_WM_HINTS | grep -qE '= 0x2, 0x0, 0x0,' || fail "the window of $1 asks for a border: $(xprop -id "$id" _MOTIF_WM_HINTS)"
  xprop -id "$id" _NET_WM_BYPASS_COMPOSITOR | grep -q '= 1$' || fail "the window of $1 leaves itself to a compositor"
  echo "the window of $1: $place"
}

{ wall a 'monitor = "left", size = [10, 10], fullscreen = true'
  wall b 'monitor = "right", position = [7, 9], size = [333, 222]'; } | rig >"$out/two.toml"
begin "$out/two.toml"
lies a 960x600+0+0
lies b 333x222+967+109
end

{ wall a 'monitor = ["right", "left"], size = [10, 10], fullscreen = true, viewport = { position = [0, 0], size = [5, 10] }'
  wall b 'monitor = ["right", "left"], size = [10, 10], fullscreen = true, viewport = { position = [5, 0], size = [5, 10] }'
} | rig >"$out/span.toml"
begin "$out/span.toml"
lies a 1920x900+0+0
end

# One window for all walls, where one computer draws those of four.
begin "$config/rigs/cylinder.toml"
xdotool search --limit 1 --name "Carom: arc-1, arc-2, arc-3, arc-4" >/dev/null || fail "there is no window of all four walls"
end

for place in 0,0 333,0 0,111 333,111; do
  wall "w${place/,/-}" "monitor = \"right\", position = [${place/,/, }], size = [333, 111]"
done | rig >"$out/four.toml"
begin "$out/four.toml"
lies w0-0 333x111+960+100
lies w333-0 333x111+1293+100
lies w0-111 333x111+960+211
lies w333-111 333x111+1293+211
end

wall a 'monitor = ["left", "middle"], size = [10, 10]' | rig >"$out/missing.toml"
! "$carom" cave --rig "$out/missing.toml" --silent 2>"$out/stderr" || fail "a session on a missing monitor began"
grep -qE '^error: wall a: there is no monitor "middle", expected one of 0 "(left|right)", 1 "(left|right)"$' "$out/stderr" ||
  fail "of a missing monitor"
echo "$(cat "$out/stderr")"
