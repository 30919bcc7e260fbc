"""What spacetime_hands.sh says: a wand on a VRPN server, then a mouse, closing their loops by the session's journal."""

import filecmp
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
LIGHT_M_S = 0.3  # slow, so that beads sink slowly
SCALE = 0.25
FOOT_M = (0.45, 0.0, -1.2)  # in the room: x right, y up, z back
LAMP_M, LAMP_S = (0.0, 0.2), 0.0  # on the board
TURN_M = 0.30  # app/play/sculpture_hands.h: a pull aside that turns by a radian
RING_M = 1.6 * SCALE  # engine/sculpture/sculpture_place.h
HAND_M = (0.2, 1.3, 0.0)

(out / "game.toml").write_text(f"""light_speed_m_s = {LIGHT_M_S}
[observer]
position_m = [0.0, -1.6, -0.75]
facing_deg = 90.0
[spacetime]
place = {list(FOOT_M)}
scale = {SCALE}
[board]
length_m = 2.84
width_m = 1.42
[[flash]]
name = "lamp"
at_s = {LAMP_S}
r_m = [{LAMP_M[0]}, {LAMP_M[1]}, 0.03]
[[puck]]
name = "white"
radius_m = 0.05
height_m = 0.03
mass_kg = 0.2
position_m = [0.6, 0.0]
beta = [0.0, 0.0]
""")


def fail(words):
    print("FAILED:", words)
    sys.exit(1)


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def unit(way):
    return [part / math.hypot(*way) for part in way]


