#!/usr/bin/env bash
# class_browser.sh CAROM CONFIG: a class in a browser (class_browser.py): three phones and the teacher in Chromium, two
# scripted phones, joined by the address that is read off the captured wall. With CAROM_SHOTS the screenshots of all states are
# kept in that folder. Left out without the packages of config/packages-browser.txt.
. "$(dirname "$0")/../../session.sh"
needs chromium chromedriver zbarimg
/usr/bin/python3 -c 'import selenium' 2>/dev/null || { echo "skipped: python3-selenium is not installed"; exit 77; }
sed -e 's/^pixels = .*/pixels = [640, 360]/; s/^display_hz = .*/display_hz = 10.0/' "$config/rigs/single-screen.toml" >"$out/room.toml"
/usr/bin/python3 "$(dirname "$0")/class_browser.py" "$carom" "$out" "${CAROM_SHOTS:-$out/shots}" || fail "the class in a browser"
