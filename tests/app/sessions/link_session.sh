#!/usr/bin/env bash
# link_session.sh CAROM CONFIG: two rooms, each a session of its own, play one game through a proxy that delays every byte by
# 100 ms. People with wands, whom an OSC sender of our own moves, strike the pucks in turn. The line is cut for 2 s, and they
# go on; it is silent for 12 s, and they begin a new game; one is killed, and the other lives on. carom compare then finds one
# game in both files, and each file alone shows its own pictures again.
. "$(dirname "$0")/../../session.sh"
needs python3
python3 "$(dirname "$0")/link_session.py" "$carom" "$config" "$out"
