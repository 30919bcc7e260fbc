# Sourced by tests that press keys and click in a real session: the program's and the configuration's paths, a folder
# `out` and the session's process `job`, which both go when the test ends, and how keys reach a window.
carom=$1
config=$2
for tool in xdotool sqlite3; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
out=$(mktemp -d)
job=
trap '[ -z "$job" ] || kill -9 "$job" 2>/dev/null; rm -rf "$out"' EXIT
fail() {
  echo "FAILED: $1"
  cat "$out/stderr"
  exit 1
}
press() { # KEY WALL. Not checked: a window that a key closes is gone before the key is let go
  xdotool key --window "$(xdotool search --name "Carom: $2" | head -1)" "$1" 2>/dev/null || true
}
end_session() { # WALL: Escape asks, and ends when it is pressed again
  press Escape "$1"
  press Escape "$1"
}
