"""What calibrate_live.sh says: a person with a Flystick, simulated in answer to what the program asks for."""

import math
import os
import pathlib
import pty
import random
import re
import select
import signal
import socket
import subprocess
import sys
import termios
import threading
import time

carom, out = sys.argv[1], pathlib.Path(sys.argv[2])
random.seed(5)
failures = []


def check(holds, what):
    if not holds:
        failures.append(what)
        print("FAILED:", what)


with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
    probe.bind(("127.0.0.1", 0))
    port = probe.getsockname()[1]

# The tracker's z is up, its x the room's right; its origin is here in the room.
ORIGIN = (0.25, 1.9, -0.35)
CORNERS = {
    "front.lower_left": (-1.5, 0.0, -1.2),
    "front.lower_right": (1.5, 0.0, -1.2),
    "front.upper_left": (-1.5, 2.4, -1.2),
    "front.upper_right": (1.5, 2.4, -1.2),
    "left.lower_left": (-1.5, 0.0, 1.0),
    "left.upper_left": (-1.5, 2.4, 1.0),
}
rig = out / "rig.toml"
rig.write_text(f"""unit = "m"
axes = "x-right y-up z-back"
[head]
tracker = "art"
sensor = 0
[hand]
tracker = "art"
sensor = 100
[[tracker]]
name = "art"
kind = "dtrack"
source = "udp://127.0.0.1:{port}"
[[wall]]
name = "front"
lower_left = [-1.5, 0.0, -1.2]
lower_right = [1.5, 0.0, -1.2]
upper_left = [-1.5, 2.4, -1.2]
pixels = [300, 240]
[[wall]]
name = "left"
lower_left = [-1.5, 0.0, 1.0]
lower_right = [-1.5, 0.0, -1.2]
upper_left = [-1.5, 2.4, 1.0]
pixels = [220, 240]
""")


class Sender:
    """DTRACK with one Flystick, 60 times a second: where it is, and what shakes or presses it."""

    def __init__(self):
        self.place = (0.0, 1.0, 0.0)
        self.shake_m = 0.0
        self.pressed = False
        self.seen = True
        self.frame = 0
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        threading.Thread(target=self.run, daemon=True).start()

    def run(self):
        while True:
            self.frame += 1
            shake = self.shake_m * math.sin(self.frame / 5.0)
            x, y, z = (a - b for a, b in zip(self.place, ORIGIN))
            in_tracker = (x + shake, -z, y)  # room (x, y, z) = tracker (x, z, -y)
            mm = [1e3 * v + random.gauss(0.0, 0.3) for v in in_tracker]
            text = f"fr {self.frame}\r\n"
            if self.seen:
                text += ("6df2 1 1 [0 1.000 2 0][%.3f %.3f %.3f][1 0 0 0 1 0 0 0 1][%d]\r\n"
                         % (*mm, 1 if self.pressed else 0))
            self.socket.sendto(text.encode(), ("127.0.0.1", port))
            time.sleep(1.0 / 60.0)

    def wait_frames(self, count):
        end = self.frame + count
        while self.frame < end:
            time.sleep(0.005)


sender = Sender()


