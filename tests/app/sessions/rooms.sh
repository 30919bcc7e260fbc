#!/usr/bin/env bash
# rooms.sh CAROM CONFIG: every shipped rig, and rooms of other programs once imported, check clean and are drawn:
# each wall and eye, one frame, not black.
. "$(dirname "$0")/../../session.sh"
set -e

cat >"$out/corner.pvx" <<'EOF'
<pvx>
  <Machine Name="Front" Geometry="96x96+0+0" StereoType="SplitViewportHorizontal"
    LowerLeft="-1.5 -1.6 -1.5" LowerRight="1.5 -1.6 -1.5" UpperRight="1.5 1.4 -1.5"/>
  <Machine Name="Floor" Geometry="96x96+96+0"
    LowerLeft="-1.5 -1.6 1.5" LowerRight="1.5 -1.6 1.5" UpperRight="1.5 -1.6 -1.5"/>
</pvx>
EOF
rooms=("$out/corner.pvx")
foreign=$(dirname "$config")/tests/data/rooms
rooms+=("$foreign/ParaView__Examples__trivial.pvx" "$foreign/sgct-docs__projectionplane.json" "$foreign/sgct__config__3DTV.json")
for room in "${rooms[@]}"; do
  "$carom" import "$room" -o "$out/$(basename "$room").toml" 2>"$out/said" || { cat "$out/said"; exit 1; }
done

mkdir "$out/drawn"
for rig in "$config"/rigs/*.toml "$out"/*.toml; do
  name=$(basename "$rig" .toml)
  "$carom" check "$rig" >/dev/null 2>"$out/findings"
  [ -s "$out/findings" ] && { echo "$name does not check clean:"; cat "$out/findings"; exit 1; }
  grep -q '^\[headset\]' "$rig" && continue # drawn by headset_session_test, which has a runtime for it
  drawn=$rig
  if grep -q '^display = ' "$rig"; then  # X screens that are not here
    drawn=$out/drawn/$name.toml
    sed "s/^display = .*/display = \"$DISPLAY\"/" "$rig" >"$drawn"
  fi
  "$carom" cave --rig "$drawn" --frames 1 --no-window --capture "$out/drawn/$name" 2>"$out/said" || { cat "$out/said"; exit 1; }
  walls=$(grep -c '^\[\[wall\]\]' "$rig")
  stereo=$(grep -cE '^stereo = "(quad-buffer|side-by-side|top-bottom|anaglyph|interlaced|checkerboard)"' "$rig" || true)
  count=$(find "$out/drawn/$name" -name '*.png' | wc -l)
  [ "$count" -eq $((walls + stereo)) ] || { echo "$name: $count pictures of $walls walls, $stereo in stereo"; exit 1; }
  # A picture of one colour takes a few hundred bytes.
  small=$(find "$out/drawn/$name" -name '*.png' -size -1500c)
  [ -z "$small" ] || { echo "$name: nothing is drawn on" $small; exit 1; }
done
echo "every room checks clean and is drawn"