class Session:
    """A session that runs, and the newest frame of its journal."""

    def __init__(self, name, rig, *options):
        self.name, self.database = name, out / f"{name}.db"
        (out / f"{name}.toml").write_text(rig)
        self.said = open(out / f"{name}.said", "w")
        self.running = subprocess.Popen(
            [carom, "cave", "--rig", out / f"{name}.toml", "--scenario", out / "game.toml", "--session", self.database,
             "--view", "spacetime", "--silent", "--capture", out / f"{name}-live", *options],
            stderr=self.said)  # fmt: skip

    def newest(self):
        """The newest frame's columns, and the board time of its eyes."""
        try:
            with sqlite3.connect(f"file:{self.database}?mode=ro", uri=True) as reader:
                reader.row_factory = sqlite3.Row
                frame = reader.execute("SELECT * FROM frame ORDER BY number DESC LIMIT 1").fetchone()
                if frame is None:
                    return None
                seen = reader.execute("SELECT t_s FROM viewer WHERE frame = ?", (frame["number"],)).fetchone()
                return dict(frame) | {"t_s": seen["t_s"]}
        except sqlite3.OperationalError:  # not there yet, or busy
            return None

    def await_frame(self, what, holds, act=lambda: time.sleep(0.1), seconds=120.0):
        """Acts until the newest frame is so; returns it."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            frame = self.newest()
            if frame and holds(frame):
                return frame
            if self.running.poll() is not None:
                fail(f"{self.name}: the session has ended before {what}: " + (out / f"{self.name}.said").read_text())
            act()
        if seconds > 60.0:
            fail(f"{self.name}: {what}: not so in {seconds:.0f} s: {self.newest()}")
        return None

    def end(self):
        self.running.terminate()
        if self.running.wait(120):
            fail(f"{self.name}: the session did not end well: " + (out / f"{self.name}.said").read_text())

    def replay(self):
        again = out / f"{self.name}-again"
        replay = subprocess.run([carom, "replay", self.database, "--capture", again, "--no-window"],
                                capture_output=True, text=True)  # fmt: skip
        if replay.returncode:
            fail(f"{self.name}: it cannot be replayed: {replay.stderr}")
        pictures = sorted((out / f"{self.name}-live").glob("*.png"))
        for picture in pictures:
            if not filecmp.cmp(picture, again / picture.name, shallow=False):
                fail(f"{self.name}: {picture.name} is another picture in the replay")
        if len(pictures) < 20:
            fail(f"{self.name}: only {len(pictures)} pictures")
        return len(pictures)


def heading(frame):
    """The sculpture's turn about the room's y: its foot is turned by −90° about x and by this."""
    w, x, y, z = (frame[f"spacetime_q{part}"] for part in "wxyz")
    # Where its x axis points.
    along = (1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y))
    return math.atan2(-along[2], along[0])


def model(frame, x_m, y_m, z_m):
    """A place of the model in the room, while it is turned by heading()."""
    a = heading(frame)
    return (FOOT_M[0] + SCALE * (x_m * math.cos(a) - y_m * math.sin(a)), FOOT_M[1] + SCALE * z_m,
            FOOT_M[2] - SCALE * (x_m * math.sin(a) + y_m * math.cos(a)))  # fmt: skip


def lamp(frame, later_s):
    height_m = LIGHT_M_S * (frame["spacetime_past_s"] + LAMP_S - frame["t_s"] - later_s)
    return model(frame, *LAMP_M, height_m)


def play(session, take, drag):
    """`take(place, pressed)` points at a place; `drag(place, way)` presses there, pulls by so much, and lets go."""

    def aim():
        frame = session.newest()
        if frame:
            take(model(frame, 0, 0, 3), False)

    session.await_frame("it begins", lambda frame: frame["t_s"] > 1.0, aim)
    picked = None
    for attempt in range(60):  # where the bead is when the press arrives is guessed
        frame = session.newest()
        place = lamp(frame, 0.25 * (attempt % 8))
        take(place, False)
        take(place, True)
        picked = session.await_frame("a bead is picked", lambda now: now["spacetime_picked"] > 0,
                                     lambda: take(place, True), seconds=1.0)  # fmt: skip
        take(place, False)
        if picked:
            break
    if not picked:
        fail(f"{session.name}: no bead was picked: {session.newest()}")
    free = session.await_frame("the bead is let go", lambda now: now["spacetime_held"] == 0)
    before = heading(free)
    drag(model(free, 0.0, 0.0, 0.72 * LIGHT_M_S * free["spacetime_past_s"]), (0.15, 0.0, 0.0))
    turned = session.await_frame(
        "it is turned", lambda now: abs(heading(now) - before) > 0.1 and not now["spacetime_held"]
    )
    # Its far side, which the wall shows for wands below the eyes.
    ring = (FOOT_M[0], FOOT_M[1] + SCALE * LIGHT_M_S * turned["spacetime_past_s"], FOOT_M[2] - RING_M)
    drag(ring, (0.15, 0.0, 0.0))

    def speed(frame):
        return math.hypot(frame["spacetime_beta_x"], frame["spacetime_beta_y"])

    boosted = session.await_frame("it is boosted", lambda now: speed(now) > 0.1 and not now["spacetime_held"])
    beta = speed(boosted)
    with sqlite3.connect(session.database) as reader:
        if strokes := reader.execute("SELECT count(*) FROM stroke").fetchone()[0]:
            fail(f"{session.name}: {strokes} strokes, the hand was the sculpture's")
    session.end()
    angle = heading(turned) - before
    print(f"{session.name}: picked event {picked['spacetime_picked'] - 1}, turned by {angle:.2f} rad, "
          f"boosted to {beta:.2f} c; {session.replay()} pictures, the same again")  # fmt: skip
    return angle, beta


play_rig = re.sub(r"(?m)^pixels = .*", "pixels = [160, 90]", (config / "rigs/play.toml").read_text())

# A wand, which moves without turning while it pulls.
wand, box = Server("Wand"), Server("Button0")
pressed = False


def send(place, way):
    turn = unit([-way[1] * -1.0, way[0] * -1.0, 0.0, 1.0 - way[2]])  # takes (0, 0, -1) to `way`
    wand.send(0, struct.pack(">ii7d", 0, 0, *place, *turn), time.time())


def press(down):
    global pressed
    if down != pressed:
        box.send(1, struct.pack(">ii", 0, down), time.time())
        pressed = down


def point(place, down, seconds=0.25):
    until = time.monotonic() + seconds
    way = unit(minus(place, HAND_M))
    settled = time.monotonic() + 0.5 * seconds
    while time.monotonic() < until:
        send(HAND_M, way)
        if time.monotonic() > settled:
            press(down)
        time.sleep(1.0 / 120.0)


def pull(place, by):
    point(place, False, 0.5)
    point(place, True, 1.0)
    way = unit(minus(place, HAND_M))
    begin = time.monotonic()
    while (share := min(1.0, (time.monotonic() - begin) / 1.0)) < 1.0 or time.monotonic() < begin + 3.0:
        send([hand + share * part for hand, part in zip(HAND_M, by)], way)
        time.sleep(1.0 / 120.0)
    press(False)
    for _ in range(60):
        send([hand + part for hand, part in zip(HAND_M, by)], way)
        time.sleep(1.0 / 120.0)


session = Session("wand", play_rig + f"""
[hand]
tracker = "wand"
sensor = 0
buttons = "box"
[[tracker]]
name = "wand"
kind = "vrpn"
source = "Wand@tcp://127.0.0.1:{wand.port}"
[[tracker]]
name = "box"
kind = "vrpn"
source = "Button0@tcp://127.0.0.1:{box.port}"
""", "--no-window")  # fmt: skip
angle, beta = play(session, point, pull)
# The pull's part at a right angle to the level part of the way turns it, and rapidity is pull over 0.35 m.
if not 0.3 < abs(angle) < 0.15 / TURN_M + 0.01:
    fail(f"the wand turned it by {angle} rad, expected up to {0.15 / TURN_M}")
if abs(beta - math.tanh(0.15 / 0.35)) > 0.02:
    fail(f"the wand boosted it to {beta} c, expected {math.tanh(0.15 / 0.35)}")


# A mouse: its wand stands below the eyes and points through the place of the window where it is.
def window():
    def ask(*what):
        return subprocess.run(["xdotool", *what], capture_output=True, text=True).stdout.split()

    found = ask("search", "--name", "Carom: screen")[0]
    told = ask("getwindowgeometry", "--shell", found)
    return found, {key: int(value) for key, value in (line.split("=") for line in told)}


def do(*what):
    subprocess.run(["xdotool", *map(str, what)], check=True)


def pixel(place):
    """The pixel of the display where the line from the wand to a place of the room meets the wall."""
    frame = mouse.newest()
    at = [frame[f"cue_from_{part}_m"] for part in "xyz"]
    if not any(at):
        at = (0.0, 1.7, 0.0)
    share = (-1.0 - at[2]) / (place[2] - at[2])
    x, y = (at[i] + share * (place[i] - at[i]) for i in (0, 1))
    across, down = (x + 0.96) / 1.92, (1.78 - y) / 1.08  # of the wall (config/rigs/play.toml)
    return round(shape["X"] + across * shape["WIDTH"]), round(shape["Y"] + down * shape["HEIGHT"])


def click(place, down):
    do("mousemove", *pixel(place))
    time.sleep(0.3)
    do("mousedown" if down else "mouseup", 1)


def draw(place, by):
    click(place, False)
    time.sleep(0.5)
    click(place, True)
    time.sleep(0.5)
    for step in range(1, 11):
        do("mousemove", *pixel([part + 0.1 * step * pulled for part, pulled in zip(place, by)]))
        time.sleep(0.1)
    time.sleep(1.0)
    do("mouseup", 1)


mouse = Session("mouse", play_rig, "--by-mouse")
mouse.await_frame("the window is there", lambda frame: frame["number"] > 5)
name, shape = window()
do("windowfocus", name)
play(mouse, click, draw)
