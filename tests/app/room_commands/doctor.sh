#!/usr/bin/env bash
# doctor.sh CAROM CONFIG: what `carom doctor` says of this machine, of a rig that it cannot show, of four nodes, of a
# compositor, and of Xwayland under a Wayland compositor. The last two are skipped, with words, where none is installed.
. "$(dirname "$0")/../../session.sh"
set -e
helper=
trap '[ -z "$helper" ] || kill "$helper"; wait; rm -rf "$out"' EXIT
status=0
fail() { echo "FAILED: $*"; status=1; }

"$carom" doctor >"$out/said" 2>"$out/errors" || fail "it ended with an error: $(cat "$out/errors")"
for kind in host display OpenGL stereo "swap group" monitor sound device "real time" cores disk headset MPI; do
  grep -q "^$kind  *[^ ]" "$out/said" || fail "it says nothing of '$kind': $(cat "$out/said")"
done

"$carom" doctor "$config/rigs/play.toml" >"$out/said" 2>"$out/errors" || fail "of play: $(cat "$out/errors")"

sed 's/^stereo = .*/stereo = "quad-buffer"/; s/monitor = 0/monitor = 7/' "$config/rigs/play.toml" >"$out/stereo.toml"
! "$carom" doctor "$out/stereo.toml" >"$out/said" 2>"$out/errors" || fail "a rig on monitor 7 was found well"
grep -q '^error: wall screen: there is no monitor 7, expected one of 0 "' "$out/errors" || fail "of monitor 7: $(cat "$out/errors")"

sed 's/^unit = .*/&\nframe_lock = "swap-group"/' "$config/rigs/play.toml" >"$out/lock.toml"
if "$carom" doctor | grep -q '^swap group none'; then
  ! "$carom" doctor "$out/lock.toml" >"$out/said" 2>"$out/errors" || fail "a rig with a swap group was found well"
  grep -q "^error: the rig asks for a swap group, expected one here: " "$out/errors" || fail "of a swap group: $(cat "$out/errors")"
fi

mpirun --allow-run-as-root --oversubscribe -n 4 "$carom" doctor "$config/rigs/four-walls-cluster.toml" \
  >"$out/said" 2>"$out/errors" || fail "of four nodes: $(cat "$out/errors")"
grep -q "^MPI .*, 4 nodes$" "$out/said" || fail "it does not say that there are four nodes: $(cat "$out/said")"
[ "$(grep -c "^OpenGL" "$out/said")" = 1 ] || fail "it says more than once what is the same on all nodes: $(cat "$out/said")"

# A room with a tracker that is silent, a node that answers late, and a disk that is nearly full. Node 2 stops itself again
# and again. (A file system of its own size needs the right to mount one.)
sed 's/^kind = .*/kind = "vrpn"/; s/^source = .*/source = "Head@tcp:\/\/127.0.0.1:9"/' "$config/rigs/four-walls-cluster.toml" >"$out/room.toml"
cat >"$out/node" <<'NODE'
if [ "$OMPI_COMM_WORLD_RANK" = 2 ]; then
  (while kill -STOP $$ 2>/dev/null; do sleep 0.06; kill -CONT $$; sleep 0.02; done) &
fi
exec "$@"
NODE
mkdir "$out/disk"
room=(mpirun --allow-run-as-root --oversubscribe -n 4 bash "$out/node" "$carom" doctor "$out/room.toml" --no-window --folder "$out/disk")
small=1
unshare --user --map-root-user --mount bash -c 'mount -t tmpfs -o size=100m none "$0" && exec "$@"' "$out/disk" "${room[@]}" >"$out/said" 2>"$out/errors" ||
  { small=; "${room[@]}" >"$out/said" 2>"$out/errors" || fail "of a room with faults: $(cat "$out/errors")"; }
