"""visit.py CAROM CONFIG PICTURES [WIDTHxHEIGHT [wand]]: a visitor's way by the mouse alone, with real events on a virtual
display, or by a wand alone, a Flystick that DTRACK sends of; to be looked at: welcome, lesson, answer, explanation, next
lesson, velocities, out again, the show, the game; the console that waits where the screen is small; Escape, which asks.
Each click of the mouse lasts for less than a frame. Buttons are found by their colour in the screenshot, as a person sees
them. Leaves a screenshot of each state in PICTURES. Needs xvfb-run, xdotool, ffmpeg."""

import math
import os
import pathlib
import socket
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time

carom, config, pictures = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
width, height = map(int, (sys.argv[4] if len(sys.argv) > 4 else "1280x720").split("x"))
by_wand = sys.argv[5:] == ["wand"]
if "VISIT_DISPLAY" not in os.environ:
    screen = f"-screen 0 {width}x{height}x24"
    os.execvpe("xvfb-run", ["xvfb-run", "-a", "-s", screen, sys.executable, *sys.argv], {**os.environ, "VISIT_DISPLAY": "1"})
pictures.mkdir(parents=True, exist_ok=True)
out = pathlib.Path(tempfile.mkdtemp())
os.environ["XDG_CONFIG_HOME"] = str(out)


def fail(what):
    screenshot("failed")
    session.kill()
    sys.exit(f"FAILED: {what}\n{(out / 'stderr').read_text()}")


def query(sql):
    try:
        with sqlite3.connect(f"file:{out / 'visit.db'}?mode=ro", uri=True) as db:
            return db.execute(sql).fetchall()
    except sqlite3.OperationalError:
        return []


def frames():
    rows = query("SELECT count(*) FROM frame")
    return rows[0][0] if rows else 0


def wait(what, holds, seconds=120.0):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if holds():
            return
        if session.poll() is not None:
            fail(f"the program ended before {what}")
        time.sleep(0.1)
    fail(f"not seen in time: {what}")


def wait_frames(count):
    shown = frames()
    wait(f"{count} more frames", lambda: frames() >= shown + count)


def grabbed():
    grab = ["ffmpeg", "-loglevel", "error", "-f", "x11grab", "-video_size", f"{width}x{height}", "-i",
            os.environ["DISPLAY"], "-frames:v", "1"]  # fmt: skip
    return subprocess.run([*grab, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], capture_output=True, check=True).stdout


def screenshot(name):
    raw = grabbed()
    size = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-video_size", f"{width}x{height}", "-i", "-"]
    subprocess.run(["ffmpeg", "-y", "-loglevel", "error", *size, str(pictures / f"{name}.png")], input=raw, check=True)
    print(f"{name}: {frames()} frames", flush=True)
    return raw


def boxes(raw, is_of):
    """The rectangles of a colour in the wall's window, from the top, then from the left: a row without a letter, and down
    at its left edge."""
    left, top, wide, high = window()

    def matches(x, y):
        at = 3 * (width * y + x)
        return is_of(raw[at], raw[at + 1], raw[at + 2])

    found = []
    for y in range(top, min(top + high, height), 2):
        x = left
        while x < min(left + wide, width):
            begin = x
            while x < min(left + wide, width) and matches(x, y):
                x += 1
            known = any(b[0] < x and begin < b[2] and b[1] <= y <= b[3] + 2 for b in found)
            if x - begin >= 40 and not known:
                end = y
                while end + 1 < height and matches(begin + 3, end + 1):
                    end += 1
                if end - y >= 12:
                    found.append((begin, y, x, end))
            x += 1
    return sorted(found, key=lambda box: (box[1] // 12, box[0]))


def band(raw):
    """The buttons of a lesson's band; the console's tile lies below."""
    found = boxes(raw, lambda r, g, b: 24 <= r <= 58 and 52 <= g <= 92 and 92 <= b <= 132 and b - r > 42)
    return [box for box in found if box[1] < 0.6 * height]


def tiles(raw):
    return boxes(raw, lambda r, g, b: 12 <= r <= 50 and 34 <= g <= 72 and 62 <= b <= 102 and 30 < b - r < 72)


class Flystick:
    """At rest in the air before the wall of config/rigs/play.toml; sends sixty times a second where it points."""

    LEFT_M, LOWER_M, SIZE_M, WALL_M = -0.96, 0.7, (1.92, 1.08), -1.0
    PLACE_M = (0.25, 1.2, -0.2)

    def __init__(self, port):
        self.port, self.aim_m, self.pressed = port, (0.0, 0.9, self.WALL_M), 0
        threading.Thread(target=self.send, daemon=True).start()

    def send(self):
        out, frame = socket.socket(socket.AF_INET, socket.SOCK_DGRAM), 0
        while True:
            frame += 1
            away = [a - b for a, b in zip(self.PLACE_M, self.aim_m)]
            back = [part / math.hypot(*away) for part in away]
            right = [back[2] / math.hypot(back[2], back[0]), 0.0, -back[0] / math.hypot(back[2], back[0])]
            up = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2],
                  back[0] * right[1] - back[1] * right[0]]  # fmt: skip
            turn = " ".join(f"{part:.6f}" for part in (*right, *up, *back))
            place = " ".join(f"{1e3 * part:.3f}" for part in self.PLACE_M)
            words = f"fr {frame}\n6df2 1 1 [0 1.000 4 2][{place}][{turn}][{self.pressed} 0.00 0.00]\n"
            out.sendto(words.encode(), ("127.0.0.1", self.port))
            time.sleep(1 / 60)

    def point(self, x, y):
        left, top, wide, high = window()
        self.aim_m = (self.LEFT_M + (x - left) / wide * self.SIZE_M[0],
                      self.LOWER_M + (1.0 - (y - top) / high) * self.SIZE_M[1], self.WALL_M)  # fmt: skip


