#!/usr/bin/env bash
# page_engine.sh CAROM CONFIG: the engine of a page computes what the program computes (page_engine.py). Left out without the
# packages of config/packages-browser.txt, and where the program was built without the engine for browsers.
. "$(dirname "$0")/../../session.sh"
needs chromium chromedriver
/usr/bin/python3 -c 'import selenium' 2>/dev/null || { echo "skipped: python3-selenium is not installed"; exit 77; }
"$carom" page three-pucks -o "$out/page.html" 2>"$out/stderr" || { grep -q 'without the engine for browsers' "$out/stderr" &&
  { echo "skipped: $(cat "$out/stderr")"; exit 77; }; fail "carom page three-pucks"; }
/usr/bin/python3 "$(dirname "$0")/page_engine.py" "$carom" "$out" || fail "the engine of a page"
