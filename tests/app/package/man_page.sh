#!/usr/bin/env bash
# man_page.sh CAROM PAGE: the manual page renders without a warning, and has a section for each command that the program
# names, with the examples of its help.
set -euo pipefail
carom=$1
page=$2
command -v man >/dev/null || { echo "skipped: man is not installed"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0
fail() { echo "FAILED: $*"; status=1; }

LC_ALL=C.UTF-8 MANWIDTH=200 MANROFFOPT=-c man --warnings -l "$page" 2>"$work/warnings" | col -bx >"$work/page"
[ ! -s "$work/warnings" ] || fail "the page renders with warnings: $(cat "$work/warnings")"
grep -q '^EXIT STATUS' "$work/page" || fail "there is no rendered page"

names=$("$carom" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p')
[ "$(wc -w <<<"$names")" -ge 16 ] || fail "carom --help names these commands: $names"
for name in $names; do
  grep -qE "^   carom $name( |$)" "$work/page" || fail "there is no section of carom $name"
  while read -r option; do
    grep -qE "^       $option( |$)" "$work/page" || fail "carom $name: there is no $option"
  done < <("$carom" "$name" --help | sed -n '/^Options:/,/^$/p' | grep -oE '^  --[a-z-]+' | tr -d ' ' | grep -v '^--help')
  while read -r example; do
    grep -qF "$example" "$work/page" || fail "carom $name: there is no example $example"
  done < <("$carom" "$name" --help | sed -n '/^Examples\?:/,$s/^  \(carom .*\)/\1/p')
done
exit $status