def window():
    wall = subprocess.run(["xdotool", "search", "--name", "Carom: screen"], capture_output=True, text=True).stdout.split()
    shell = subprocess.run(["xdotool", "getwindowgeometry", "--shell", wall[0]], capture_output=True, text=True).stdout
    at = dict(line.split("=") for line in shell.split())
    return tuple(int(at[name]) for name in ("X", "Y", "WIDTH", "HEIGHT"))


def click(box):
    x, y = (box[0] + box[2]) // 2, (box[1] + box[3]) // 2
    if not by_wand:
        return do("mousemove", x, y, "click", 1)
    stick.point(x, y)
    wait_frames(6)
    stick.pressed = 1
    time.sleep(0.1)
    stick.pressed = 0
    wait_frames(3)
    left, top, wide, high = window()
    stick.point(left + wide // 2, top + 2 * high // 3)  # where nothing that is pointed to takes another colour


def do(*what):
    subprocess.run(["xdotool", *map(str, what)], check=True)


def inputs(what):
    return [value for (value,) in query(f"SELECT value FROM input WHERE what = '{what}' ORDER BY rowid")]


def played(name):
    games = query("SELECT scenario FROM game ORDER BY first_frame DESC LIMIT 1")
    first = query("SELECT max(first_frame) FROM game")[0][0] if games else 0
    title = {"welcome": "Welcome", "show-me": "Show me: relativity", "comes-and-goes": "Slow when receding",
             "seen-at-once": "Seen at once"}[name]  # fmt: skip
    return bool(games) and title in games[0][0] and query(f"SELECT count(*) FROM frame WHERE number >= {first}")[0][0] > 2


def lesson(value):
    return lambda: inputs("lesson")[-1:] == [value]


def state(name):
    wait_frames(4)
    return screenshot(name)


def look(what, found, least):
    if len(found) < least:
        fail(f"{what}: {len(found)} buttons are seen, expected {least}: {found}")
    return found


rig = (config / "rigs/play.toml").read_text()
if by_wand:
    probe = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    probe.bind(("127.0.0.1", 0))
    stick = Flystick(probe.getsockname()[1])
    probe.close()
    rig += f"""
[hand]
tracker = "stick"
sensor = 100
[[tracker]]
name = "stick"
kind = "dtrack"
source = "udp://127.0.0.1:{stick.port}"
"""
(out / "room.toml").write_text(rig)
with open(out / "stderr", "w") as errors:
    session = subprocess.Popen(
        [carom, "cave", "--rig", out / "room.toml", "--console", "--silent", "--session", out / "visit.db"], stderr=errors)  # fmt: skip
wait("five frames", lambda: frames() > 4, 300.0)
raw = state("01-welcome")
click(look("welcome", tiles(raw), 3)[1])
wait("the first lesson", lambda: played("comes-and-goes"))
raw = state("02-asks")
answers = [box for box in look("question", band(raw), 5) if box[2] - box[0] > 0.3 * width]
click(answers[1])
wait("an answer", lesson("shows, answered 2"))
raw = state("03-shows")
click(look("shows", band(raw), 3)[1])
wait("the explanation", lesson("explains, answered 2"))
raw = state("04-explains")
click(look("tiles at the foot", tiles(raw), 3)[1])
wait("the second lesson", lambda: played("seen-at-once"))
raw = state("05-asks-again")
click(look("question", band(raw), 5)[-2])
wait("the question is skipped", lesson("shows, velocity 1"))
raw = state("06-velocities")
click(look("velocities", band(raw), 4)[-4])  # the one that is taken has another colour
wait("a velocity", lesson("shows, velocity 2"))
raw = state("07-with-velocity")
click(look("explanation", band(raw), 3)[-2])
wait("the explanation", lesson("explains, velocity 2"))
raw = state("08-explains-velocity")
click(look("leave", band(raw), 3)[-1])
wait("the welcome", lambda: played("welcome"))
raw = state("09-left")
click(look("tiles", tiles(raw), 3)[2])
wait("the show", lambda: played("show-me"))
raw = state("10-show-me")
click(look("tiles", tiles(raw), 3)[0])
wait("the game", lambda: played("welcome"))
raw = state("11-play")
if width <= 1366 and not by_wand:
    found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Carom: console"], capture_output=True)
    if found.stdout:
        fail("the console is in sight")
    left, top, wide, high = window()
    do("mousemove", left + wide - 60, top + high - 28, "click", 1)
    wait("the console", lambda: inputs("console")[-1:] == ["shown"])
    wait_frames(20)
    screenshot("12-console")
    do("key", "F10")
    wait("the game again", lambda: inputs("console")[-1:] == ["hidden"])
    state("13-console-hidden")
do("key", "Escape")
wait("the question whether to end", lambda: "Press Escape again" in (out / "stderr").read_text())
wait_frames(2)
screenshot("14-escape-asks")
for _ in range(20):  # each question stands for ten seconds, which are few frames here
    do("key", "Escape", "Escape")
    try:
        session.wait(timeout=30)
        break
    except subprocess.TimeoutExpired:
        pass
if session.poll() != 0:
    fail("the session did not end well")
print(f"{frames()} frames; {inputs('lesson')}")
