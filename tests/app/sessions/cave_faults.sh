#!/usr/bin/env bash
# cave_faults.sh CAROM CONFIG: what `carom cave` says, and leaves behind, when something is wrong from the start.
. "$(dirname "$0")/../../session.sh"
failures=0

expect() {  # NAME STATUS PATTERN COMMAND …: exit status, and a line of standard error
  local name=$1 status=$2 pattern=$3
  shift 3
  rm -rf "$out/pictures"
  "$@" >"$out/stdout" 2>"$out/stderr"
  local got=$?
  if [ "$got" -ne "$status" ] || ! grep -qE "$pattern" "$out/stderr" || [ -e "$out/pictures" ]; then
    echo "FAILED: $name: exit status $got (expected $status), a line like '$pattern', no pictures; it said:"
    cat "$out/stderr"
    failures=$((failures + 1))
  fi
}
session() { echo cave --frames 1 --capture "$out/pictures" --no-window "$@"; }

sed 's/^pixels = .*/pixels = [600, 0\/05]/' "$config/rigs/single-screen.toml" >"$out/junk.toml"
sed 's/^light_speed_m_s = .*/light_speed_m_s = -1.42/' "$config/scenarios/three-pucks.toml" >"$out/slow.toml"
printf 'time_s,x_m,y_m,z_m\n0.0,0,1.7,0\n0.1,0,nan,0\n' >"$out/bad.csv"
sed "s#^source = .*#source = \"$out/bad.csv\"#" "$config/rigs/desk.toml" >"$out/trace.toml"

printf 'v 0 0 0\nv nan 0 0\n' >"$out/bad.obj"
sed 's/^name = "red"/&\nmesh = "bad.obj"/' "$config/scenarios/three-pucks.toml" >"$out/mesh.toml"

cp "$out/bad.csv" "$out/blend.png"
printf 'PF\n4 2\n-1.0\n' >"$out/warp.pfm"
for key in blend warp; do
  [ "$key" = blend ] && file=blend.png || file=warp.pfm
  sed "s/^pixels = .*/&\n$key = \"$file\"/" "$config/rigs/single-screen.toml" >"$out/$key.toml"
done

expect "junk after a number in the rig" 1 "^error: $out/junk.toml:[0-9]+:[0-9]+: " \
  "$carom" $(session --rig "$out/junk.toml")
expect "light speed below zero" 1 "^error: $out/slow.toml:[0-9]+:[0-9]+: " \
  "$carom" $(session --scenario "$out/slow.toml")
expect "no such rig" 1 "^error: $out/none.toml:1:1: " "$carom" $(session --rig "$out/none.toml")
expect "a trace with NaN" 1 "^error: $out/bad.csv:3:[0-9]+: " "$carom" $(session --rig "$out/trace.toml")
expect "the trace before the display" 1 "^error: $out/bad.csv:3:[0-9]+: " \
  env DISPLAY=:4711 "$carom" $(session --rig "$out/trace.toml")
expect "a mesh with NaN" 1 "^error: $out/bad.obj:2:3: " \
  env DISPLAY=:4711 "$carom" $(session --scenario "$out/mesh.toml")
expect "a blend that is no picture" 1 "^error: $out/blend.toml:[0-9]+:[0-9]+: $out/blend.png:1:1: is no such picture" \
  env DISPLAY=:4711 "$carom" $(session --rig "$out/blend.toml")
expect "a warp cut off" 1 "^error: $out/warp.toml:[0-9]+:[0-9]+: $out/warp.pfm:1:1: 4 × 2 points take 96 bytes" \
  env DISPLAY=:4711 "$carom" $(session --rig "$out/warp.toml")
sed 's/^stereo = .*/stereo = "quad-buffer"/' "$config/rigs/single-screen.toml" >"$out/quad.toml"
expect "quad-buffer stereo on a display without" 1 \
  '^error: window "Carom: screen": this display offers no quad-buffer stereo .*; choose another stereo mode' \
  "$carom" cave --frames 1 --capture "$out/pictures" --rig "$out/quad.toml"
expect "no display" 1 "^error: .*display" env DISPLAY=:4711 "$carom" $(session)
expect "a wrong argument" 2 "frames" "$carom" cave --frames many
expect "the same on every node, said once" 1 "^error: $out/junk.toml:[0-9]+:[0-9]+: " \
  mpirun --allow-run-as-root --oversubscribe -n 2 "$carom" $(session --rig "$out/junk.toml")
[ "$(grep -c '^error:' "$out/stderr")" -eq 1 ] || { echo "FAILED: more than one line of ours"; failures=$((failures + 1)); }

[ "$failures" -eq 0 ] && echo "every fault was named and nothing was left behind"
exit "$failures"
