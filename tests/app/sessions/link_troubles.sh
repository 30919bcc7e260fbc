#!/usr/bin/env bash
# link_troubles.sh CAROM CONFIG: what may happen to one of two linked rooms. The disk of one is full for a while, and both play
# on. A computer of the host is lost: its session ends, the other room plays on alone; the host comes back by --resume with its game
# and all strokes, and the other joins it. Who has joined is killed, and comes back by --resume. carom compare then finds one game.
. "$(dirname "$0")/../../session.sh"
needs python3 mpirun pgrep
python3 "$(dirname "$0")/link_troubles.py" "$carom" "$config" "$out"
