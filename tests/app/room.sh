#!/usr/bin/env bash
# room.sh CAROM CONFIG: `carom room` starts the nodes of a rig, each on its host, and names hosts that do not answer or
# have another version before anything starts; a session that lost a node goes on by itself with the same game, soon
# (within 5 s more than a session takes that starts and draws one frame: which tells how busy the machine is); and the
# status file says so, whole at any moment.
set -uo pipefail
carom=$1
config=$2
out=$(mktemp -d)
job=
trap '[ -z "$job" ] || kill -TERM "$job" 2>/dev/null; wait; rm -rf "$out"' EXIT
for tool in sqlite3 python3; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
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
expected+=" --mca btl_tcp_if_include 10.0.0.0/24 --mca oob_tcp_if_include 10.0.0.0/24 -x SYNC=1 -x XAUTHORITY"
expected+=" $carom cave --rig hosts.toml --switch colour=on --session 'my game.db'"
[ "$("$carom" room --line hosts.toml --switch colour=on --session "my game.db")" = "$expected" ] ||
  fail "the line is $("$carom" room --line hosts.toml --switch colour=on --session "my game.db"), expected $expected"

refused() { # NAME PATTERN COMMAND …: exit status 1 and one such line
  local name=$1 pattern=$2
  shift 2
  "$@" >stdout 2>stderr && fail "$name: expected exit status 1"
  [ "$(grep -c '^error: ' stderr)" = 1 ] && says "$pattern" || fail "$name: expected one line like '$pattern'"
  echo "$name: $(grep '^error' stderr)"
}
nodes fewer.toml <<<$'[[node]]\nrank = 0\nhost = "a"\n[[node]]\nrank = 1\nhost = "b"'
refused "a wrong line of a game" '^error: .*bad.toml:1:[0-9]+:' "$carom" room --line room.toml --scenario bad.toml
wrong() { # NAME PATTERN COMMAND …: exit status 2 and one such line
  local name=$1 pattern=$2
  shift 2
  "$@" >stdout 2>stderr
  [ $? = 2 ] && says "$pattern" || fail "$name: expected status 2 and one line like '$pattern'"
}
wrong "a game that is not there" "^error: --scenario: there is no file 'tipo'" "$carom" room --line room.toml --scenario tipo
wrong "an option that is none" '^error: .*--scenari' "$carom" room --line room.toml --scenari three-pucks
wrong "another rig" '^error: --rig: the rig is named already' "$carom" room --line room.toml --rig desk
refused "fewer hosts than nodes" '^error: node 2, 3 of the rig has no host' "$carom" room fewer.toml
sed 's/cave-floor/cave-front/' hosts.toml >apart.toml
refused "nodes of one host apart" '^error: node 3 of the rig is on host cave-front again' "$carom" room apart.toml
nodes twice.toml <<<$'[[node]]\nrank = 0\nslots = 3\nhost = "a"\n[[node]]\nrank = 2\nhost = "b"'
refused "a rank of two hosts" "^error: .*twice.toml:[0-9]+:8: the rank '2' is taken in line [0-9]+" "$carom" room twice.toml
nodes wrong.toml <<<$'[[node]]\nrank = 0\nhost = "a; rm x"'
refused "a host that is none" "^error: .*wrong.toml:[0-9]+:8: host is 'a; rm x'" "$carom" room wrong.toml

# Hosts that are asked by ssh, here by one that knows two of them.
mkdir bin
cat >bin/ssh <<'SSH'
#!/bin/sh
while [ "$1" = -o ]; do shift 2; done
case $1 in
  old) echo "carom 0.0.1" ;;
  bare) echo "sh: carom: not found"; exit 127 ;;
  *) echo "ssh: connect to host $1 port 22: No route to host"; exit 255 ;;
esac
SSH
chmod +x bin/ssh
for host in old bare gone; do
  nodes $host.toml <<<$'[[node]]\nrank = 0\nhost = "localhost"\n[[node]]\nrank = 1\nslots = 3\nhost = "'$host'"'
done
PATH="$out/bin:$PATH" refused "another version" '^error: host old has another version, carom 0.0.1, expected carom ' "$carom" room old.toml
PATH="$out/bin:$PATH" refused "no program" '^error: host bare does not run .*: sh: carom: not found' "$carom" room bare.toml
PATH="$out/bin:$PATH" refused "no answer" '^error: host gone does not answer: .*No route to host' "$carom" room gone.toml
refused "a status file that cannot be written" '^error: .*none/status.json cannot be written' \
  "$carom" room room.toml --no-window --status none/status.json
ls ./*.db >/dev/null 2>&1 && fail "a session that did not begin has left a file"

# Four local nodes, from the rig alone. One of them dies.
began=$(now_ms)
"$carom" room room.toml --scenario three-pucks --frames 1 --no-window --session one.db 2>stderr || fail "nothing is wrong"
usual=$(($(now_ms) - began))
"$carom" room room.toml --scenario three-pucks --switch colour=on --frames 1000000 --no-window --session game.db --status status.json 2>stderr &
job=$!
drawn() { says "^frame [0-9]+ of"; }
until_ok drawn || fail "no frame within two minutes"
status() { python3 -c 'import json, sys; print(json.load(open("status.json"))[sys.argv[1]])' "$1"; }
isAt() { [ "$(status state)" = playing ] && [ "$(status frame)" -ge "$1" ]; }
until_ok isAt 1 || fail "the status file does not follow the session: $(cat status.json)"
[ "$(status session)" = game.db ] && [ "$(status game)" = "Three pucks" ] || fail "the status is $(cat status.json)"
[ "$(python3 -c 'import json; print(len(json.load(open("status.json"))["nodes"]))')" = 4 ] || fail "the status has other nodes: $(cat status.json)"
mpirun=$(pgrep -P "$job" -x 'mpirun|prterun')
mapfile -t ranks < <(pgrep -P "$mpirun" | sort -n)
[ "${#ranks[@]}" = 4 ] || fail "expected four nodes, found ${#ranks[@]}"
kill -KILL "${ranks[2]}"
killed=$(now_ms)
until_ok says '^warning: the session was cut off after frame [0-9]+: it goes on by itself' || fail "it does not go on"
last=$(grep -oE 'after frame [0-9]+' stderr | grep -oE '[0-9]+')
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
echo "node 2 killed after frame $last: back after $took ms; a session that starts and draws one frame takes $usual"
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
