#!/usr/bin/env bash
# room.sh CAROM CONFIG: `carom room` starts the nodes of a rig, each on its host, names hosts that have another version
# before anything starts, and waits for those that do not answer; a session that lost a node, also in its start, goes on by
# itself with the same game; hosts can be left out with their walls; and the status file says so, whole at any moment and
# every second, also while a node hangs.
. "$(dirname "$0")/../../session.sh"
needs sqlite3 python3
trap '[ -z "$job" ] || kill -TERM "$job" 2>/dev/null; wait; rm -rf "$out"' EXIT
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
failures=0
fail() {
  echo "FAILED: $1; it said:"
  cat "$out/stderr"
  failures=$((failures + 1))
}
says() { grep -qE "$1" "$out/stderr"; }
until_ok() { # for two minutes at most
  for _ in $(seq 1200); do
    "$@" && return
    sleep 0.1
  done
  return 1
}
now_ms() { echo $((${EPOCHREALTIME/./} / 1000)); }
touch "$out/stderr"
export TMPDIR=$out
cd "$out"
sed 's/^pixels = .*/pixels = [64, 64]/' "$config/rigs/four-walls-cluster.toml" >room.toml

echo 'light = 1' >bad.toml

# The line of mpirun.
nodes() { # FILE NODES: the rig with these
  { cat room.toml; cat; } >"$1"
}
nodes hosts.toml <<'RIG'
[start]
network = "10.0.0.0/24"
ports = "47000-47099"
environment = ["SYNC=1", "XAUTHORITY"]
[[node]]
rank = 0
host = "cave-front"
display = ":0.1"
[[node]]
rank = 1
host = "cave-sides"
slots = 2
[[node]]
rank = 3
host = "cave-floor"
RIG
expected="mpirun -n 4 --host cave-front:1,cave-sides:2,cave-floor:1 --map-by slot --bind-to none"
expected+=" --mca btl_tcp_if_include 10.0.0.0/24 --mca oob_tcp_if_include 10.0.0.0/24"
expected+=" --mca oob_tcp_dynamic_ipv4_ports 47000-47009"
expected+=" --mca btl_tcp_port_min_v4 47010 --mca btl_tcp_port_range_v4 90 --mca btl_tcp_port_min_v6 47010 --mca btl_tcp_port_range_v6 90"
expected+=" -x SYNC=1 -x XAUTHORITY"
expected+=" $carom cave --rig hosts.toml --switch colour=on --session 'my game.db'"
[ "$("$carom" room --line hosts.toml --switch colour=on --session "my game.db")" = "$expected" ] ||
  fail "the line is $("$carom" room --line hosts.toml --switch colour=on --session "my game.db"), expected $expected"

without=$("$carom" room --line --without cave-sides hosts.toml)
for part in "-n 2 --host cave-front:1,cave-floor:1 " " --without-nodes=1,2\$"; do
  grep -qE -- "$part" <<<"$without" || fail "without a host the line is '$without', expected '$part' in it"
done

refused() { # NAME PATTERN COMMAND …: exit status 1 and one such line
  local name=$1 pattern=$2
  shift 2
  "$@" >stdout 2>stderr && fail "$name: expected exit status 1"
  [ "$(grep -c '^error: ' stderr)" = 1 ] && says "$pattern" || fail "$name: expected one line like '$pattern'"
  echo "$name: $(grep '^error' stderr)"
}
nodes fewer.toml <<<$'[[node]]\nrank = 0\nhost = "a"\n[[node]]\nrank = 1\nhost = "b"'
refused "a wrong line of a game" '^error: .*bad.toml:1:[0-9]+:' "$carom" room --line room.toml --scenario bad.toml
sed 's/47099/47001/' hosts.toml >ports.toml
wrong() { # NAME PATTERN COMMAND …: exit status 2 and one such line
  local name=$1 pattern=$2
  shift 2
  "$@" >stdout 2>stderr
  [ $? = 2 ] && says "$pattern" || fail "$name: expected status 2 and one line like '$pattern'"
}
wrong "a game that is not there" "^error: --scenario: there is no file 'tipo'" "$carom" room --line room.toml --scenario tipo
wrong "an option that is none" '^error: .*--scenari' "$carom" room --line room.toml --scenari three-pucks
wrong "another rig" '^error: --rig: the rig is named already' "$carom" room --line room.toml --rig desk
wrong "a host that the rig has not" "^error: --without: the rig has no host 'cave-back', expected one of cave-sides, cave-floor" \
  "$carom" room --line --without cave-back hosts.toml
