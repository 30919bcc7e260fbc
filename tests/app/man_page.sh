#!/usr/bin/env bash
# man_page.sh CAROM PAGE: the manual page renders without a warning, and names exactly the commands, and in each
# command's part exactly the options, that the program itself names.
set -euo pipefail
carom=$1
page=$2
command -v man >/dev/null || { echo "skipped: man is not installed"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0
fail() { echo "FAILED: $*"; status=1; }

LC_ALL=C.UTF-8 MANWIDTH=100 MANROFFOPT=-c man --warnings -l "$page" 2>"$work/warnings" | col -bx >"$work/page"
[ ! -s "$work/warnings" ] || fail "the page renders with warnings: $(cat "$work/warnings")"
grep -q '^EXIT STATUS' "$work/page" || fail "there is no rendered page"

# Names of commands and options, one a line, sorted.
commands_of_program() { "$carom" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p' | sort; }
commands_of_page() { sed -n 's/^   carom \([a-z]\+\).*/\1/p' "$work/page" | sort; }
options_of_program() {
  "$carom" "$1" --help | sed -n '/^Options:/,/^$/p' | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE '\-\-[a-z-]+' |
    grep -vxE -- '--help(-all)?' | sort
}
options_of_page() {
  sed -n "/^   carom $1\( .*\)\?\$/,\$p" "$work/page" | tail -n +2 | sed '/^ \{0,3\}[^ ]/,$d' |
    grep -oE '^       (-[a-z], )?--[a-z-]+' | grep -oE '\-\-[a-z-]+' | sort
}

commands_of_program >"$work/commands"
[ "$(wc -l <"$work/commands")" -ge 9 ] || fail "carom --help names $(wc -l <"$work/commands") commands, expected 9 or more"
differences=$(diff "$work/commands" <(commands_of_page)) || fail "commands (< program, > page):" "$differences"
options=0
while read -r name; do
  options_of_program "$name" >"$work/program" || true
  options=$((options + $(wc -l <"$work/program")))
  differences=$(diff "$work/program" <(options_of_page "$name" || true)) ||
    fail "options of $name (< program, > page):" "$differences"
done <"$work/commands"
[ "$options" -ge 30 ] || fail "the commands' helps name $options options, expected 30 or more"
exit $status
