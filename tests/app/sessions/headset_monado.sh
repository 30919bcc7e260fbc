#!/usr/bin/env bash
# headset_monado.sh CAROM CONFIG: sessions with Monado, a real OpenXR runtime, and a headset that it simulates: with its
# null compositor, which shows nothing, and with its real one, in a window of this display. Skipped where Monado is not
# installed (Debian 13: monado-service, libopenxr1-monado; Debian 12 has none).
set -euo pipefail
carom=$1
if ! command -v monado-service >/dev/null; then
  echo "Monado is not installed (monado-service, in Debian 13): skipped"
  exit 77
fi
work=$(mktemp -d)
service=
stop() {
  [ -z "$service" ] || { kill "$service"; wait "$service" || true; }
  service=
}
trap 'stop; rm -rf "$work"' EXIT
fail() {
  echo "FAILED: $*"
  tail -n 5 "$work/service.log"
  exit 1
}

for compositor in XRT_COMPOSITOR_NULL XRT_COMPOSITOR_FORCE_XCB; do
  export XDG_RUNTIME_DIR=$work/$compositor
  mkdir -m 700 "$XDG_RUNTIME_DIR"
  env "$compositor=1" SIMULATED_ENABLE=1 SIMULATED_LEFT=simple SIMULATED_RIGHT=simple XRT_NO_STDIN=1 \
    monado-service >"$work/service.log" 2>&1 &
  service=$!
  for _ in $(seq 200); do
    [ -S "$XDG_RUNTIME_DIR/monado_comp_ipc" ] && break
    kill -0 "$service" 2>/dev/null || fail "$compositor: the service does not start"
    sleep 0.05
  done
  "$carom" doctor | grep '^headset .*, by Monado' || fail "$compositor: the doctor does not name the runtime"
  game=$work/$compositor.db
  "$carom" cave --rig headset --frames 60 --no-window --silent --session "$game" 2>"$work/said" ||
    fail "$compositor: $(cat "$work/said")"
  grep -q 'by Monado.* pixels an eye' "$work/said" || fail "$compositor: $(cat "$work/said")"
  stop
  # Afterwards the session is replayed without a headset, with each eye's pictures.
  "$carom" replay "$game" --no-window --capture "$work/$compositor-pictures" 2>"$work/said" ||
    fail "$compositor: the replay: $(cat "$work/said")"
  for eye in left right; do
    pictures=$(find "$work/$compositor-pictures" -name "headset-$eye-*.png" | wc -l)
    [ "$pictures" -eq 60 ] || fail "$compositor: $pictures pictures of the $eye eye, expected 60"
  done
done
echo "Monado shows a session with both of its compositors"
