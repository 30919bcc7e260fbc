#!/usr/bin/env bash
# walls_files.sh CONFIG: the files that start X for walls without a window manager, and the units, are such that a shell
# and systemd take them. Commands that are not installed here are no fault of theirs.
set -euo pipefail
config=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
sh -n "$config/walls/xinitrc" || fail "xinitrc"
# Its words, with commands that note how they are called.
for name in xset xsetroot xhost systemctl sleep; do
  printf '#!/bin/sh\necho "%s $*" >>"%s/called"\n' "$name" "$work" >"$work/$name"
  chmod +x "$work/$name"
done
PATH=$work:$PATH sh -eu "$config/walls/xinitrc" || fail "xinitrc ends with an error"
[ "$(tail -1 "$work/called")" = "sleep infinity" ] || fail "the X server would end: $(cat "$work/called")"
grep -qx "xhost +si:localuser:$(id -un)" "$work/called" || fail "the user may not use the display"
command -v systemd-analyze >/dev/null || { echo "skipped: systemd-analyze is not installed"; exit 77; }
# A unit for a user who is there.
cp "$config/walls/carom-walls@.service" "$work/carom-walls@$(id -un).service"
verify() { # WORDS …: what systemd says of a unit, but for commands that are missing here
  XDG_RUNTIME_DIR=$work systemd-analyze "$@" >"$work/said" 2>&1 || true
  grep -vE "is not executable: No such file or directory" "$work/said" || true
}
said=$(verify verify "$work/carom-walls@$(id -un).service" | grep carom-walls || true)
[ -z "$said" ] || fail "$said"
for unit in "$config"/systemd/*.service; do
  said=$(verify --user verify "$unit" | grep "$(basename "$unit")" || true)
  [ -z "$said" ] || fail "$said"
done
# Does this test see mistakes?
sed 's/^Restart=.*/Restart=allways/' "$config/walls/carom-walls@.service" >"$work/carom-walls@$(id -un).service"
[ -n "$(verify verify "$work/carom-walls@$(id -un).service" | grep carom-walls)" ] || fail "a mistake is not noticed"
echo "files for walls without a window manager, $(ls "$config"/systemd/*.service | wc -l) units"
