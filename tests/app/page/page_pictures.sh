#!/usr/bin/env bash
# page_pictures.sh CAROM CONFIG: the pictures of a page are those of carom replay (page_pictures.py). By default of two frames of
# a session; with CAROM_PAGE_FRAMES=N of N frames of five sessions, for minutes. Left out without the packages of
# config/packages-browser.txt, and where the program was built without the engine for browsers.
. "$(dirname "$0")/../../session.sh"
needs chromium chromedriver sqlite3
/usr/bin/python3 -c 'import selenium, numpy, PIL' 2>/dev/null || { echo "skipped: python3-selenium, -numpy or -pil is not installed"; exit 77; }
pixels() { sed "s/^pixels = .*/pixels = [$2]/; s#traces/#$config/traces/#" "$config/rigs/$1.toml" >"$out/$1.toml"; }
page() { # NAME [OPTION …]: the page of a session, and the pictures of its replay
  "$carom" page "$out/$1.db" -o "$out/$1.html" "${@:2}" 2>"$out/stderr" || { grep -q 'without the engine for browsers' "$out/stderr" &&
    { echo "skipped: $(cat "$out/stderr")"; exit 77; }; fail "carom page"; }
  "$carom" replay "$out/$1.db" --no-window --silent --capture "$out/$1" ${3:+--at "$3"} 2>"$out/stderr" || fail "carom replay"
}
play() { # NAME RIG SCENARIO FRAMES FROM_S [OPTION …]: in simulated time
  "$carom" cave --rig "$out/$2.toml" --scenario "$3" --session "$out/$1.db" --frames "$4" --no-window --silent "${@:6}" 2>"$out/stderr" || fail "the session $1"
  page "$1" --from "$5"
}
rows() { sqlite3 -readonly "$out/struck.db" "SELECT count(*) FROM $1" 2>/dev/null || echo 0; }
await() { # TABLE COUNT: so many more rows
  local count=$(($(rows "$1") + $2))
  for _ in $(seq 1200); do [ "$(rows "$1")" -lt "$count" ] || return 0; sleep 0.1; done
  fail "in vain: $count rows of $1"
}
struck() { # a game that goes on, in which the mouse draws back from the white puck and lets go
  "$carom" cave --rig "$out/play.toml" --scenario welcome --session "$out/struck.db" --silent 2>"$out/stderr" &
  job=$!
  await frame 20
  xdotool mousemove 646 626
  await frame 5
  xdotool mousedown 1
  await frame 5
  for y in 636 646 656 666 676; do
    xdotool mousemove 650 "$y"
    await frame 2
  done
  xdotool mouseup 1
  await stroke 1
  await frame 90
  kill "$job"; wait "$job" || fail "the struck session"
  job=
  page struck
}

if [ -z "${CAROM_PAGE_FRAMES:-}" ]; then
  pixels single-screen '320, 180'
  play welcome single-screen welcome 36 0
  sessions=(welcome:0.02) # the flashes of the strokes with which it begins are on the walls alone
else
  needs xdotool
  pixels single-screen '640, 360'
  pixels play '640, 360'
  pixels desk '400, 400'
  # So that the twin turns back at 0.9 c: tanh(1.0 × 2.1 / 1.42).
  sed 's/0\.9, 0\.0\]/1.0, 0.0]/; s/^for_s = 2\.0/for_s = 2.1/; s/^for_s = 4\.0/for_s = 4.2/' "$config/scenarios/twins.toml" >"$out/flight.toml"
  play welcome single-screen welcome 60 0
  struck
  play two-cushions single-screen two-cushions 120 0 --lesson explains
  play english single-screen english 180 1.5
  play flight single-screen "$out/flight.toml" 180 1.5
  play desk desk three-pucks 470 6.7 # the walk begins after five seconds
  sessions=(welcome:0.02 struck:0.1 two-cushions:0.1 english:0.03 flight:0.12 desk)
fi
# An observer who rests elsewhere in the room, and one who goes at half the speed of light.
for speed_m_s in 0 0.82; do
  awk -v speed="$speed_m_s" 'BEGIN { print "time_s,x_m,y_m,z_m,qx,qy,qz,qw";
    for (i = 0; i < 200; ++i) printf "%.6f,%.6f,1.5,-0.3,0,0,0,1\n", i / 60, -0.5 + speed * i / 60 }' >"$out/trace.csv"
  "$carom" export "$out/welcome.db" --observer "$out/trace.csv" --csv "$out/seen-$speed_m_s.csv" 2>"$out/stderr" || fail "carom export"
done
/usr/bin/python3 "$(dirname "$0")/page_pictures.py" "$out" "${sessions[@]}" welcome@seen-0.csv welcome@seen-0.82.csv || fail "the pictures of a page"
