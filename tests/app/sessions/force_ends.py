"""What force_ends.sh says: a VRPN server of its own, whose arm draws a cue back until the session is asked to end, by an exception,
and by the loss of a node."""

import os
import pathlib
import re
import signal
import socket
import sqlite3
import struct
import subprocess
import sys
import threading
import time

carom, config, out = sys.argv[1], *(pathlib.Path(a) for a in sys.argv[2:4])
# The hand's ray meets the white puck of config/scenarios/table.toml, in the room of config/rigs/single-screen.toml.
WHITE_M, HAND_M, PULL_M = (-0.5, 0.765, -1.3), (-0.3, 1.1, -0.5), 0.16
SENDER, POSE, BUTTON = 1, 1, 2
FIELD_BYTES, FORCE_AT = 24 + 64, 24 + 12


def fail(what):
    print("FAILED:", what)
    print((out / "stderr").read_text())
    sys.exit(1)


def record(sender, kind, payload):
    now = time.time()
    head = struct.pack(">IIIiiI", 24 + len(payload), int(now), int(now % 1 * 1e6), sender, kind, 0)
    return head + payload + bytes(-len(payload) % 8)


def named(number, what, text):
    return record(number, what, struct.pack(">I", len(text) + 1) + text.encode() + b"\0")


def turn_to(way):
    """The quaternion that turns -z to a way."""
    length = sum(v * v for v in way) ** 0.5
    x, y, z = (v / length for v in way)
    q = [y, -x, 0.0, 1.0 - z]  # (0, 0, -1) x way, and 1 + (0, 0, -1) . way
    size = sum(v * v for v in q) ** 0.5
    return [v / size for v in q]


class Arm:
    """A server with one arm, and what its client pushes it with."""

    def __init__(self):
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.place, self.pressed, self.forces, self.ends = list(HAND_M), False, [], False
        way = [t - h for t, h in zip(WHITE_M, HAND_M)]
        self.way = [v / sum(w * w for w in way) ** 0.5 for v in way]
        threading.Thread(target=self.accept, daemon=True).start()

    def accept(self):
        while True:
            client, _ = self.listener.accept()
            threading.Thread(target=self.serve, args=(client,), daemon=True).start()

    def serve(self, client):
        client.settimeout(0.004)
        client.sendall(b"vrpn: ver. 07.35  0".ljust(24, b"\0"))
        types = ["vrpn_Tracker Velocity", "vrpn_Tracker Pos_Quat", "vrpn_Button Change", "vrpn_Button States",
                 "vrpn_Analog Channel", "vrpn_Base ping_message", "vrpn_Base pong_message"]
        client.sendall(named(0, -1, "VRPN Control") + named(1, -1, "Arm"))
        client.sendall(b"".join(named(i, -2, name) for i, name in enumerate(types)))
        held, greeted, was = b"", False, None
        try:
            while True:
                try:
                    more = client.recv(65536)
                    if not more:
                        break
                    held += more
                except socket.timeout:
                    pass
                if not greeted and len(held) >= 24:
                    held, greeted = held[24:], True
                while greeted and len(held) >= 24:
                    length = struct.unpack(">I", held[:4])[0]
                    whole = (length + 7) // 8 * 8
                    if len(held) < whole:
                        break
                    if length == FIELD_BYTES:
                        force = struct.unpack(">3f", held[FORCE_AT:FORCE_AT + 12])
                        self.forces.append((time.monotonic(), sum(f * f for f in force) ** 0.5))
                    held = held[whole:]
                if self.pressed is not was:
                    client.sendall(record(SENDER, BUTTON, struct.pack(">ii", 0, int(self.pressed))))
                    was = self.pressed
                numbers = [*self.place, *turn_to(self.way)]
                client.sendall(record(SENDER, POSE, struct.pack(">ii", 0, 0) + struct.pack(">7d", *numbers)))
        except OSError:
            pass
        self.ends = time.monotonic()

    def draw(self, way_m):
        self.place = [h - way_m * v for h, v in zip(HAND_M, self.way)]

    def force_n(self):
        return self.forces[-1][1] if self.forces else 0.0


arm = Arm()
rig = (config / "rigs/single-screen.toml").read_text()
rig = re.sub(r"(?m)^pixels = .*", "pixels = [320, 180]", rig)
rig += f'\n[hand.force]\nkind = "vrpn"\nsource = "Arm@tcp://127.0.0.1:{arm.port}"\nforce_max_n = 9.0\n'
(out / "room.toml").write_text(rig)
(out / "two-nodes.toml").write_text(rig + f"""
[[wall]]
name = "second"
node = 1
pixels = [32, 18]
{"".join(re.findall(r"(?m)^(?:lower|upper)_.*$" + chr(10), rig))}window = {{ position = [400, 0], size = [32, 18] }}
""")


