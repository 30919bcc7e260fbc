#!/usr/bin/env bash
# tracker_gone.sh CAROM CONFIG: the head's tracker, a DTRACK controller of our own, falls silent in the middle of a
# session and comes back. The session goes on at its pace, the head is held, its celerity fades to zero within
# 1 s, standard error says who is silent since when and when it is back, and board time never jumps.
. "$(dirname "$0")/../../session.sh"
needs python3
python3 "$(dirname "$0")/tracker_gone.py" "$carom" "$config" "$out"
