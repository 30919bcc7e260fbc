#!/usr/bin/env bash
# calibrate_live.sh CAROM: a tracker is calibrated live, with keys and with the wand's button, against a DTRACK sender of
# our own, which touches what the program asks for; and again from the recording of it.
set -uo pipefail
command -v python3 >/dev/null || { echo "skipped: python3 is not installed"; exit 77; }
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
python3 "$(dirname "$0")/calibrate_live.py" "$1" "$out"