def wait_until(what, holds, session, seconds=120.0):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if holds():
            return
        if session.poll() is not None:
            fail(f"the program ended before {what}")
        time.sleep(0.01)
    fail(f"not seen in time: {what}; the last force is {arm.force_n()} N")


def draws():
    """Presses, draws back and, if nothing is felt, lets go to try again: a late frame makes the force fall."""
    step = int(time.monotonic() * 50) % 200
    arm.pressed = step > 10
    arm.draw(PULL_M * min(max(step - 30, 0) / 60.0, 1.0))
    return arm.force_n() > 0.5


# On a busy machine the watch over a silent game may come first.
REASONS = "the session ended|the game said nothing for 100 ms|no pose for 20 ms|no tick for 20 ms|the loop is too slow"


def ends_without_force(how, command, file, end):
    """Plays until the arm is pushed, ends the session by `end`, and looks at what the arm, log and file are told."""
    arm.forces.clear()
    with open(out / "stderr", "w") as errors:
        session = subprocess.Popen([*command, "--scenario", "table", "--session", file, "--silent"], stderr=errors)
        wait_until("the arm", lambda: "is there" in (out / "stderr").read_text(), session)
        time.sleep(1.0)
        wait_until("a force", draws, session)
        asked = end(session)
        session.wait(timeout=240)
    since = time.monotonic()  # a busy computer reads late what the arm was told
    while arm.force_n() != 0.0 and time.monotonic() < since + 5.0:
        time.sleep(0.01)
    zeroed, last_n = arm.forces[-1]
    if last_n != 0.0:
        fail(f"{how}: the last thing that the arm is told is {last_n} N")
    pushed = [at for at, force in arm.forces if force > 0.0]
    print(f"{how}: 0 N {1e3 * (zeroed - asked):.0f} ms later, {1e3 * (zeroed - pushed[-1]):.0f} ms after the last push")
    if not re.search(f"no force, for ({REASONS})", (out / "stderr").read_text()):
        fail(f"{how}: the log does not say why the force fell")
    with sqlite3.connect(f"file:{file}?mode=ro", uri=True) as db:
        off = db.execute("SELECT value FROM input WHERE what = 'force off' ORDER BY rowid DESC LIMIT 1").fetchall()
    if not off or not re.search(REASONS, off[0][0]):
        fail(f"{how}: the session file says of the end: {off}")
    return session.returncode


def by_signal(session):
    second = subprocess.run([carom, "doctor", out / "room.toml"], capture_output=True, text=True)
    if "is the force device of another session" not in second.stdout + second.stderr:
        fail("a second session is not told of the first: " + second.stdout + second.stderr)
    wait_until("a force again", draws, session)
    session.terminate()
    return time.monotonic()


def by_exception(session):
    (out / "throw").touch()
    return time.monotonic()


def by_lost_node(session):
    nodes = subprocess.run(["pgrep", "-P", str(session.pid)], capture_output=True, text=True).stdout.split()
    if len(nodes) != 2:
        fail(f"expected two nodes, found {nodes}")
    os.kill(max(map(int, nodes)), signal.SIGKILL)
    return time.monotonic()


if ends_without_force("by SIGTERM", [carom, "cave", "--rig", out / "room.toml"], out / "game.db", by_signal) != 0:
    fail("the session did not end well")
planted = ["env", f"LD_PRELOAD={os.environ['CAROM_PLANTED_EXCEPTION']}", f"CAROM_PLANTED_AT={out / 'throw'}"]
if ends_without_force("by an exception", [*planted, carom, "cave", "--rig", out / "room.toml"], out / "thrown.db", by_exception) != 1:
    fail("an exception is no error of the session")
if "error: a planted exception" not in (out / "stderr").read_text():
    fail("it is not said that something was thrown")
mpirun = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2"]
ends_without_force("by a lost node", [*mpirun, carom, "cave", "--rig", out / "two-nodes.toml"], out / "nodes.db", by_lost_node)
if "error: node 1" not in (out / "stderr").read_text():
    fail("it is not said that a node is lost")
listed = subprocess.run([carom, "track", "--list", "--rig", out / "room.toml"], capture_output=True, text=True)
if f"Arm@tcp://127.0.0.1:{arm.port} at most 9 N, 600 N/m, 200 Hz; it is there and sends its place" not in listed.stdout:
    fail("track --list does not name the arm: " + listed.stdout + listed.stderr)
print(listed.stdout.strip().splitlines()[-1])
