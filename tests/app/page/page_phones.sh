#!/usr/bin/env bash
# page_phones.sh CAROM CONFIG [SHOTS]: phones follow a game live, each by the eyes of another observer, and take it home by
# the code on the wall (page_phones.py). Left out without the packages of config/packages-browser.txt, and where the program
# was built without the engine for browsers. Pictures of phones and wall are kept in SHOTS.
. "$(dirname "$0")/../../session.sh"
needs chromium chromedriver zbarimg xdotool
/usr/bin/python3 -c 'import selenium' 2>/dev/null || { echo "skipped: python3-selenium is not installed"; exit 77; }
"$carom" page three-pucks -o "$out/page.html" 2>"$out/stderr" || { grep -q 'without the engine for browsers' "$out/stderr" &&
  { echo "skipped: $(cat "$out/stderr")"; exit 77; }; fail "carom page three-pucks"; }
sed 's/^pixels = .*/pixels = [640, 360]/' "$config/rigs/single-screen.toml" >"$out/room.toml"
# The game without its lesson, which would wait for an answer.
sed -e '/^\[lesson\]/,/^\[observer\]/{/^\[observer\]/!d}' "$config/scenarios/two-cushions.toml" >"$out/two-cushions.toml"
/usr/bin/python3 "$(dirname "$0")/page_phones.py" "$carom" "$out" "${@:3}" || fail "phones of a game"
