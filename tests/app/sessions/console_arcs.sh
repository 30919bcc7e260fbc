#!/usr/bin/env bash
# console_arcs.sh CAROM CONFIG: the console's small pictures of curved walls have the colours of these walls' windows,
# everywhere: Mesa's software renderer coloured some of their tiles by their place. Skipped without xdotool and ffmpeg.
. "$(dirname "$0")/../../session.sh"
needs xdotool ffmpeg python3

cp -r "$config/traces" "$out/traces"
sed "s#\"traces/#\"$out/traces/#" "$config/rigs/cylinder.toml" >"$out/room.toml"
printf '\n[console]\nwindow = { position = [600, 300], size = [1280, 860] }\n' >>"$out/room.toml"
"$carom" cave --rig "$out/room.toml" --scenario three-pucks --console --silent 2>"$out/stderr" >"$out/stdout" &
job=$!
python3 - "$job" <<'E2' || fail "the small pictures"
import os
import subprocess
import sys
import time

# Where the console draws the four small pictures of 207 x 110 pixels (app/console_parts/console_walls.cpp lays them out).
LEFTS, TOP, SIZE = (994, 1210, 1427, 1643), 423, (207, 109)
WINDOWS, WINDOW = [(40 + 450 * i, 40) for i in range(4)], (450, 240)
COLUMNS, ROWS = 6, 3
until = time.monotonic() + 100


def screen():
    raw = subprocess.run(["ffmpeg", "-loglevel", "error", "-f", "x11grab", "-video_size", "1920x1200", "-i", os.environ["DISPLAY"],
                          "-frames:v", "1", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], capture_output=True, check=True).stdout
    assert len(raw) == 1920 * 1200 * 3
    return raw


def means(raw, corner, size):
    """The mean colour of each cell of a rectangle, leaving its rim out."""
    cells = []
    for row in range(ROWS):
        for column in range(COLUMNS):
            total, count = [0, 0, 0], 0
            for y in range(corner[1] + size[1] * row // ROWS + 2, corner[1] + size[1] * (row + 1) // ROWS - 2):
                for x in range(corner[0] + size[0] * column // COLUMNS + 2, corner[0] + size[0] * (column + 1) // COLUMNS - 2):
                    total = [t + c for t, c in zip(total, raw[3 * (1920 * y + x):3 * (1920 * y + x) + 3])]
                    count += 1
            cells.append([t / count for t in total])
    return cells


def worst(raw):
    return max(abs(a - b) for left, window in zip(LEFTS, WINDOWS) for small, large in zip(means(raw, (left, TOP), SIZE), means(raw, window, WINDOW))
               for a, b in zip(small, large))


while True:
    os.kill(int(sys.argv[1]), 0)
    raw = screen()
    lit = min(max(max(cell) for cell in means(raw, (left, TOP), SIZE)) for left in LEFTS)
    if lit > 60:
        break
    assert time.monotonic() < until, "the console does not show the walls"
    time.sleep(0.5)
time.sleep(1)
found = [worst(screen()) for _ in range(3)]
print(f"least difference of the worst cell, of 255: {min(found):.1f}")
# Windows of the desk and small pictures are shrunk by other filters, and may be a frame apart.
sys.exit(min(found) > 20)
E2
kill -TERM "$job" 2>/dev/null
wait "$job"
job=
