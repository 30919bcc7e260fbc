"""What force_session.sh says: plays with a mouse and a simulated force device, then reads the session's journal."""

import math
import os
import pathlib
import re
import sqlite3
import subprocess
import sys
import time

carom, config, out, pictures = sys.argv[1], *(pathlib.Path(a) for a in sys.argv[2:5])
REST_J, D0_M, HAND_N_M = 0.2 * 1.42**2, 0.08, 250.0
EYES_M, ROOM_ON_BOARD_M = (0.0, 1.7, 0.0), (0.0, -1.6, -0.75)
SCREEN_M = {"left": -0.8, "right": 0.8, "lower": 0.9, "upper": 1.8, "z": -1.0}  # config/rigs/single-screen.toml
WINDOW_PX = {"x": 60, "y": 60, "width": 1280, "height": 720}
WHITE_M = (-0.5, -0.3, 0.015)  # config/scenarios/table.toml
PULL_M = 0.16


def fail(what):
    print("FAILED:", what)
    print((out / "stderr").read_text())
    sys.exit(1)


def on_screen(place_m):
    """The pixel of the display behind which the eyes see a place of the board that rests."""
    room = (place_m[0] - ROOM_ON_BOARD_M[0], place_m[2] - ROOM_ON_BOARD_M[2], -(place_m[1] - ROOM_ON_BOARD_M[1]))
    share = (SCREEN_M["z"] - EYES_M[2]) / (room[2] - EYES_M[2])
    right = (EYES_M[0] + share * (room[0] - EYES_M[0]) - SCREEN_M["left"]) / (SCREEN_M["right"] - SCREEN_M["left"])
    down = (SCREEN_M["upper"] - EYES_M[1] - share * (room[1] - EYES_M[1])) / (SCREEN_M["upper"] - SCREEN_M["lower"])
    return round(WINDOW_PX["x"] + right * WINDOW_PX["width"]), round(WINDOW_PX["y"] + down * WINDOW_PX["height"])


def do(*what):
    subprocess.run(["xdotool", *map(str, what)], stderr=subprocess.DEVNULL)


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
    shown = query("SELECT count(*) FROM frame")[0][0]
    wait_until(f"{count} more frames", lambda: query("SELECT count(*) FROM frame")[0][0] >= shown + count)


def screenshot(name):
    grab = ["-f", "x11grab", "-video_size", "1400x840", "-i", os.environ["DISPLAY"], "-frames:v", "1"]
    subprocess.run(["ffmpeg", "-y", "-loglevel", "error", *grab, str(pictures / f"{name}.png")], check=True)


still = "".join(f"{i / 60:.6f},0,1.7,0,0,0,0,1\n" for i in range(60 * 600))
(out / "still.csv").write_text("time_s,x_m,y_m,z_m,qx,qy,qz,qw\n" + still)
rig = (config / "rigs/single-screen.toml").read_text()
rig = re.sub(r"(?m)^pixels = .*", "pixels = [640, 360]", rig)
rig = re.sub(r'(?m)^kind = "simulated"', 'kind = "recorded"\nsource = "still.csv"', rig)
rig += '\n[hand.force]\nkind = "simulated"\nstiffness_max_n_m = 900.0\n'
(out / "room.toml").write_text(rig)

with open(out / "stderr", "w") as errors:
    session = subprocess.Popen(
        [carom, "cave", "--rig", out / "room.toml", "--scenario", "table", "--session", out / "game.db", "--silent",
         "--capture", out / "live"],
        stderr=errors,
    )  # fmt: skip
    wait_until("thirty frames", lambda: query("SELECT count(*) FROM frame")[0][0] > 30)
    do("mousemove", *on_screen(WHITE_M))
    wait_for_frames(5)
    eyes_m = (ROOM_ON_BOARD_M[0], ROOM_ON_BOARD_M[1], ROOM_ON_BOARD_M[2] + EYES_M[1])
    beyond = eyes_m[2] / (eyes_m[2] - WHITE_M[2])
    cloth_m = [eyes_m[i] + beyond * (WHITE_M[i] - eyes_m[i]) for i in range(2)]
    do("mousedown", 1)
    wait_for_frames(5)
    for part in range(1, 11):
        do("mousemove", *on_screen((cloth_m[0] - PULL_M * part / 10, cloth_m[1], 0.0)))
        time.sleep(0.05)
    wait_until("a quiet hand", lambda: query("SELECT count(*) FROM frame WHERE cue_pulling")[0][0] > 60)
    screenshot("1-force")
    do("mouseup", 1)
    wait_until("a blow", lambda: query("SELECT value FROM input WHERE what = 'force pulse'"))
    session.terminate()
    if session.wait(timeout=240) != 0:
        fail("the session did not end well")

(px, py) = query("SELECT p_x_kg_m_s, p_y_kg_m_s FROM stroke")[0]
u = math.hypot(px, py) / (0.2 * 1.42)
draw_m = D0_M * math.asinh(u)
if not 0.08 < draw_m < PULL_M:
    fail(f"the stroke is that of a draw of {draw_m} m, expected less than the hand's {PULL_M} m")
(scale, fx, fy, fz) = query(
    "SELECT scale, force_n_x, force_n_y, force_n_z FROM force JOIN frame ON frame.number = force.frame "
    "WHERE cue_pulling ORDER BY frame DESC LIMIT 1"
)[0]
force_n, wanted_n = math.hypot(fx, fy, fz), scale * REST_J / D0_M * u
if abs(force_n - wanted_n) > 0.05:
    fail(f"the force is {force_n} N, expected {wanted_n} N by the stroke's u = {u}")
if abs(force_n - HAND_N_M * (PULL_M - draw_m)) > 0.5:
    fail(f"the force is {force_n} N, and the hand lacks {PULL_M - draw_m} m")
whats = [row[0] for row in query("SELECT what FROM input")]
for what in ("force stiffness", "force draw", "force pulse"):
    if what not in whats:
        fail(f"the session file has no '{what}', it has {sorted(set(whats))}")
if whats.count("force stiffness") != 1:
    fail("the lowered stiffness is not said once")
places = query("SELECT count(*) FROM force")[0][0]
frames = query("SELECT count(*) FROM frame")[0][0]
if places < 0.9 * frames:
    fail(f"{places} of {frames} frames have a place of the device")
print(f"drawn by {draw_m:.3f} m, {force_n:.2f} N, s = {scale:.3f}; {places} places in {frames} frames")

again = subprocess.run(
    [carom, "replay", out / "game.db", "--capture", out / "again", "--no-window"], capture_output=True, text=True
)
if again.returncode != 0:
    fail("the session cannot be replayed: " + again.stderr)
same = 0
for picture in sorted((out / "live").glob("*.png")):
    if picture.read_bytes() != (out / "again" / picture.name).read_bytes():
        fail(f"{picture.name} is another picture in the replay")
    same += 1
if same < 30:
    fail(f"only {same} pictures")
if "force" in again.stderr:
    fail("the replay speaks of a force device")
print(f"{same} pictures, the same again")
