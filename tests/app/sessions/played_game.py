"""What played_game.sh says: plays with a mouse, then reads the session's journal."""

import math
import os
import pathlib
import re
import sqlite3
import subprocess
import sys
import time

carom, config, out, pictures = sys.argv[1], *(pathlib.Path(a) for a in sys.argv[2:5])
LIGHT_M_S, MASS_KG = 1.42, 0.2
PULL_FOR_MC_M = 0.15  # app/hand/cue.h: a pull so long is a momentum of m c
EYES_M = (0.0, 1.7, 0.0)  # in the room, standing still
ROOM_ON_BOARD_M = (0.0, -1.6, -0.75)  # of the room's floor origin; its forward is +y
SCREEN_M = {"left": -0.8, "right": 0.8, "lower": 0.9, "upper": 1.8, "z": -1.0}  # config/rigs/single-screen.toml
WINDOW_PX = {"x": 60, "y": 60, "width": 1280, "height": 720}
WHITE_M, RED_M = (-0.5, -0.3, 0.015), (0.1, 0.35, 0.015)  # config/scenarios/table.toml


def fail(what):
    print("FAILED:", what)
    print((out / "stderr").read_text())
    sys.exit(1)


def on_screen(place_m):
    """The pixel of the display behind which the eyes see a place of the board that rests."""
    room = (place_m[0] - ROOM_ON_BOARD_M[0], place_m[2] - ROOM_ON_BOARD_M[2], -(place_m[1] - ROOM_ON_BOARD_M[1]))
    share = (SCREEN_M["z"] - EYES_M[2]) / (room[2] - EYES_M[2])
    x = EYES_M[0] + share * (room[0] - EYES_M[0])
    y = EYES_M[1] + share * (room[1] - EYES_M[1])
    right = (x - SCREEN_M["left"]) / (SCREEN_M["right"] - SCREEN_M["left"])
    down = (SCREEN_M["upper"] - y) / (SCREEN_M["upper"] - SCREEN_M["lower"])
    return (
        round(WINDOW_PX["x"] + right * WINDOW_PX["width"]),
        round(WINDOW_PX["y"] + down * WINDOW_PX["height"]),
    )


def do(*what):
    # Not checked: a window that a key closes is gone before the key is let go.
    subprocess.run(["xdotool", *map(str, what)], stderr=subprocess.DEVNULL)


def press(key, window):
    search = ["xdotool", "search", "--name", window]
    for _ in range(600):
        found = subprocess.run(search, capture_output=True, text=True).stdout.split()
        if found:
            return do("key", "--window", found[0], key)
        time.sleep(0.1)
    fail(f"there is no window {window}")


def screenshot(name):
    grab = ["-f", "x11grab", "-video_size", "1400x840", "-i", os.environ["DISPLAY"], "-frames:v", "1"]
    subprocess.run(["ffmpeg", "-y", "-loglevel", "error", *grab, str(pictures / f"{name}.png")], check=True)


def query(sql):
    with sqlite3.connect(f"file:{out / 'game.db'}?mode=ro", uri=True) as db:
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
    """Until so many more frames were shown: what the mouse did before is then seen, however slow the display is."""
    shown = query("SELECT count(*) FROM frame")[0][0]
    wait_until(f"{count} more frames", lambda: query("SELECT count(*) FROM frame")[0][0] >= shown + count)


still = "".join(f"{i / 60:.6f},0,1.7,0,0,0,0,1\n" for i in range(60 * 600))
(out / "still.csv").write_text("time_s,x_m,y_m,z_m,qx,qy,qz,qw\n" + still)
rig = (config / "rigs/single-screen.toml").read_text()
rig = re.sub(r"(?m)^pixels = .*", "pixels = [640, 360]", rig)
rig = re.sub(r'(?m)^kind = "simulated"', 'kind = "recorded"\nsource = "still.csv"', rig)
(out / "room.toml").write_text(rig)

