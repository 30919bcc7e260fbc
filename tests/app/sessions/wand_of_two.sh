#!/usr/bin/env bash
# wand_of_two.sh CAROM CONFIG: a wand whose place and whose buttons are devices of two VRPN servers plays a stroke; and
# what is said of names that a server does not have, and of one whose clock stands. The servers are our own and
# do with names and pings as vrpn_server does.
. "$(dirname "$0")/../../session.sh"
needs python3
python3 "$(dirname "$0")/wand_of_two.py" "$carom" "$config" "$out"
