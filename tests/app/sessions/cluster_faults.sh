#!/usr/bin/env bash
# cluster_faults.sh CAROM CONFIG: what a room of four nodes says and does when one of them dies, stops or has no
# display; and that nodes without any file draw what rank 0's files say. What is wrong is said within two seconds more than a session takes that
# starts, draws one frame and ends: which tells how busy the machine is.
. "$(dirname "$0")/../../session.sh"
failures=0
sed 's/^pixels = .*/pixels = [64, 64]/' "$config/rigs/four-walls-cluster.toml" >"$out/room.toml"

fail() {
  echo "FAILED: $1; it said:"
  cat "$out/stderr"
  failures=$((failures + 1))
}
says() { grep -qE "$1" "$out/stderr"; }

now_ms() { echo $((${EPOCHREALTIME/./} / 1000)); }
began=$(now_ms)
"${mpi[@]}" -n 4 "$carom" cave --rig "$out/room.toml" --frames 1 --no-window 2>"$out/stderr" || fail "nothing is wrong"
usual=$(($(now_ms) - began))

# Until a command succeeds, for two minutes at most.
until_ok() {
  for _ in $(seq 1200); do
    "$@" && return
    sleep 0.1
  done
  return 1
}
noneLeft() { ! pgrep -f "$out/room.toml" >/dev/null; }

# A session that goes on until something happens to it; returns when it draws.
start() {
  rm "$out/stderr" # what the session before it said is none of its words
  touch "$out/stderr"
  "${mpi[@]}" -n 4 "$carom" cave --rig "$out/room.toml" --frames 1000000 --no-window >"$out/stdout" 2>"$out/stderr" &
  job=$!
  until_ok says '^frame [0-9]+ of' || fail "no frame within two minutes"
  mapfile -t nodes < <(pgrep -P "$job" | sort -n)
  [ "${#nodes[@]}" -eq 4 ] || fail "expected four nodes, found ${#nodes[@]}"
}
# Milliseconds until the whole job has ended, or 60 000.
millisecondsToEnd() {
  local from=${EPOCHREALTIME/./}
  for _ in $(seq 1200); do
    kill -0 "$job" 2>/dev/null || break
    sleep 0.05
  done
  echo $(((${EPOCHREALTIME/./} - from) / 1000))
}
ended() {  # NAME PATTERN: the job is gone soon, nothing of it is left, one line of ours
  local took
  took=$(millisecondsToEnd)
  [ "$took" -lt $((usual + 2000)) ] || fail "$1: the job took $took ms to end, $usual when nothing is wrong"
  until_ok noneLeft || fail "$1: a process is left"
  [ "$(grep -cE '^error: ' "$out/stderr")" -eq 1 ] && says "$2" || fail "$1: expected one line of ours like '$2'"
  echo "$1: $(grep -E '^error: ' "$out/stderr") ($took ms)"
  job=
}

start
kill -KILL "${nodes[2]}"
ended "a node dies" '^error: node 2 \(.+\) is gone'

start
kill -KILL "${nodes[0]}"
ended "the node of the devices dies" '^error: node 0 \(.+\) is gone'

start
kill -STOP "${nodes[1]}"
until_ok says '^node 1 \(.+\) is late' || fail "a node stops: expected to hear that it is late"
kill -CONT "${nodes[1]}"
until_ok says '^node 1 \(.+\) is back after [0-9]+\.[0-9] s' || fail "a node goes on: expected to hear that it is back"
says '^error' && fail "a node stops for a while: the session must go on"
echo "a node stops: $(grep -E '^node 1' "$out/stderr" | tr '\n' ' ')"
kill -TERM "$job"
millisecondsToEnd >/dev/null
until_ok noneLeft || fail "asked to end: a process is left"
job=

