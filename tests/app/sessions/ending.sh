#!/usr/bin/env bash
# ending.sh CAROM CONFIG: whoever asks a session to end is obeyed, in whatever it is: starting, dividing thousands of
# pucks, deciding a frame of a million bounces, drawing, on one node or two; its file is one whole then, and its
# pictures are. And one or two processes of mpirun have every core, but where mpirun is told to bind them.
. "$(dirname "$0")/../../session.sh"
kLongest_ms=120000 # on a busy machine; on a quiet one it is under 2000

now_ms() { echo $((${EPOCHREALTIME/./} / 1000)); }
start() { # COMMAND …
  rm -f "$out/stderr"
  touch "$out/stderr"
  "$@" 2>"$out/stderr" &
  job=$!
}
await() { # WHAT COMMAND …: until it succeeds
  local what=$1
  shift
  for _ in $(seq 1200); do
    "$@" && return
    kill -0 "$job" 2>/dev/null || fail "$what: the session has ended"
    sleep 0.1
  done
  fail "$what: not within two minutes"
}
has() { [ -s "$out/$1" ]; }
cpu_s() { # of a process, so far
  local fields
  fields=($(sed 's/.*) //' "/proc/$1/stat" 2>/dev/null)) || return
  echo $(((fields[11] + fields[12]) / $(getconf CLK_TCK)))
}
busyFor() { [ "$(cpu_s "$1")" -ge "$2" ]; }
ends() { # NAME: the job, asked to end
  local from status
  from=$(now_ms)
  kill -TERM "$job"
  (
    sleep $((kLongest_ms / 1000))
    kill -KILL "$job"
  ) 2>/dev/null &
  local guard=$!
  wait "$job"
  status=$?
  kill "$guard" 2>/dev/null
  wait "$guard" 2>/dev/null
  job=
  [ "$status" -ne 137 ] || fail "$1: goes on for $kLongest_ms ms after SIGTERM"
  case $status in 134 | 136 | 139) fail "$1: it broke while it ended, status $status" ;; esac
  echo "$1: ended after $(($(now_ms) - from)) ms, status $status"
}
whole() { # FILE: closed, so that it is whole alone
  [ -e "$out/$1" ] || return 0 # it ended before there was one
  [ ! -s "$out/$1-wal" ] || fail "$1: it was not closed"
  [ "$(sqlite3 "$out/$1" 'PRAGMA integrity_check')" = ok ] || fail "$1: damaged"
  [ "$(sqlite3 "$out/$1" "SELECT count(*) FROM session WHERE key = 'ended_utc'")" = 1 ] || fail "$1: it does not say its end"
}

# Nine thousand pucks, and a game of which one frame is a million bounces.
{
  printf 'title = "Many"\nlight_speed_m_s = 1.42\n'
  awk 'BEGIN { print "puck = ["; for (i = 0; i < 9000; ++i)
    printf "{ name = \"p%d\", radius_m = 0.02, height_m = 0.02, mass_kg = 0.2, position_m = [%.2f, %.2f], beta = [0.0, 0.0] },\n",
      i, 0.25 * (i % 100) - 12.4, 0.2 * int(i / 100) - 8.9; print "]" }'
  printf '[board]\nlength_m = 30.0\nwidth_m = 20.0\n[observer]\nposition_m = [0.0, -12.0, -0.75]\n'
} >"$out/pucks.toml"
sed 's/^light_speed_m_s = .*/light_speed_m_s = 3e8/' "$config/scenarios/three-pucks.toml" >"$out/fast.toml"
sed 's/^pixels = .*/pixels = [64, 64]/' "$config/rigs/four-walls-cluster.toml" >"$out/room.toml"
cave=("$carom" cave --rig "$out/room.toml" --no-window --frames 1000000)

for cpu_s in 1 6; do
  start "${cave[@]}" --scenario "$out/pucks.toml" --session "$out/many-$cpu_s.db"
  await "nine thousand pucks" busyFor "$job" $cpu_s
  ends "nine thousand pucks, after $cpu_s s of work"
  whole "many-$cpu_s.db"
done

start "${cave[@]}" --scenario "$out/fast.toml" --session "$out/fast.db" # busy with its first frame
await "light as fast as it is" has fast.db
ends "a million bounces a frame"
whole fast.db

start "${cave[@]}" --session "$out/one.db" --capture "$out/one"
await "pictures" has one/front-left-000030.png
ends "one node"
whole one.db
[ -z "$(find "$out/one" -name '*.partial')" ] || fail "a picture is not whole"
"$carom" events "$out/one.db" --csv "$out/events.csv" 2>"$out/stderr" || fail "its events"

start "${mpi[@]}" -n 2 "${cave[@]}" --session "$out/two.db"
await "frames of two nodes" grep -q '^frame 30 of' "$out/stderr"
ends "two nodes"
whole two.db

cores() { sed -n 's/^Cpus_allowed_list:\s*//p' "/proc/$1/status"; }
all=$("${mpi[@]}" --bind-to none -n 1 sed -n 's/^Cpus_allowed_list:\s*//p' /proc/self/status)
for ranks in 1 2; do
  start "${mpi[@]}" -n $ranks "${cave[@]}"
  await "$ranks ranks" grep -q '^frame 30 of' "$out/stderr"
  for process in $(pgrep -P "$job"); do
    [ "$(cores "$process")" = "$all" ] || fail "$ranks ranks: one may use the cores $(cores "$process"), expected $all"
  done
  ends "$ranks ranks on every core"
done
start "${mpi[@]}" --bind-to core -n 1 "${cave[@]}"
await "a rank that is bound" grep -q '^frame 30 of' "$out/stderr"
bound=$("${mpi[@]}" --bind-to core -n 1 sed -n 's/^Cpus_allowed_list:\s*//p' /proc/self/status)
[ "$(cores "$(pgrep -P "$job")")" = "$bound" ] || fail "mpirun --bind-to core: its cores are $(cores "$(pgrep -P "$job")")"
ends "a rank that is bound"
