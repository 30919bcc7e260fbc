#!/usr/bin/env bash
# planted_crash.sh TARGET: when a target crashes on a mutation, the driver keeps the input and prints a command, and
# the command crashes on that input again. Shown for an abort, an exception, a signal and an
# input that never ends.
set -euo pipefail
target=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
ulimit -c 0
exec 2>"$work/notices"  # the shell's own, on every program that a signal ends
status=0
fail() { echo "FAILED: $*"; status=1; }

for kind in abort exception segmentation hang; do
  mkdir "$kind"
  printf '%s' "${kind:0:6}" >"$kind/short"  # too short to crash; mutations are longer
  if "$target" -seed=3 -runs=20000 -timeout=1 "$kind" >"$kind.out" 2>&1; then fail "no $kind was found"; continue; fi
  command=$(sed -n 's/^crashed; again: //p' "$kind.out")
  kept=${command##* }
  case $kept in "$work"/crash-3-[0-9]*) ;; *) fail "$kind: no command in: $(cat "$kind.out")"; continue ;; esac
  [ "$(wc -c <"$kept")" -gt 8 ] || fail "$kind: the kept input is not the one that crashed"
  [ "$(head -c 1 "$kept")" = "${kind:0:1}" ] || fail "$kind: the kept input is of another kind"
  cp "$kept" before
  if $command >again.out 2>&1; then fail "$kind: the command does not crash"; fi
  grep -qF "crashed; again: $command" again.out || fail "$kind: the command crashes elsewhere: $(cat again.out)"
  cmp -s before "$kept" || fail "$kind: the kept input was written again"
  rm "$kept"
done
exit $status
