#!/usr/bin/env bash
# kill_hundred.sh CAROM CONFIG [SESSIONS [SEED]]: sessions that are killed (SIGKILL) at random moments. Of every one
# the file opens and is whole, lacks two frames at most of what was shown, and the session goes on with the frame
# after its last. A hundred sessions by default; under tests/with_display or with an X display.
set -uo pipefail
carom=$1
config=$2
sessions=${3:-100}
seed=${4:-1}
RANDOM=$seed
out=$(mktemp -d)
job=
trap '[ -z "$job" ] || kill -9 "$job" 2>/dev/null; rm -rf "$out"' EXIT
fail() {
  echo "FAILED: session $i of seed $seed, killed $wait_ms ms after its first frame: $1"
  exit 1
}
# One small wall: what is tried is the file, not the drawing.
cat >"$out/room.toml" <<'END'
unit = "m"
axes = "x-right y-up z-back"
[head]
tracker = "walker"
[[tracker]]
name = "walker"
kind = "recorded"
source = "traces/walk.csv"
[[wall]]
name = "front"
lower_left = [-1.5, 0.0, -1.5]
lower_right = [1.5, 0.0, -1.5]
upper_left = [-1.5, 3.0, -1.5]
pixels = [32, 32]
stereo = "mono"
END
most=0
shortest=999999
longest=0
for i in $(seq "$sessions"); do
  wait_ms=$((RANDOM % 1500))
  db=$out/$i.db
  "$carom" cave --rig "$out/room.toml" --scenario "$config/scenarios/three-pucks.toml" --session "$db" \
    --capture "$out/seen" --no-window --frames 1000000 2>"$out/stderr" &
  job=$!
  for _ in $(seq 1200); do
    [ -e "$out/seen/front-mono-000000.png" ] && break
    kill -0 "$job" 2>/dev/null || fail "it ended: $(cat "$out/stderr")"
    sleep 0.05
  done
  sleep "$(printf '%d.%03d' $((wait_ms / 1000)) $((wait_ms % 1000)))"
  kill -KILL "$job"
  wait "$job" 2>/dev/null
  job=
  shown=$(find "$out/seen" -name 'front-mono-*.png' | sort | tail -1 | sed 's/.*-0*\([0-9]\)/\1/; s/\.png//')
  IFS='|' read -r count first last < <(sqlite3 "$db" "SELECT count(*), min(number), max(number) FROM frame") ||
    fail "the file does not open"
  [ "$(sqlite3 "$db" 'PRAGMA integrity_check')" = ok ] || fail "the file is damaged"
  [ -n "$last" ] || { last=-1 && first=0; }
  [ "$first" = 0 ] && [ "$count" = $((last + 1)) ] || fail "its $count frames go from $first to $last"
  # A picture is written before its frame is shown: the last of them may not have been.
  lacks=$((shown - last))
  [ "$lacks" -le 2 ] || fail "frame $shown was shown, the last in the file is $last"
  "$carom" cave --session "$db" --resume --no-window --frames 2 2>"$out/stderr" ||
    fail "it does not go on: $(cat "$out/stderr")"
  after=$(sqlite3 "$db" "SELECT count(*), max(number), (SELECT max(first_frame) FROM run) FROM frame")
  [ "$after" = "$((last + 3))|$((last + 2))|$((last + 1))" ] || fail "gone on with after frame $last: $after"
  [ "$lacks" -gt "$most" ] && most=$lacks
  [ "$last" -lt "$shortest" ] && shortest=$last
  [ "$last" -gt "$longest" ] && longest=$last
  rm -rf "$out/seen" "$db" "$db"-*
done
echo "$sessions sessions killed after frames $shortest to $longest (seed $seed): every file whole, $most frames lacking at most, all gone on with"