with open(out / "stderr", "w") as errors:
    session = subprocess.Popen(
        [carom, "cave", "--rig", out / "room.toml", "--scenario", "table", "--session", out / "game.db",
         "--view", "paths", "--view", "events"],
        stderr=errors,
    )  # fmt: skip
    wait_until("thirty frames", lambda: query("SELECT count(*) FROM frame")[0][0] > 30)

    # At nothing first: the wall of the hall.
    do("mousemove", WINDOW_PX["x"] + 640, WINDOW_PX["y"] + 40)
    do("mousedown", 1)
    wait_until("a refusal", lambda: query("SELECT value FROM input WHERE what = 'notice'"))
    do("mouseup", 1)

    aim = on_screen(WHITE_M)
    do("mousemove", *aim)
    wait_for_frames(5)
    screenshot("1-aimed")

    # From where that ray meets the cloth, back by 0.3 m, away from the red puck.
    eyes_m = (ROOM_ON_BOARD_M[0], ROOM_ON_BOARD_M[1], ROOM_ON_BOARD_M[2] + EYES_M[1])
    beyond = eyes_m[2] / (eyes_m[2] - WHITE_M[2])
    cloth_m = [eyes_m[i] + beyond * (WHITE_M[i] - eyes_m[i]) for i in range(2)]
    way = math.atan2(RED_M[1] - WHITE_M[1], RED_M[0] - WHITE_M[0])
    pull_m = 0.3
    do("mousedown", 1)
    wait_for_frames(5)  # so that it is pressed here
    for part in range(1, 11):
        back = pull_m * part / 10
        do("mousemove", *on_screen((cloth_m[0] - back * math.cos(way), cloth_m[1] - back * math.sin(way), 0.0)))
        time.sleep(0.05)
    wait_for_frames(5)
    screenshot("2-drawn-back")
    do("mouseup", 1)
    wait_until("the stroke", lambda: query("SELECT puck FROM stroke"))
    time.sleep(0.6)
    screenshot("3-on-its-way")
    wait_until("a collision", lambda: query("SELECT * FROM event WHERE kind = 'puck-puck'"))
    time.sleep(2.0)
    screenshot("4-collided")
    press("Escape", "Carom: screen")  # which asks
    press("Escape", "Carom: screen")
    if session.wait(timeout=240) != 0:
        fail("the session did not end well")

(struck, px, py), *others = query("SELECT puck, p_x_kg_m_s, p_y_kg_m_s FROM stroke")
if others or struck not in ("white", 0):
    fail(f"the strokes are {query('SELECT * FROM stroke')}, expected one, of white")
wanted = MASS_KG * LIGHT_M_S * pull_m / PULL_FOR_MC_M
# A pixel of the display is some 3 mm of the cloth there.
if abs(math.hypot(px, py) - wanted) > 0.05 * wanted:
    fail(f"the stroke is of {math.hypot(px, py)} kg m/s, expected {wanted}")
if abs(math.atan2(py, px) - way) > math.radians(2):
    fail(f"the stroke goes {math.degrees(math.atan2(py, px))} degrees from +x, expected {math.degrees(way)}")
pucks = query("SELECT pucks FROM event WHERE kind = 'puck-puck' ORDER BY number LIMIT 1")[0][0]
if sorted(pucks.split(", ")) != ["red", "white"]:
    fail(f"{pucks} collided first, expected white and red")

with open(out / "stderr", "w") as errors:
    session = subprocess.Popen(
        [carom, "replay", out / "game.db", "--walk", "--from", "0", "1.6", "-0.75", "--facing", "-90"], stderr=errors
    )
    time.sleep(6.0)
    screenshot("5-from-the-other-side")
    for key, what in (("space", "playback: paused"), ("Left", "playback: from"), ("space", "playback: goes on")):
        press(key, "Carom: screen")
        wait_until(what, lambda: what in (out / "stderr").read_text())
        time.sleep(0.5)
    screenshot("6-gone-back")
    press("Escape", "Carom: screen")  # which asks
    press("Escape", "Carom: screen")
    if session.wait(timeout=240) != 0:
        fail("the replay did not end well")
print(f"white was shot with {math.hypot(px, py):.3f} kg m/s, {wanted:.3f} meant, and met red")