class Person:
    """Runs the program; reads it line by line."""

    def __init__(self, *arguments, keyboard=subprocess.PIPE):
        self.program = subprocess.Popen([carom, "calibrate", rig, *arguments], stdin=keyboard,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.text = ""

    def read_until(self, pattern):
        """Reads on until it comes; returns the match."""
        deadline = time.monotonic() + 120.0
        while time.monotonic() < deadline:
            if found := re.search(pattern, self.text):
                self.text = self.text[found.end():]
                return found
            if select.select([self.program.stdout], [], [], 0.05)[0]:
                read = os.read(self.program.stdout.fileno(), 4096)
                if not read:
                    break
                self.text += read.decode()
        check(False, f"'{pattern}' did not come, but {self.text!r}")
        sys.exit(1)

    def key(self, keys):
        self.program.stdin.write(keys)
        self.program.stdin.flush()

    def take(self, by_button=False):
        """Takes a point; again if a busy machine lost samples meanwhile."""
        while True:
            if by_button:
                sender.pressed = True
            else:
                self.key(b"\n")
            answer = self.read_until(r"  (Taken|It moved|Nothing came)").group(1)
            sender.pressed = False
            sender.wait_frames(3)  # without it, so that the next press is one
            if answer == "Taken":
                return

    def end(self):
        out_text, err = self.program.communicate(timeout=60)
        return self.program.returncode, self.text + out_text.decode(), err.decode()


def line_of(text):
    found = re.search(r"room_from_tracker = \{ translation = \[(.*)\], rotation_deg = \[(.*)\] \}", text)
    return [float(v) for group in found.groups() for v in group.split(",")] if found else None


# All corners with the button; one taken again, one skipped, one shaken at first.
person = Person("--record", out / "points")
for number, (name, place) in enumerate(CORNERS.items(), 1):
    wall, corner = name.split(".")
    words = f"the {corner.replace('_', ' ')} corner of wall '{wall}'"
    person.read_until(re.escape(f"{number} of 6: touch {words}"))
    if number == 2:
        sender.shake_m = 0.05
        person.key(b"\n")
        person.read_until(r"It moved by more than \d+ mm")
        sender.shake_m = 0.0
    if number == 3:
        person.key(b"b")  # the second again
        person.read_until(re.escape("2 of 6: touch the lower right corner of wall 'front'"))
        sender.place = CORNERS["front.lower_right"]
        sender.wait_frames(3)
        person.take()
        person.read_until("3 of 6")
    if number == 5:
        person.key(b"s")
        continue
    sender.place = place
    sender.wait_frames(3)
    person.take(by_button=number % 2 == 1)
status, text, err = person.end()
check(status == 0, f"status {status}: {err}")
found = line_of(text)
expected = [*ORIGIN, -90.0, 0.0, 0.0]
check(found and all(abs(a - b) < (0.001 if i < 3 else 0.1) for i, (a, b) in enumerate(zip(found, expected))),
      f"the line says {found}, expected {expected}\n{text}")
check("left.lower_left" not in text, "a skipped corner is in the table")
check("--from" in err and "--corners front.lower_left" in err, f"how to do it again is not said: {err}")

# The same from what was recorded.
corners = ",".join(name for name in CORNERS if name != "left.lower_left")
again = subprocess.run([carom, "calibrate", rig, "--from", out / "points", "--corners", corners],
                       capture_output=True, text=True)
check(again.returncode == 0, f"from the recording: {again.stderr}")
repeated = line_of(again.stdout)
check(repeated and found and all(abs(a - b) < (1e-4 if i < 3 else 0.01) for i, (a, b) in
                                 enumerate(zip(repeated, found))), f"{repeated} is not {found}")

# A tracker that sees nothing is named, and an early end leaves no lines and nothing half-written.
sender.seen = False
person = Person("--record", out / "nothing")
person.read_until("1 of 6")
person.key(b"\n")
person.read_until(r"Nothing came from sensor 100: tracker art is ")
person.key(b"q")
status, text, err = person.end()
check(status == 1, f"an early end has status {status}")
check("0 touched corners are too few" in err, f"an early end says {err!r}")
check(line_of(text) is None, "an early end prints a line")
check(list((out / "nothing").iterdir()) == [], "an early end leaves files")

# What was taken is written at once, and a terminal is as before when the program is ended from outside.
sender.seen = True
keys, keyboard = pty.openpty()
usual = termios.tcgetattr(keyboard)
person = Person("--record", out / "ended", keyboard=keyboard)
person.read_until("1 of 6")
check(not termios.tcgetattr(keyboard)[3] & termios.ECHO, "the terminal shows the keys")
sender.place = CORNERS["front.lower_left"]
sender.wait_frames(3)
while True:
    os.write(keys, b"\n")
    if person.read_until(r"  (Taken|It moved|Nothing came)").group(1) == "Taken":
        break
person.read_until("2 of 6")
check((out / "ended" / "corners.csv").exists(), "the first point is not written before the second is asked for")
person.program.send_signal(signal.SIGTERM)
status, text, err = person.end()
check("1 touched corners are too few" in err, f"ended by SIGTERM, it says {err!r} with status {status}")
check(termios.tcgetattr(keyboard) == usual, "the terminal is not as it was")
sys.exit(1 if failures else 0)
