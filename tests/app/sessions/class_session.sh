#!/usr/bin/env bash
# class_session.sh CAROM CONFIG: a class of scripted phones in a whole session (class_session.py): two lessons, keys on the
# wall, a session that is killed while a vote is open and resumed; and without --class no socket and no table of votes.
. "$(dirname "$0")/../../session.sh"
needs python3 sqlite3 xdotool
sed -e 's/^pixels = .*/pixels = [96, 54]/' "$config/rigs/single-screen.toml" >"$out/room.toml"
python3 "$(dirname "$0")/class_session.py" "$carom" "$config" "$out" || fail "the class"