wrong "the host of node 0" "^error: --without: node 0 is on 'cave-front', expected another host" "$carom" room --line --without cave-front hosts.toml
refused "ports that are none" "^error: .*ports.toml:[0-9]+:9: ports is '47000-47001', expected a range of 16 TCP ports" \
  "$carom" room --line ports.toml
refused "fewer hosts than nodes" '^error: node 2, 3 of the rig has no host' "$carom" room fewer.toml
sed 's/cave-floor/cave-front/' hosts.toml >apart.toml
refused "nodes of one host apart" '^error: node 3 of the rig is on host cave-front again' "$carom" room apart.toml
nodes twice.toml <<<$'[[node]]\nrank = 0\nslots = 3\nhost = "a"\n[[node]]\nrank = 2\nhost = "b"'
refused "a rank of two hosts" "^error: .*twice.toml:[0-9]+:8: the rank '2' is taken in line [0-9]+" "$carom" room twice.toml
nodes wrong.toml <<<$'[[node]]\nrank = 0\nhost = "a; rm x"'
refused "a host that is none" "^error: .*wrong.toml:[0-9]+:8: host is 'a; rm x'" "$carom" room wrong.toml

# Hosts that are asked by ssh, here by one that knows some of them. The host "later" is this computer once it is on.
mkdir bin
cat >bin/ssh <<'SSH'
#!/bin/sh
while [ "${1#-}" != "$1" ]; do [ "$1" != -o ] || shift; shift; done
case $1 in
  later) [ ! -e on ] || { shift; exec sh -c "$*"; }; echo "ssh: connect to host later port 22: No route to host"; exit 255 ;;
  old) echo "carom 0.0.1" ;;
  bare) echo "sh: carom: not found"; exit 127 ;;
  *) echo "ssh: connect to host $1 port 22: No route to host"; exit 255 ;;
esac
SSH
chmod +x bin/ssh
for host in old bare later; do
  nodes $host.toml <<<$'[[node]]\nrank = 0\nhost = "localhost"\n[[node]]\nrank = 1\nslots = 3\nhost = "'$host'"'
done
PATH="$out/bin:$PATH" refused "another version" '^error: host old has another version, carom 0.0.1, expected carom ' "$carom" room old.toml
PATH="$out/bin:$PATH" refused "no program" '^error: host bare does not run .*: sh: carom: not found' "$carom" room bare.toml
PATH="$out/bin:$PATH" refused "no answer" '^error: host later does not answer: .*No route to host' "$carom" room --doctor later.toml
refused "a status file that cannot be written" '^error: .*none/status.json cannot be written' \
  "$carom" room --no-doctor room.toml --no-window --status none/status.json
