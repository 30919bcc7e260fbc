#!/usr/bin/env bash
# doctor.sh CAROM CONFIG: what `carom doctor` says of this machine, of a rig that it cannot show, of four nodes, of a
# compositor, and of Xwayland under a Wayland compositor. The last two are skipped, with words, where none is installed.
set -euo pipefail
carom=$1
config=$2
work=$(mktemp -d)
helper=
trap '[ -z "$helper" ] || kill "$helper"; wait; rm -rf "$work"' EXIT
status=0
fail() { echo "FAILED: $*"; status=1; }

"$carom" doctor >"$work/said" 2>"$work/errors" || fail "it ended with an error: $(cat "$work/errors")"
for kind in host display OpenGL stereo "swap group" monitor sound device "real time" cores disk headset MPI; do
  grep -q "^$kind  *[^ ]" "$work/said" || fail "it says nothing of '$kind': $(cat "$work/said")"
done

"$carom" doctor "$config/rigs/play.toml" >"$work/said" 2>"$work/errors" || fail "of play: $(cat "$work/errors")"

sed 's/^stereo = .*/stereo = "quad-buffer"/; s/monitor = 0/monitor = 7/' "$config/rigs/play.toml" >"$work/stereo.toml"
! "$carom" doctor "$work/stereo.toml" >"$work/said" 2>"$work/errors" || fail "a rig on monitor 7 was found well"
grep -q '^error: wall screen: there is no monitor 7, expected one of 0 "' "$work/errors" || fail "of monitor 7: $(cat "$work/errors")"

sed 's/^unit = .*/&\nframe_lock = "swap-group"/' "$config/rigs/play.toml" >"$work/lock.toml"
if "$carom" doctor | grep -q '^swap group none'; then
  ! "$carom" doctor "$work/lock.toml" >"$work/said" 2>"$work/errors" || fail "a rig with a swap group was found well"
  grep -q "^error: the rig asks for a swap group, expected one here: " "$work/errors" || fail "of a swap group: $(cat "$work/errors")"
fi

mpirun --allow-run-as-root --oversubscribe -n 4 "$carom" doctor "$config/rigs/four-walls-cluster.toml" \
  >"$work/said" 2>"$work/errors" || fail "of four nodes: $(cat "$work/errors")"
grep -q "^MPI .*, 4 nodes$" "$work/said" || fail "it does not say that there are four nodes: $(cat "$work/said")"
[ "$(grep -c "^OpenGL" "$work/said")" = 1 ] || fail "it says more than once what is the same on all nodes: $(cat "$work/said")"

# A room with a tracker that is silent, a node that answers late, and a disk that is nearly full. Node 2 stops itself again
# and again. (A file system of its own size needs the right to mount one.)
sed 's/^kind = .*/kind = "vrpn"/; s/^source = .*/source = "Head@tcp:\/\/127.0.0.1:9"/' "$config/rigs/four-walls-cluster.toml" >"$work/room.toml"
cat >"$work/node" <<'NODE'
if [ "$OMPI_COMM_WORLD_RANK" = 2 ]; then
  (while kill -STOP $$ 2>/dev/null; do sleep 0.06; kill -CONT $$; sleep 0.02; done) &
fi
exec "$@"
NODE
mkdir "$work/disk"
room=(mpirun --allow-run-as-root --oversubscribe -n 4 bash "$work/node" "$carom" doctor "$work/room.toml" --no-window --folder "$work/disk")
small=1
unshare --user --map-root-user --mount bash -c 'mount -t tmpfs -o size=100m none "$0" && exec "$@"' "$work/disk" "${room[@]}" >"$work/said" 2>"$work/errors" ||
  { small=; "${room[@]}" >"$work/said" 2>"$work/errors" || fail "of a room with faults: $(cat "$work/errors")"; }
