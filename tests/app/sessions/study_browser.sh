#!/usr/bin/env bash
# study_browser.sh CAROM CONFIG: a person takes part in a study with a tablet (study_browser.py). With CAROM_SHOTS the screenshots
# of all pages are kept in that folder. Left out without the packages of config/packages-browser.txt.
. "$(dirname "$0")/../../session.sh"
needs chromium chromedriver sqlite3
/usr/bin/python3 -c 'import selenium' 2>/dev/null || { echo "skipped: python3-selenium is not installed"; exit 77; }
sed -e 's/^pixels = .*/pixels = [96, 54]/' "$config/rigs/single-screen.toml" >"$out/room.toml"
/usr/bin/python3 "$(dirname "$0")/study_browser.py" "$carom" "$out" "${CAROM_SHOTS:-$out/shots}" || fail "the study in a browser"
