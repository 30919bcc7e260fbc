#!/usr/bin/env bash
# study_session.sh CAROM CONFIG: twelve participants of a study from slip to export, in a whole session (study_session.py).
. "$(dirname "$0")/../../session.sh"
needs python3 sqlite3
sed -e 's/^pixels = .*/pixels = [96, 54]/' "$config/rigs/single-screen.toml" >"$out/room.toml"
python3 "$(dirname "$0")/study_session.py" "$carom" "$config" "$out" || fail "the study"