ls ./*.db >/dev/null 2>&1 && fail "a session that did not begin has left a file"

# A host that is switched on later, and one that is left out.
status() { python3 -c 'import json, sys; print(json.load(open("status.json"))[sys.argv[1]])' "$1" 2>/dev/null; }
PATH="$out/bin:$PATH" "$carom" room --no-doctor later.toml --scenario three-pucks --frames 2 --no-window --session later.db --status status.json 2>stderr &
job=$!
until_ok says '^warning: the room waits for later: asked again in 5 s' || fail "it does not wait for a host"
says '^warning: host later does not answer: .*No route to host' || fail "it does not say that a host does not answer"
until_ok grep -q '"waiting"' status.json || fail "the status is not 'waiting': $(cat status.json)"
[ "$(status message)" = "the room waits for later" ] || fail "the status is $(cat status.json)"
touch on
wait "$job" || fail "the session does not begin once the host answers"
job=
[ "$(sqlite3 later.db 'SELECT max(number) FROM frame')" = 1 ] || fail "the session of the host that came later has other frames"
rm on
"$carom" room --no-doctor --without later later.toml --scenario three-pucks --frames 1 --no-window --session without.db \
  --capture without --status status.json 2>stderr || fail "without a host"
[ "$(ls without)" = "$(printf '%s\n' front-{left,right}-000000.png)" ] || fail "without a host, the pictures are $(ls without)"
[ "$(status missing)" = "[{'name': 'later', 'walls': ['left', 'right', 'floor']}]" ] || fail "the status is $(cat status.json)"

# Four local nodes, from the rig alone, judged before. One of them hangs for a while, one dies, another in the new start.
began=$(now_ms)
"$carom" room room.toml --scenario three-pucks --frames 1 --no-window --session one.db 2>stderr || fail "nothing is wrong"
usual=$(($(now_ms) - began))
rm -f status.json
"$carom" room --no-doctor room.toml --scenario three-pucks --switch colour=on --frames 1000000 --no-window --session game.db --status status.json 2>stderr &
job=$!
drawn() { says "^frame [0-9]+ of"; }
until_ok drawn || fail "no frame within two minutes"
isAt() { [ "$(status state)" = playing ] && [ "$(status frame)" -ge "$1" ]; }
until_ok isAt 1 || fail "the status file does not follow the session: $(cat status.json)"
[ "$(status session)" = game.db ] && [ "$(status game)" = "Three pucks" ] || fail "the status is $(cat status.json)"
[ "$(python3 -c 'import json; print(len(json.load(open("status.json"))["nodes"]))')" = 4 ] || fail "the status has other nodes: $(cat status.json)"
mpirun=$(pgrep -P "$job" -x 'mpirun|prterun')
mapfile -t ranks < <(pgrep -P "$mpirun" | sort -n)
[ "${#ranks[@]}" = 4 ] || fail "expected four nodes, found ${#ranks[@]}"
kill -STOP "${ranks[1]}"
hangs() { [ "$(status waits_for)" = "node 1 (left)" ] && python3 -c 'import sys; sys.exit(not float(sys.argv[1]) > 1.0)' "$(status frame_age_s)"; }
until_ok hangs || fail "a node hangs; the status is $(cat status.json)"
kill -CONT "${ranks[1]}"
kill -KILL "${ranks[2]}"
killed=$(now_ms)
until_ok says '^warning: the session was cut off after frame [0-9]+: it goes on by itself' || fail "it does not go on"
last=$(grep -oE 'after frame [0-9]+' stderr | grep -oE '[0-9]+')
isStarting() {
  mpirun=$(pgrep -P "$job" -x 'mpirun|prterun') && mapfile -t ranks < <(pgrep -P "$mpirun" | sort -n) && [ "${#ranks[@]}" = 4 ]
}
until_ok isStarting || fail "the nodes are not started again"
kill -KILL "${ranks[3]}"
until_ok says '^warning: the nodes are started again in 5 s' || fail "it gives up when a node dies in the start"
says '^warning: the nodes ended before their first frame' || fail "it does not say that there was no frame"
goesOn() { [ "$(sqlite3 "file:game.db?mode=ro" 'SELECT max(number) FROM frame' 2>/dev/null)" -gt "$last" ]; } 2>/dev/null
until_ok isAt $((last + 1)) || fail "the status file does not follow: $(cat status.json)"
took=$(($(now_ms) - killed))
line=$(tr '\0' ' ' <"/proc/$(pgrep -P "$job" -x 'mpirun|prterun')/cmdline")
for part in "--frames $((999999 - last)) " "--scenario [^ ]*three-pucks.toml " "--switch colour=on "; do
  grep -qE -- "$part" <<<"$line" || fail "the session goes on with '$line', expected '$part' in it"
done
for folder in "$TMPDIR"/carom-files-*; do # there is none once a session has read its files
  [ ! -d "$folder" ] || ! flock -n "$folder" true || fail "$folder is left of a process that is gone"
done
echo "node 2 killed after frame $last, node 3 in the new start: back after $took ms; a session that starts and draws one frame takes $usual"
until_ok goesOn || fail "the session file does not go on"
for _ in $(seq 50); do status state >/dev/null || fail "the status file was not whole"; done
kill -TERM "$job"
wait "$job"
job=
[ "$(status state)" = ended ] || fail "the status is not 'ended': $(cat status.json)"

# The same game: each frame follows the one before it, and the game of the whole file is the game played at once.
gaps=$(sqlite3 game.db 'SELECT count(*) FROM frame a WHERE number > 0 AND NOT EXISTS (SELECT 1 FROM frame b WHERE b.number = a.number - 1)')
[ "$gaps" = 0 ] || fail "$gaps frames follow none"
frames=$(sqlite3 game.db 'SELECT max(number) + 1 FROM frame')
"$carom" cave --rig room.toml --scenario three-pucks --frames "$frames" --no-window --session whole.db 2>stderr || fail "the game at once"
for game in game whole; do "$carom" events $game.db --csv $game.csv 2>stderr || fail "the events of $game"; done
python3 - <<'PY' || fail "the game that was cut off differs from the game played at once"
import csv
def game(name):  # when which collision happened where; when it was seen depends on the head's filter, which began anew
    return [row[:10] for row in csv.reader(open(name))]
cut, whole = game("game.csv"), game("whole.csv")
assert len(cut) > 1 and cut == whole, f"{cut}\n{whole}"
print(f"{len(cut) - 1} collisions are the same to the bit")
PY

[ "$failures" -eq 0 ] && echo "the room starts, goes on and says how it is"
exit "$failures"
