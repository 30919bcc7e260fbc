"""What visitor.sh says, on one screen: real presses and moves of a mouse, and what the session file then holds."""

import os
import pathlib
import re
import sqlite3
import subprocess
import sys
import time

carom, out, size, pictures = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3], sys.argv[4]
out.mkdir()
wide_px, high_px = map(int, size.split("x"))
RING = (247, 232, 140)  # the ring around the puck to strike, on the cloth


def fail(what):
    print("FAILED:", what)
    print((out / "stderr").read_text())
    sys.exit(1)


def query(sql):
    with sqlite3.connect(f"file:{out / 'visit.db'}?mode=ro", uri=True) as db:
        return db.execute(sql).fetchall()


def wait_until(what, holds, seconds=240.0):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        try:
            if holds():
                return
        except (sqlite3.OperationalError, IndexError):
            pass  # not there yet
        if session.poll() is not None:
            fail(f"the program ended before {what}")
        time.sleep(0.05)
    fail(f"not seen in time: {what}")


def wait_for_frames(count):
    shown = query("SELECT count(*) FROM frame")[0][0]
    wait_until(f"{count} more frames", lambda: query("SELECT count(*) FROM frame")[0][0] >= shown + count)


def do(*what):
    return subprocess.run(["xdotool", *map(str, what)], capture_output=True, text=True).stdout


def grab(*how):
    command = ["ffmpeg", "-y", "-loglevel", "error", "-f", "x11grab", "-video_size", size, "-i", os.environ["DISPLAY"]]
    return subprocess.run([*command, "-frames:v", "1", *how], capture_output=True, check=True).stdout


def picture(name):
    if pictures:
        grab(f"{pictures}/visitor-{size}-{name}.png")


def ring_px():
    """The middle of the ring on the screen, or nothing."""
    rgb = grab("-pix_fmt", "rgb24", "-f", "rawvideo", "-")
    found = []
    for y in range(window["Y"] + window["HEIGHT"] * 2 // 5, window["Y"] + window["HEIGHT"], 2):
        for x in range(window["X"], window["X"] + window["WIDTH"], 2):
            at = 3 * (y * wide_px + x)
            if all(abs(rgb[at + k] - RING[k]) < 12 for k in range(3)):
                found.append((x, y))
    if len(found) < 20:
        return None
    return tuple((min(at[k] for at in found) + max(at[k] for at in found)) // 2 for k in range(2))


def tile_px(column, row):
    """The middle of a tile: the choices are row 0, the flat ones below them 1 and 2 (cave/overlay/wall_buttons.cpp)."""
    width, gap = 0.165 * window["WIDTH"], 0.012 * window["WIDTH"]
    right = window["WIDTH"] - 0.04 * window["HEIGHT"]
    x = right - (3 - column) * width - (2 - column) * gap + width / 2
    tall, flat = 0.36 * width, 0.18 * width
    y = 0.04 * window["HEIGHT"] + (tall / 2 if row == 0 else tall + row * gap + (row - 0.5) * flat)
    return round(window["X"] + x), round(window["Y"] + y)


def click(column, row):
    do("mousemove", *tile_px(column, row))
    wait_for_frames(3)
    do("mousedown", 1)
    wait_for_frames(2)
    do("mouseup", 1)


def strike():
    """Presses in the ring, draws back and lets go; the puck moves, so until a stroke is made."""
    strokes = query("SELECT count(*) FROM stroke")[0][0]
    for _ in range(20):
        ring = ring_px()
        if ring:
            do("mousemove", *ring)
            do("mousedown", 1)
            wait_for_frames(3)
            for part in range(1, 6):
                do("mousemove", ring[0], min(ring[1] + 20 * part, high_px - 12))
                wait_for_frames(1)
            picture(f"{len(query('SELECT * FROM game'))}-drawn")
            do("mouseup", 1)
            wait_for_frames(4)
            if query("SELECT count(*) FROM stroke")[0][0] > strokes:
                return
        wait_for_frames(2)
    picture("no-stroke")
    fail("no stroke was made")


def played():
    """The title of the game that is played."""
    return re.search(r'title = "(.*)"', query("SELECT scenario FROM game ORDER BY first_frame DESC LIMIT 1")[0][0])[1]


def switches():
    return query("SELECT switches FROM frame ORDER BY number DESC LIMIT 1")[0][0]


with open(out / "stderr", "w") as errors:
    session = subprocess.Popen([carom, "cave", "--silent", "--session", out / "visit.db"], stderr=errors,
                               env={**os.environ, "HOME": str(out), "XDG_CONFIG_HOME": str(out)})  # fmt: skip
    wait_until("ten frames", lambda: query("SELECT count(*) FROM frame")[0][0] > 10)
    found = do("search", "--name", "Carom: screen").split()[0]
    window = {key: int(value) for key, value in re.findall(r"(\w+)=(\d+)", do("getwindowgeometry", "--shell", found))}
    first = played()
    picture("1-welcome")
    strike()
    wait_for_frames(8)
    picture("1-struck")
    click(1, 2)
    wait_until("the tasks", lambda: played() != first)
    tasks = played()
    wait_for_frames(8)
    picture("2-tasks")
    strike()
    wait_for_frames(8)
    picture("2-struck")
    click(2, 0)
    wait_until("Show me", lambda: played() not in (first, tasks))
    wait_for_frames(8)
    picture("3-show-me")
    before = switches()
    click(2, 2)
    wait_until("the colour", lambda: switches() != before)
    wait_for_frames(4)
    picture("3-colour")
    click(0, 0)
    wait_until("play", lambda: played() == first)
    wait_for_frames(8)
    picture("4-play")
    click(2, 1)
    wait_until("the list of keys", lambda: "keys: on" in (out / "stderr").read_text())
    wait_for_frames(4)
    picture("5-keys")
    games = query("SELECT count(*) FROM game")
    do("mousemove", window["X"] + 60, window["Y"] + 40)  # on the list; below it nothing is pressed
    wait_for_frames(3)
    do("mousedown", 1)
    wait_for_frames(2)
    do("mouseup", 1)
    wait_until("no list of keys", lambda: "keys: off" in (out / "stderr").read_text())
    if query("SELECT count(*) FROM game") != games:
        fail("a press on the list of keys began a game")
    session.terminate()
    if session.wait(timeout=240) != 0:
        fail("the session did not end well")
print(f"{size}: a stroke, a task's stroke, Show me, the colour, play and the keys, by mouse alone")
