"""What wand_of_two.sh says: two VRPN servers, a session, and what its journal and its standard error hold."""

import math
import pathlib
import re
import sqlite3
import struct
import subprocess
import sys
import time

from vrpn_server import Server

carom, config, out = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])

wand, box = Server("Wand"), Server("Button0")
PUCK_M = (0.0, 0.765, -1.6)  # of the room, with the observer below
HAND_M = (0.3, 1.25, -0.3)
away = [puck - hand for puck, hand in zip(PUCK_M, HAND_M)]
WAY = [part / math.hypot(*away) for part in away]
# The turn that takes (0, 0, -1) to WAY: axis × sine of half the angle, cosine of half the angle.
turn = [-WAY[1] * -1.0, WAY[0] * -1.0, 0.0, 1.0 - WAY[2]]
TURN = [part / math.hypot(*turn) for part in turn]


def point(back_m=0.0, at_s=None):
    place = [hand - back_m * way for hand, way in zip(HAND_M, WAY)]
    wand.send(0, struct.pack(">ii7d", 0, 0, *place, *TURN), time.time() if at_s is None else at_s)


def hold(seconds, back_m=lambda share: 0.0, at_s=None):
    begin = time.monotonic()
    while (share := (time.monotonic() - begin) / seconds) < 1.0:
        point(back_m(share), at_s)
        time.sleep(1.0 / 120.0)


def hold_for_rows(table, count, back_m=0.0):
    """Holds still until the journal has so many more rows: what was done before is then seen, on a busy machine, too."""

    def rows():
        try:
            with sqlite3.connect(f"file:{out / 'shot.db'}?mode=ro", uri=True) as reader:
                return reader.execute(f"SELECT count(*) FROM {table}").fetchone()[0]
        except sqlite3.OperationalError:  # not there yet, or busy
            return 0

    before, deadline = rows(), time.monotonic() + 120.0
    while rows() < before + count and time.monotonic() < deadline:
        hold(0.1, lambda share: back_m)


def press(down):
    box.send(1, struct.pack(">ii", 0, down), time.time())


(out / "game.toml").write_text("""light_speed_m_s = 1.42
[observer]
position_m = [0.0, -1.6, -0.75]
facing_deg = 90.0
[[puck]]
name = "white"
radius_m = 0.05
height_m = 0.03
mass_kg = 0.2
position_m = [0.0, 0.0]
beta = [0.0, 0.0]
""")


def session(name, head, hand, body):
    """Runs a session while `body` acts; returns its journal and what it said."""
    rig = (config / "rigs/play.toml").read_text()
    rig = re.sub(r"(?m)^pixels = .*", "pixels = [64, 36]", rig)
    rig = re.sub(r'(?m)^kind = "simulated"\nperson = .*', head, rig)
    (out / f"{name}.toml").write_text(rig + hand)
    database = out / f"{name}.db"
    with open(out / f"{name}.said", "w") as errors:
        running = subprocess.Popen(
            [carom, "cave", "--rig", out / f"{name}.toml", "--scenario", out / "game.toml", "--session", database,
             "--no-window", "--silent"], stderr=errors)  # fmt: skip
    try:
        body(running, lambda: (out / f"{name}.said").read_text())
    finally:
        running.terminate()
        try:
            running.wait(120)
        except subprocess.TimeoutExpired:
            running.kill()
    return sqlite3.connect(database), (out / f"{name}.said").read_text()


def trackers(wand_source, box_source):
    return f"""
[hand]
tracker = "wand"
sensor = 0
buttons = "box"
[[tracker]]
name = "wand"
kind = "vrpn"
source = "{wand_source}@tcp://127.0.0.1:{wand.port}"
[[tracker]]
name = "box"
kind = "vrpn"
source = "{box_source}@tcp://127.0.0.1:{box.port}"
"""


failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)


def shoot(running, _):
    deadline = time.monotonic() + 120.0
    while not (wand.clients and box.clients) and running.poll() is None and time.monotonic() < deadline:
        time.sleep(0.1)
    hold_for_rows("frame", 30)
    press(True)
    hold_for_rows("frame", 30)
    hold(1.0, lambda share: 0.1 * share)
    hold_for_rows("frame", 30, 0.1)
    press(False)
    hold_for_rows("stroke", 1, 0.1)


journal, said = session("shot", 'kind = "simulated"\nperson = "still"', trackers("Wand", "Button0"), shoot)
strokes = journal.execute("SELECT count(*) FROM stroke").fetchone()[0]
expect(strokes == 1, f"{strokes} strokes are in the journal, one was played: {said}")
expect("Tracker" not in said, f"something is said of trackers that are well: {said}")

wand, box = Server("Wand"), Server("Button0")
LINES = [
    f"Tracker you: the server at 127.0.0.1:{wand.port} has no 'Nobody', it has: Wand; it is waited for",
    f"Tracker box: the server at 127.0.0.1:{box.port} has no 'Nobody', it has: Button0; it is waited for",
    "Tracker wand: its messages carry the same time again and again; each is taken to be of the moment when it came",
]


def wait(running, told):
    deadline = time.monotonic() + 120.0
    while not all(line in told() for line in LINES) and running.poll() is None and time.monotonic() < deadline:
        hold(0.5, lambda share: 0.1 * share, at_s=0.0)


head = f'kind = "vrpn"\nsource = "Nobody@tcp://127.0.0.1:{wand.port}"'
_, said = session("names", head, trackers("Wand", "Nobody"), wait)
for line in LINES:
    expect(re.search(rf"(?m)^{re.escape(line)}$", said), f"this is not said: {line}\nbut this: {said}")

for failure in failures:
    print("FAILED:", failure)
sys.exit(1 if failures else 0)
