#!/usr/bin/env bash
# force_ends.sh CAROM CONFIG: an arm behind a VRPN server draws the cue; a second session is told that the arm is taken;
# SIGTERM while it pushes, an exception and a lost node leave it
# at 0 N, and the log and the session file say why. `carom track --list` names the arm.
. "$(dirname "$0")/../../session.sh"
needs python3
python3 "$(dirname "$0")/force_ends.py" "$1" "$2" "$out"
