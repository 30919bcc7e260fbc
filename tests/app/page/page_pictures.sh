#!/usr/bin/env bash
# page_pictures.sh CAROM CONFIG: the pictures of a page are those of carom replay (page_pictures.py). Left out without the
# packages of config/packages-browser.txt, and where the program was built without the engine for browsers.
. "$(dirname "$0")/../../session.sh"
needs chromium chromedriver sqlite3
/usr/bin/python3 -c 'import selenium, numpy, PIL' 2>/dev/null || { echo "skipped: python3-selenium, -numpy or -pil is not installed"; exit 77; }
sed 's/^pixels = .*/pixels = [640, 360]/' "$config/rigs/single-screen.toml" >"$out/room.toml"
"$carom" cave --rig "$out/room.toml" --scenario welcome --session "$out/welcome.db" --frames 60 --no-window --silent 2>"$out/stderr" ||
  fail "the session"
"$carom" page "$out/welcome.db" -o "$out/welcome.html" 2>"$out/stderr" || { grep -q 'without the engine for browsers' "$out/stderr" &&
  { echo "skipped: $(cat "$out/stderr")"; exit 77; }; fail "carom page"; }
"$carom" replay "$out/welcome.db" --no-window --silent --capture "$out/welcome" 2>"$out/stderr" || fail "carom replay"
/usr/bin/python3 "$(dirname "$0")/page_pictures.py" "$out" welcome || fail "the pictures of a page"