[ -n "$small" ] || echo "skipped: a disk that is nearly full, which cannot be mounted here"
expect() { grep -qE "$1" "$out/errors" || fail "of a room with faults, expected '$1': $(cat "$out/errors")"; }
expect '^warning: tracker .* is silent: nothing came within [0-9]+ s'
expect '^warning: node 2 \(right\) is slow to answer: messages take [0-9.]+ ms there and back, at times [0-9.]+, expected 1.7 and at times 4.2 ms at most'
[ -z "$small" ] || expect '^warning: [0-9]+ MiB are free in .*/disk, enough for [0-9]+ minutes of session, expected 8 hours at least'
grep -qE '^files +the rig.s 0 warp meshes' "$out/said" || fail "it says nothing of the files: $(cat "$out/said")"

sed 's/^pixels = .*/&\nblend = "none.png"/' "$config/rigs/play.toml" >"$out/blend.toml"
! "$carom" doctor "$out/blend.toml" >"$out/said" 2>"$out/errors" || fail "a rig without its blend picture was found well"
grep -qE '^error: .*blend.toml:[0-9]+:[0-9]+: .*none.png' "$out/errors" || fail "of a blend picture: $(cat "$out/errors")"
grep -q "^disk " "$out/said" || fail "without a blend picture it says nothing of the rest"

! env -u DISPLAY "$carom" doctor >"$out/said" 2>"$out/errors" || fail "without a display it found all well"
grep -q "^error: no X display: " "$out/errors" || fail "without a display it said: $(cat "$out/errors")"
grep -q "^disk " "$out/said" || fail "without a display it says nothing of the rest"

nodes() { # WORDS …: the doctor of four nodes, which all say the same of the display
  mpirun --allow-run-as-root --oversubscribe -n 4 "$carom" doctor "$@" >"$out/said" 2>"$out/errors"
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
  $compositor "${options[@]}" >"$out/compositor" 2>&1 &
  helper=$!
  within10s isComposited || fail "it does not see $compositor: $(cat "$out/compositor")"
  nodes "$config/rigs/four-walls-cluster.toml" || fail "four nodes under $compositor: $(cat "$out/errors")"
  grep -q "^display .* with a compositor ($compositor)" "$out/said" || fail "under $compositor: $(cat "$out/said")"
  grep -q "^warning: .*a compositor redraws the windows" "$out/errors" || fail "under $compositor: $(cat "$out/errors")"
  echo "four nodes under $compositor: $(grep '^display' "$out/said")"
  kill $helper
  wait $helper || true
  helper=
done

if command -v weston >/dev/null && command -v Xwayland >/dev/null; then
  mkdir -m 700 "$out/wayland"
  export XDG_RUNTIME_DIR="$out/wayland"
  weston --backend=headless-backend.so --xwayland --socket=carom --idle-time=0 >"$out/weston" 2>&1 &
  helper=$!
  within10s grep -q 'xserver listening on display' "$out/weston" || fail "weston does not begin: $(cat "$out/weston")"
  display=$(grep -oE 'listening on display :[0-9]+' "$out/weston" | grep -oE ':[0-9]+')
  export DISPLAY=$display WAYLAND_DISPLAY=carom
  nodes || fail "four nodes under Xwayland: $(cat "$out/errors")"
  grep -q "^display .*Xwayland under a Wayland compositor" "$out/said" || fail "under Xwayland: $(cat "$out/said")"
  grep -q "^warning: .*a Wayland compositor draws the windows" "$out/errors" || fail "under Xwayland: $(cat "$out/errors")"
  ! nodes "$out/stereo.toml" || fail "quad-buffer stereo under Xwayland was found well"
  grep -q '^error: .*quad-buffer stereo, expected a display without a compositor' "$out/errors" || fail "of quad-buffer stereo under Xwayland: $(cat "$out/errors")"
  echo "four nodes under weston: $(grep '^display' "$out/said")"
else
  echo "skipped: under Xwayland, which is not installed, or weston is not"
fi
exit $status
