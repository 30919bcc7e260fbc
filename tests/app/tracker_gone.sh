#!/usr/bin/env bash
# tracker_gone.sh CAROM CONFIG: the head's tracker, a DTRACK controller of our own, falls silent in the middle of a
# session and comes back. The session goes on at its pace, the head is held, its celerity fades to zero within
# 1 s, standard error says who is silent since when and when it is back, and board time never jumps.
set -uo pipefail
carom=$1
config=$2
command -v python3 >/dev/null || { echo "skipped: python3 is not installed"; exit 77; }
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
python3 "$(dirname "$0")/tracker_gone.py" "$carom" "$config" "$out"
