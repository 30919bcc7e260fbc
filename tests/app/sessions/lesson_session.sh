#!/usr/bin/env bash
# lesson_session.sh CAROM CONFIG: a lesson in a real window asks first, and the person's time stands still meanwhile; a
# number that is no answer changes nothing, one that is sets the game going; Enter explains; Y plays the game again
# without asking, and once it was explained asks anew, which Enter passes over. The session file has the answers of each
# game, in words and in the frames, and replays as it was. A session that ends by itself does not ask.
. "$(dirname "$0")/../../session.sh"
needs xdotool sqlite3
file=class
ask() { # GAME SQL: of the rows of that game, counted from 1
  local first="(SELECT first_frame FROM main.game ORDER BY first_frame LIMIT 1 OFFSET $1 - 1)" views="" table
  for table in "frame number" "answer frame" "input frame"; do
    views+="CREATE TEMP VIEW ${table% *} AS SELECT * FROM main.${table% *} WHERE ${table#* } >= $first AND
      ${table#* } < (SELECT coalesce(min(first_frame), 1e18) FROM main.game WHERE first_frame > $first);"
  done
  sqlite3 "$out/$file.db" "$views $2" 2>/dev/null
}
await() { # GAME SQL: until it is 1
  for _ in $(seq 600); do
    [ -s "$out/$file.db" ] && [ "$(ask "$1" "$2")" = 1 ] && return
    sleep 0.1
  done
  fail "game $1: not within a minute: $2"
}
more_frames() { await "$1" "SELECT count(*) >= $(($(ask "$1" "SELECT count(*) FROM frame") + 15)) FROM frame"; }
expect() { # GAME SQL VALUE WORDS
  local is
  is=$(ask "$1" "$2")
  [ "$is" = "$3" ] || fail "$4: $is, expected $3"
}

sed -e 's/^pixels = .*/pixels = [96, 54]/' "$config/rigs/single-screen.toml" >"$out/room.toml"
"$carom" cave --rig "$out/room.toml" --scenario "$config/scenarios/light-clock.toml" --session "$out/class.db" \
  2>"$out/stderr" &
job=$!
await 1 "SELECT count(*) >= 15 FROM frame"
press 4 screen
more_frames 1
expect 1 "SELECT count(DISTINCT t_s) + count(DISTINCT proper_time_s) FROM frame" 2 \
  "board and own times while it asks"
press 2 screen
await 1 "SELECT count(*) = 1 FROM answer"
answered=$(ask 1 "SELECT frame FROM answer")
expect 1 "SELECT answer FROM answer" "4 times" "the answer"
expect 1 "SELECT count(*) FROM input WHERE what = 'lesson' AND value = 'shows, answered 2'" 1 "the input"
await 1 "SELECT max(t_s) - min(t_s) > 0.3 FROM frame"
expect 1 "SELECT count(DISTINCT t_s) FROM frame WHERE number < $answered" 1 "board times before the answer"
press y screen
await 2 "SELECT max(t_s) - min(t_s) > 0.3 FROM frame"
expect 2 "SELECT count(*) FROM answer" 0 "answers to a game that is only seen again"
press Return screen
await 2 "SELECT count(*) = 1 FROM input WHERE value = 'explains, answered 2'"
more_frames 2
press y screen
await 3 "SELECT count(*) >= 15 FROM frame"
expect 3 "SELECT count(DISTINCT t_s) FROM frame" 1 "board times while it asks anew"
press Return screen
await 3 "SELECT count(*) = 1 FROM answer WHERE answer = '(skipped)'"
more_frames 3
end_session screen
wait "$job" || fail "the session did not end well"
job=

frames=$(ask 1 "SELECT count(*) FROM frame")
"$carom" replay "$out/class.db" --game 1 --capture "$out/pictures" --no-window 2>"$out/stderr" || fail "the replay"
[ "$(find "$out/pictures" -name '*.png' | wc -l)" = "$frames" ] || fail "the replay has not all $frames pictures"
asked=$(printf '%s/pictures/screen-mono-%06d.png' "$out" $((answered - 1)))
shown=$(printf '%s/pictures/screen-mono-%06d.png' "$out" $((answered + 1)))
! cmp -s "$asked" "$shown" || fail "the panel says the same before and after the answer"

"$carom" cave --rig "$out/room.toml" --scenario "$config/scenarios/light-clock.toml" --session "$out/alone.db" \
  --frames 5 --no-window 2>"$out/stderr" || fail "a session of five frames"
file=alone
expect 1 "SELECT count(DISTINCT t_s) FROM frame" 5 "board times of a session that ends by itself"
echo "a lesson was asked, answered, shown, explained, shown again and asked anew: $frames frames of the first game"
