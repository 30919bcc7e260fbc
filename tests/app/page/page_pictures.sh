#!/usr/bin/env bash
# page_pictures.sh CAROM CONFIG: the pictures of a page are those of carom replay (page_pictures.py). Left out without the
# packages of config/packages-browser.txt, and where the program was built without the engine for browsers.
. "$(dirname "$0")/../../session.sh"
needs chromium chromedriver sqlite3
/usr/bin/python3 -c 'import selenium, numpy, PIL' 2>/dev/null || { echo "skipped: python3-selenium, -numpy or -pil is not installed"; exit 77; }
pixels='320, 180' frames=36
[ -z "${CAROM_PAGE_FRAMES:-}" ] || { pixels='640, 360'; frames=60; }
sed "s/^pixels = .*/pixels = [$pixels]/" "$config/rigs/single-screen.toml" >"$out/room.toml"
"$carom" cave --rig "$out/room.toml" --scenario welcome --session "$out/welcome.db" --frames "$frames" --no-window --silent 2>"$out/stderr" ||
  fail "the session"
"$carom" page "$out/welcome.db" -o "$out/welcome.html" 2>"$out/stderr" || { grep -q 'without the engine for browsers' "$out/stderr" &&
  { echo "skipped: $(cat "$out/stderr")"; exit 77; }; fail "carom page"; }
"$carom" replay "$out/welcome.db" --no-window --silent --capture "$out/welcome" 2>"$out/stderr" || fail "carom replay"
# An observer who rests elsewhere in the room, and one who goes at half the speed of light.
for speed_m_s in 0 0.82; do
  awk -v speed="$speed_m_s" 'BEGIN { print "time_s,x_m,y_m,z_m,qx,qy,qz,qw";
    for (i = 0; i < 200; ++i) printf "%.6f,%.6f,1.5,-0.3,0,0,0,1\n", i / 60, -0.5 + speed * i / 60 }' >"$out/trace.csv"
  "$carom" export "$out/welcome.db" --observer "$out/trace.csv" --csv "$out/seen-$speed_m_s.csv" 2>"$out/stderr" || fail "carom export"
done
/usr/bin/python3 "$(dirname "$0")/page_pictures.py" "$out" welcome welcome@seen-0.csv welcome@seen-0.82.csv || fail "the pictures of a page"
