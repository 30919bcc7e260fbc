# Sourced by tests that run sessions, as . "$(dirname "$0")/../../session.sh". They are called with the program and the
# folder of its configuration, and have a folder `out` and a session's process `job`, which both go when the test ends.
set -uo pipefail
carom=$1
config=$2
out=$(mktemp -d)
job=
trap '[ -z "$job" ] || kill -9 "$job" 2>/dev/null; rm -rf "$out"' EXIT
mpi=(mpirun --allow-run-as-root --oversubscribe)
needs() { # TOOL …: the test is skipped where one is missing
  local tool
  for tool in "$@"; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
  done
}
fail() { # WORDS: and what the program said last
  echo "FAILED: $1"
  [ ! -s "$out/stderr" ] || cat "$out/stderr"
  exit 1
}
press() { # KEY WALL. Not checked: a window that a key closes is gone before the key is let go
  xdotool key --window "$(xdotool search --name "Carom: $2" | head -1)" "$1" 2>/dev/null || true
}
end_session() { # WALL: Escape asks, and ends when it is pressed again
  press Escape "$1"
  press Escape "$1"
}