[ -n "$small" ] || echo "skipped: a disk that is nearly full, which cannot be mounted here"
expect() { grep -qE "$1" "$work/errors" || fail "of a room with faults, expected '$1': $(cat "$work/errors")"; }
expect '^warning: tracker .* is silent: nothing came within [0-9]+ s'
expect '^warning: node 2 \(right\) is slow to answer: messages take [0-9.]+ ms there and back, at times [0-9.]+, expected 1.7 and at times 4.2 ms at most'
[ -z "$small" ] || expect '^warning: [0-9]+ MiB are free in .*/disk, enough for [0-9]+ minutes of session, expected 8 hours at least'
grep -qE '^files +the rig.s 0 warp meshes' "$work/said" || fail "it says nothing of the files: $(cat "$work/said")"

sed 's/^pixels = .*/&\nblend = "none.png"/' "$config/rigs/play.toml" >"$work/blend.toml"
! "$carom" doctor "$work/blend.toml" >"$work/said" 2>"$work/errors" || fail "a rig without its blend picture was found well"
grep -qE '^error: .*blend.toml:[0-9]+:[0-9]+: .*none.png' "$work/errors" || fail "of a blend picture: $(cat "$work/errors")"
grep -q "^disk " "$work/said" || fail "without a blend picture it says nothing of the rest"

! env -u DISPLAY "$carom" doctor >"$work/said" 2>"$work/errors" || fail "without a display it found all well"
grep -q "^error: no X display: " "$work/errors" || fail "without a display it said: $(cat "$work/errors")"
grep -q "^disk " "$work/said" || fail "without a display it says nothing of the rest"

nodes() { # WORDS …: the doctor of four nodes, which all say the same of the display
  mpirun --allow-run-as-root --oversubscribe -n 4 "$carom" doctor "$@" >"$work/said" 2>"$work/errors"
}
within10s() { # COMMAND …
  for _ in $(seq 100); do
    "$@" && return
    sleep 0.1
  done
  return 1
}
isComposited() { "$carom" doctor 2>/dev/null | grep -q "^display .* with a compositor"; }

for compositor in xcompmgr picom; do
  command -v $compositor >/dev/null || { echo "skipped: under $compositor, which is not installed"; continue; }
  options=()
  [ $compositor != picom ] || options=(--config /dev/null --backend xrender)
  $compositor "${options[@]}" >"$work/compositor" 2>&1 &
  helper=$!
  within10s isComposited || fail "it does not see $compositor: $(cat "$work/compositor")"
  nodes "$config/rigs/four-walls-cluster.toml" || fail "four nodes under $compositor: $(cat "$work/errors")"
  grep -q "^display .* with a compositor ($compositor)" "$work/said" || fail "under $compositor: $(cat "$work/said")"
  grep -q "^warning: .*a compositor redraws the windows" "$work/errors" || fail "under $compositor: $(cat "$work/errors")"
  echo "four nodes under $compositor: $(grep '^display' "$work/said")"
  kill $helper
  wait $helper || true
  helper=
done

if command -v weston >/dev/null && command -v Xwayland >/dev/null; then
  mkdir -m 700 "$work/wayland"
  export XDG_RUNTIME_DIR="$work/wayland"
  weston --backend=headless-backend.so --xwayland --socket=carom --idle-time=0 >"$work/weston" 2>&1 &
  helper=$!
  within10s grep -q 'xserver listening on display' "$work/weston" || fail "weston does not begin: $(cat "$work/weston")"
  display=$(grep -oE 'listening on display :[0-9]+' "$work/weston" | grep -oE ':[0-9]+')
  export DISPLAY=$display WAYLAND_DISPLAY=carom
  nodes || fail "four nodes under Xwayland: $(cat "$work/errors")"
  grep -q "^display .*Xwayland under a Wayland compositor" "$work/said" || fail "under Xwayland: $(cat "$work/said")"
  grep -q "^warning: .*a Wayland compositor draws the windows" "$work/errors" || fail "under Xwayland: $(cat "$work/errors")"
  ! nodes "$work/stereo.toml" || fail "quad-buffer stereo under Xwayland was found well"
  grep -q '^error: .*quad-buffer stereo, expected a display without a compositor' "$work/errors" || fail "of quad-buffer stereo under Xwayland: $(cat "$work/errors")"
  echo "four nodes under weston: $(grep '^display' "$work/said")"
else
  echo "skipped: under Xwayland, which is not installed, or weston is not"
fi
exit $status
