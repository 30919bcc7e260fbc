#!/usr/bin/env bash
# doctor.sh CAROM CONFIG: what `carom doctor` says of this machine, of a rig that it cannot show, and of four nodes.
set -euo pipefail
carom=$1
config=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0
fail() { echo "FAILED: $*"; status=1; }

"$carom" doctor >"$work/said" 2>"$work/errors" || fail "it ended with an error: $(cat "$work/errors")"
for kind in host display OpenGL stereo "swap group" monitor sound device "real time" cores disk MPI; do
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

! env -u DISPLAY "$carom" doctor >"$work/said" 2>"$work/errors" || fail "without a display it found all well"
grep -q "^error: no X display: " "$work/errors" || fail "without a display it said: $(cat "$work/errors")"
grep -q "^disk " "$work/said" || fail "without a display it says nothing of the rest"
exit $status