refused() {  # NAME PATTERN COMMAND …: exit status 1 and one such line, 2 s after the usual start at the latest
  local name=$1 pattern=$2 began took
  shift 2
  began=$(now_ms)
  "$@" 2>"$out/stderr" && fail "$name: expected exit status 1"
  took=$(($(now_ms) - began))
  [ "$(grep -cE '^error: ' "$out/stderr")" -eq 1 ] && says "$pattern" || fail "$name: expected one line like '$pattern'"
  [ "$took" -lt $((usual + 2000)) ] || fail "$name: took $took ms, $usual when nothing is wrong"
  echo "$name: $(grep -E '^error: ' "$out/stderr") ($took ms; a session that starts, $usual)"
}
# Files of all kinds, in a folder that only rank 0 has: beside the rig, above it, and by an absolute path.
mkdir -p "$out/a/rigs" "$out/b"
cat >"$out/a/rigs/screen.obj" <<'OBJ'
v -1 -1
v 1 -1
v 0 1
vt 0 0
vt 1 0
vt 0.5 1
f 1 2 3
OBJ
base64 -d >"$out/a/edge.png" <<<"iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVQI12P4DwABAQEAG7buVgAAAABJRU5ErkJggg=="
cat >"$out/a/puck.gltf" <<'GLTF'
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "buffers": [{"uri": "puck.bin", "byteLength": 36}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}]}
GLTF
# (0, 0, 0), (1, 0, 0), (0, 1, 0) as floats
printf '%b' '\0\0\0\0\0\0\0\0\0\0\0\0' '\0\0\0200\077\0\0\0\0\0\0\0\0' '\0\0\0\0\0\0\0200\077\0\0\0\0' >"$out/a/puck.bin"
cp "$config/traces/walk.csv" "$out/a/rigs/mine.csv"
sed "s|^pixels = .*|&\nwarp = \"screen.obj\"\nblend = \"../edge.png\"|; s|^source = .*|source = \"$out/a/rigs/mine.csv\"|" "$out/room.toml" >"$out/a/rigs/room.toml"
sed 's/^name = "red"/&\nmesh = "puck.gltf"/' "$config/scenarios/three-pucks.toml" >"$out/a/game.toml"
# A measured screen: 40 cm wide, 80 cm ahead.
cat >"$out/a/rigs/board.obj" <<'OBJ'
v -0.2 1.5 -0.8
v 0.2 1.5 -0.8
v 0.2 1.9 -0.8
v -0.2 1.9 -0.8
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1 2/2 3/3 4/4
OBJ
cat >>"$out/a/rigs/room.toml" <<'TOML'
[[wall]]
name = "board"
screen = { shape = "mesh", file = "board.obj", unit = "m" }
pixels = [64, 64]
node = 3
TOML
grep -q "rigs/mine.csv" "$out/a/rigs/room.toml" || fail "the rig has no trace of its own"
mkdir "$out/tmp"
export TMPDIR="$out/tmp"
session=(cave --rig rigs/room.toml --scenario game.toml --frames 3 --no-window --capture)
(cd "$out/a" && "$carom" "${session[@]}" "$out/alone") 2>"$out/stderr" || fail "one node with all files"
# Node 0 runs in folder a, the others in folder b.
apart=("${mpi[@]}" -n 4 bash -c 'cd "$0"/$([ "$OMPI_COMM_WORLD_RANK" = 0 ] && echo a || echo b) && exec "$@"' "$out")
"${apart[@]}" "$carom" "${session[@]}" "$out/handed" 2>"$out/stderr" || fail "nodes without any file"
[ "$(ls "$out/alone" | wc -l)" = 27 ] || fail "expected 27 pictures, found $(ls "$out/alone" | wc -l)"
diff -rq "$out/alone" "$out/handed" || fail "nodes without any file draw other pictures"
[ -z "$(find "$out/tmp" -type f)" ] || fail "files of rank 0 are left: $(find "$out/tmp" -type f)"
"${apart[@]}" "$carom" check rigs/room.toml --pattern --capture "$out/patterns" 2>"$out/stderr" || fail "patterns of nodes without any file"
echo "nodes without any file draw rank 0's"

printf '\n[[node]]\nrank = 2\ndisplay = ":4711"\n' >>"$out/room.toml"
refused "a node without a display" '^error: node 2: .*:4711' \
  "${mpi[@]}" -n 4 "$carom" cave --rig "$out/room.toml" --frames 3 --no-window

[ "$failures" -eq 0 ] && echo "every fault ended, or went on, as it should, and was named"
exit "$failures"
