#!/usr/bin/env bash
# spacetime_hands.sh CAROM CONFIG: in whole sessions a wand, and then a mouse, picks a bead of the spacetime that stands in
# the room, turns it, and boosts it by its ring. Each session is replayed with the same pictures.
. "$(dirname "$0")/../../session.sh"
needs python3 xdotool
python3 "$(dirname "$0")/spacetime_hands.py" "$carom" "$config" "$out"
