#!/usr/bin/env bash
# link_faults.sh CAROM CONFIG: what `carom cave --link` says when it cannot begin. The line's own faults are in link_line_test.
. "$(dirname "$0")/../../session.sh"
needs python3
failures=0

expect() { # NAME STATUS PATTERN COMMAND …: exit status, a line of standard error, and no session file
  local name=$1 status=$2 pattern=$3
  shift 3
  timeout 60 "$@" --session "$out/game.db" >"$out/stdout" 2>"$out/stderr"
  local got=$?
  if [ "$got" -ne "$status" ] || ! grep -qE -- "$pattern" "$out/stderr" || [ -e "$out/game.db" ]; then
    echo "FAILED: $name: exit status $got (expected $status), a line like '$pattern', no session file; it said:"
    cat "$out/stderr"
    rm -f "$out/game.db"
    failures=$((failures + 1))
  fi
}
cave() { echo "$carom" cave --no-window --silent --rig "$out/rig.toml" "$@"; }
rig() { # KEYS OF [link] …
  { cat "$config/rigs/single-screen.toml" && printf '[link]\n' && printf '%s\n' "$@"; } >"$out/rig.toml"
}

"$carom" link --new-key "$out/room.key" >/dev/null || fail "no key is made"
rig 'name = "lyon"' 'key = "room.key"'
expect "frames in simulated time" 2 "--link|--frames" $(cave --link listen:127.0.0.1:17314 --frames 3)
"$carom" cave --no-window --silent --rig "$out/rig.toml" --scenario two-cities --frames 3 --session "$out/plain.db" 2>/dev/null ||
  fail "a session without a link"
for link in listen:127.0.0.1:17314 localhost:17314; do
  timeout 60 "$carom" cave --no-window --silent --link "$link" --resume --session "$out/plain.db" 2>"$out/stderr"
  if [ $? -ne 1 ] || ! grep -q "plain.db: it has no linked game to go on with, expected one of carom cave --link" "$out/stderr"; then
    echo "FAILED: --link $link with --resume of a session without a link; it said:"
    cat "$out/stderr"
    failures=$((failures + 1))
  fi
done
expect "a lesson" 1 "it is a lesson" $(cave --link listen:127.0.0.1:17314 --scenario twins)
expect "a gas" 1 "collision_event = .contact.|it has [0-9]+ pucks, expected 200 at most" $(cave --link listen:127.0.0.1:17314 --scenario gas)
expect "soft pucks" 1 "it has soft pucks" $(cave --link listen:127.0.0.1:17314 --scenario jellies)
expect "a game for who calls" 1 "expected no --scenario" $(cave --link localhost:1 --scenario two-cities)
expect "no port" 2 "listen" $(cave --link listen:none)
port=$(python3 -c '
import socket, sys, time, os
s = socket.create_server(("127.0.0.1", 0))
print(s.getsockname()[1], flush=True)
if os.fork() == 0:
    os.close(1)
    time.sleep(60)
')
expect "a port that is taken" 1 "another program has that port" $(cave --link "listen:127.0.0.1:$port")

chmod 0644 "$out/room.key"
expect "a key that others may read" 1 "room.key.*(0600|nobody else|others)" $(cave --link listen:127.0.0.1:17314)
chmod 0600 "$out/room.key"
tr '0123456789' '1234567890' <"$out/room.key" >"$out/typed.key" && chmod 0600 "$out/typed.key"
rig 'name = "lyon"' 'key = "typed.key"'
expect "a key that was mistyped" 1 "typed.key.*check letters" $(cave --link listen:127.0.0.1:17314)
head -c 12 "$out/room.key" >"$out/short.key" && chmod 0600 "$out/short.key"
rig 'name = "lyon"' 'key = "short.key"'
expect "a key that is too short" 1 "short.key.*it has [0-9]+ letters, expected 28" $(cave --link listen:127.0.0.1:17314)
rig 'name = "lyon"' 'key = "none.key"'
expect "no key" 1 "none.key" $(cave --link listen:127.0.0.1:17314)
cp "$config/rigs/single-screen.toml" "$out/rig.toml"
expect "a rig without a link" 1 "has no \[link\], expected one with name and key" $(cave --link listen:127.0.0.1:17314)

[ "$failures" -eq 0 ]
