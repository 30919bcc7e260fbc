"""What link_session.sh says: two rooms, a proxy between them, and what their journals hold."""

import filecmp
import json
import math
import os
import pathlib
import re
import shutil
import signal
import socket
import sqlite3
import struct
import subprocess
import sys
import threading
import time

carom, config, out = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
DELAY_S = 0.1


def fail(words):
    for room in rooms:
        if room.process.poll() is None:
            room.process.kill()
        print(f"--- {room.name}:\n{(out / (room.name + '.err')).read_text()[-3000:]}")
    sys.exit(f"FAILED: {words}")


class Proxy:
    """Passes bytes on after a while. `silent`: it swallows them, and takes no call. `cut`: it hangs up."""

    def __init__(self, port):
        self.port, self.silent, self.pairs, self.took_s = port, False, [], []
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.own = self.listener.getsockname()[1]
        threading.Thread(target=self.accept, daemon=True).start()

    def accept(self):
        while True:
            caller, _ = self.listener.accept()
            if self.silent:
                self.pairs.append((caller, caller))
                continue
            try:
                called = socket.create_connection(("127.0.0.1", self.port))
            except OSError:
                caller.close()
                continue
            for one in (caller, called):
                one.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.pairs.append((caller, called))
            for a, b in ((caller, called), (called, caller)):
                threading.Thread(target=self.carry, args=(a, b), daemon=True).start()

    def carry(self, a, b):
        queue, more = [], threading.Condition()

        def send():
            while True:
                with more:
                    more.wait_for(lambda: queue)
                    at_s, data = queue.pop(0)
                time.sleep(max(0.0, at_s - time.monotonic()))
                if not data:
                    break
                if not self.silent:
                    self.took_s.append(time.monotonic() - at_s + DELAY_S)
                    try:
                        b.sendall(data)
                    except OSError:
                        break
            for one in (a, b):
                try:
                    one.shutdown(socket.SHUT_RDWR)
                except OSError:
                    pass

        threading.Thread(target=send, daemon=True).start()
        while True:
            try:
                data = a.recv(65536)
            except OSError:
                data = b""
            with more:
                queue.append((time.monotonic() + DELAY_S, data))
                more.notify()
            if not data:
                return

    def round_ms(self):
        """The round trip of what has passed since it was asked last, as it was delayed here."""
        took_s = sorted(self.took_s)
        self.took_s = []
        return 2e3 * took_s[len(took_s) // 2]

    def cut(self):
        for pair in self.pairs:
            for one in pair:
                try:
                    one.shutdown(socket.SHUT_RDWR)
                except OSError:
                    pass
        self.pairs.clear()


def osc(address, *values):
    def text(word):
        data = word.encode() + b"\0"
        return data + bytes(-len(data) % 4)

    kinds = "," + "".join("i" if isinstance(value, int) else "f" for value in values)
    body = b"".join(struct.pack(">i" if isinstance(value, int) else ">f", value) for value in values)
    return text(address) + text(kinds) + body


class Room:
    """A session, and a person in it whose wand strikes pucks that lie still."""

    def __init__(self, name, side, link):
        self.name, self.side = name, side  # side: 1 at −x, −1 at +x
        self.file, self.status = out / f"{name}.db", out / f"{name}.json"
        self.pictures = out / f"{name}-pictures"
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.hand, self.way, self.button, self.sways = (0.25, 1.2, -0.3), (0.0, 0.0, -1.0), 0, True
        rig = out / f"{name}.toml"
        rig.write_text(
            f'title = "{name}"\nunit = "m"\naxes = "x-right y-up z-back"\ndisplay_hz = 30.0\n'
            '[head]\ntracker = "osc"\neye_separation = 0.064\n[hand]\ntracker = "osc"\nsensor = 1\n'
            f'[[tracker]]\nname = "osc"\nkind = "osc"\nsource = "udp://127.0.0.1:{self.port}"\n'
            'osc = { pose = "/pose/{sensor}", buttons = "/button/{sensor}/{n}" }\n'
            '[[wall]]\nname = "screen"\nlower_left = [-0.8, 0.9, -1.0]\nlower_right = [0.8, 0.9, -1.0]\n'
            'upper_left = [-0.8, 1.8, -1.0]\npixels = [48, 32]\nstereo = "mono"\n'
            f'[link]\nname = "{name}"\nkey = "room.key"\n'
        )
        threading.Thread(target=self.move, daemon=True).start()
        scenario = ["--scenario", "two-cities"] if link.startswith("listen") else []
        with open(out / f"{name}.err", "w") as log:
            self.process = subprocess.Popen(
                [carom, "cave", "--rig", rig, "--link", link, *scenario, "--session", self.file, "--status", self.status,
                 "--capture", self.pictures, "--no-window", "--silent"], stderr=log)

    def move(self):
        sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        begun = time.monotonic()
        while True:
            t = time.monotonic() - begun
            x = 0.05 * math.sin(t) if self.sways else 0.0
            # The turn that takes (0, 0, -1) to the wand's way: axis × sine of half the angle, and its cosine.
            turn = [self.way[1], -self.way[0], 0.0, 1.0 - self.way[2]]
            size = math.hypot(*turn)
            for message in (osc("/pose/0", x, 1.6, 0.0, 0.0, 0.0, 0.0, 1.0),
                            osc("/pose/1", *self.hand, *(part / size for part in turn)),
                            osc("/button/1/0", self.button)):
                sender.sendto(message, ("127.0.0.1", self.port))
            time.sleep(1 / 60)

    def rows(self, sql):
        try:
            with sqlite3.connect(f"file:{self.file}?mode=ro", uri=True, timeout=5) as database:
                return database.execute(sql).fetchall()
        except sqlite3.OperationalError:
            return []

    def link(self):
        try:
            return json.loads(self.status.read_text()).get("link", {})
        except (OSError, ValueError):
            return {}

    def notes(self, what):
        return len(self.rows(f"SELECT 1 FROM link_note WHERE what = '{what}'"))

    def strike(self, puck):
        """Strikes a puck where it lies; returns whether it lay still."""
        first = self.rows("SELECT max(first_frame) FROM game")[0][0]
        frame = self.rows("SELECT t_s FROM frame ORDER BY number DESC LIMIT 1")[0][0]
        rest = {1: (-0.5, -0.3), 2: (0.5, 0.3), 3: (0.0, 0.0)}[puck]
        knots = self.rows("SELECT t_s, x_m, y_m, u_x, u_y, deceleration_m_s2 FROM knot WHERE body = %d AND frame >= %d "
                          "ORDER BY frame DESC, rowid DESC LIMIT 1" % (puck, first))
        for t_s, x_m, y_m, u_x, u_y, slows in knots:
            # A proper deceleration a: at rest after c u/a, on the way (c²/a)(γ − 1).
            u, c = math.hypot(u_x, u_y), 1.42
            way = c * c / slows * (math.hypot(1.0, u) - 1.0) if u > 0 else 0.0
            if u > 0 and t_s + c * u / slows > frame - 3.0:
                return False
            rest = (x_m + way * u_x / u, y_m + way * u_y / u) if u > 0 else (x_m, y_m)
        self.sways = False
        time.sleep(0.7)
        # From the head, for whose first jump the room was moved on the board.
        head = self.rows("SELECT x_m, y_m, z_m FROM frame ORDER BY number DESC LIMIT 1")[0]
        dx, dy, dz = rest[0] - head[0], rest[1] - head[1], 0.015 - head[2]
        place = (-dy * self.side, 1.6 + dz, -dx * self.side)
        way = [p - h for p, h in zip(place, (0.25, 1.2, -0.3))]
        self.way = tuple(part / math.hypot(*way) for part in way)
        time.sleep(0.4)
        self.button = 1
        time.sleep(0.2)
        flat = math.hypot(self.way[0], self.way[2])
        for step in range(1, 11):
            pull = 0.005 * step
            self.hand = (0.25 - pull * self.way[0] / flat, 1.2, -0.3 - pull * self.way[2] / flat)
            time.sleep(0.03)
        self.button = 0
        time.sleep(0.2)
        self.hand, self.sways = (0.25, 1.2, -0.3), True
        return True


def wait(for_s, words, isThere):
    end = time.monotonic() + for_s
    while time.monotonic() < end:
        for room in rooms:
            if room.process.poll() not in (None, *allowed):
                fail(f"{room.name} ended with {room.process.returncode}")
        if isThere():
            return
        time.sleep(0.1)
    fail(words)


def strike_in_turn(count):
    made = 0
    end = time.monotonic() + 30.0 * count
    while made < count and time.monotonic() < end:
        room = rooms[made % 2]
        before = room.rows("SELECT count(*) FROM stroke")[0][0]
        if any(room.strike(puck) for puck in (1 + made % 3, 1 + (made + 1) % 3)):
            time.sleep(1.0)
            made += 1 if room.rows("SELECT count(*) FROM stroke")[0][0] > before else 0
        time.sleep(0.3)
    if made < count:
        fail(f"only {made} of {count} strokes were made")


def alone(rig):
    """Runs a session without --link for a moment; returns the numbers of its TCP sockets and threads, and its tables."""
    session = out / f"{rig.stem}.db"
    with open(out / "alone.err", "w") as log:
        process = subprocess.Popen([carom, "cave", "--rig", rig, "--scenario", "two-cities", "--session", session, "--no-window",
                                    "--silent"], stderr=log)
    end = time.monotonic() + 60
    while time.monotonic() < end and not session.exists():
        time.sleep(0.2)
    time.sleep(2.0)
    inodes = {line.split()[9] for table in ("tcp", "tcp6")
              for line in pathlib.Path(f"/proc/{process.pid}/net/{table}").read_text().splitlines()[1:]}
    held = []
    for link in pathlib.Path(f"/proc/{process.pid}/fd").iterdir():
        try:
            held.append(os.readlink(link))
        except OSError:
            pass
    sockets = sum(f"socket:[{inode}]" in held for inode in inodes)
    threads = len(list(pathlib.Path(f"/proc/{process.pid}/task").iterdir()))
    process.send_signal(signal.SIGTERM)
    process.wait(30)
    with sqlite3.connect(session) as database:
        return sockets, threads, [row[0] for row in database.execute("SELECT name FROM sqlite_schema ORDER BY name")]


def plain():
    """Without --link and `with` a rig that has a [link] opens no socket, has no thread more and no table."""
    with_link, without = out / "with.toml", out / "without.toml"
    without.write_text(
        'title = "alone"\nunit = "m"\naxes = "x-right y-up z-back"\ndisplay_hz = 30.0\n[head]\ntracker = "walks"\n'
        'eye_separation = 0.064\n[[tracker]]\nname = "walks"\nkind = "simulated"\n[[wall]]\nname = "screen"\n'
        'lower_left = [-0.8, 0.9, -1.0]\nlower_right = [0.8, 0.9, -1.0]\nupper_left = [-0.8, 1.8, -1.0]\n'
        'pixels = [48, 32]\nstereo = "mono"\n')
    with_link.write_text(without.read_text() + '[link]\nname = "alone"\nkey = "room.key"\n')
    found, expected = alone(with_link), alone(without)
    if found != expected or any("link" in name for name in found[2]):
        fail(f"a session without --link has {found}, expected {expected}")
    print(f"without --link: {found[0]} TCP sockets (of MPI) and {found[1]} threads, as without [link], and no table of links")


def measured():
    """What `carom link --test` and `carom doctor` say of the line, beside what it is known to be."""
    address = f"127.0.0.1:{proxy.own}"
    rig = out / "annecy.toml"
    rig.write_text((out / "lyon.toml").read_text().replace('name = "lyon"\nkey', f'name = "annecy"\nwith = "{address}"\nkey'))
    for command in (["link", "--test", address, "--key", out / "room.key"], ["doctor", rig]):
        proxy.took_s = []
        said = subprocess.run([carom, *command], text=True, capture_output=True)
        known_ms = proxy.round_ms()
        found = re.search(r"round trip:? (?:median )?([0-9.]+) ms", said.stdout + said.stderr)
        if not found:
            fail(f"carom {command[0]} measures nothing: {said.stdout} {said.stderr}")
        print(f"carom {command[0]}: {found[1]} ms, known {known_ms:.1f} ms")
        if abs(float(found[1]) - known_ms) > 0.1 * known_ms:
            fail(f"carom {command[0]} says {found[1]} ms of a line of {known_ms:.1f} ms")


def people():
    """Both rooms show the other's person: in their events, and in their pictures, which are others without."""
    for room in rooms:
        kinds = [row[0] for row in room.rows("SELECT kind FROM link_person ORDER BY rowid")]
        if kinds[0] != 1 or kinds.count(2) < 1 or 0 not in kinds:
            fail(f"{room.name}: people of kinds {set(kinds)}")
        table = subprocess.run([carom, "events", room.file, "--game", "1", "--csv", "-"], text=True, capture_output=True).stdout
        header = table.splitlines()[0]
        if header.count("_proper_time_s") != 2 or "seen_by_viewer_afar_t_s" not in header:
            fail(f"{room.name}: events do not say when the others saw them: {header}")
        seen = subprocess.run([carom, "export", room.file, "--game", "1", "--every", "10", "--csv", "-"], text=True,
                              capture_output=True).stdout
        if seen.count(",viewer_afar,seen,") < 10:
            fail(f"{room.name}: the other's person is not exported: {seen[:1000]}")
        bare = out / f"{room.name}-bare.db"
        shutil.copy(room.file, bare)
        with sqlite3.connect(bare) as database:
            database.execute("DELETE FROM link_person")
        pictures = out / f"{room.name}-bare"
        subprocess.run([carom, "replay", bare, "--game", "1", "--capture", pictures, "--no-window"], check=True,
                       stderr=subprocess.DEVNULL)
        names = [picture.name for picture in pictures.glob("*.png") if (room.pictures / picture.name).exists()]
        other = sum(not filecmp.cmp(pictures / name, room.pictures / name, shallow=False) for name in names)
        print(f"{room.name}: {other} of {len(names)} pictures show the other's person")
        if other < 0.3 * len(names):
            fail(f"{room.name}: the other's person is not seen")


allowed, rooms = (), []
subprocess.run([carom, "link", "--new-key", out / "room.key"], check=True, stdout=subprocess.DEVNULL)
with socket.create_server(("127.0.0.1", 0)) as free:
    port = free.getsockname()[1]
proxy = Proxy(port)
plain()
rooms.append(Room("grenoble", 1, f"listen:127.0.0.1:{port}"))
wait(60, "the host does not begin", lambda: rooms[0].rows("SELECT 1 FROM frame LIMIT 1"))
rooms.append(Room("lyon", -1, f"127.0.0.1:{proxy.own}"))
grenoble, lyon = rooms
playing = lambda: all(room.link().get("state") == "playing" for room in rooms)
wait(60, "they do not play together", playing)
strike_in_turn(4)
round_ms = lyon.link()["round_trip_ms"]["median"]
print(f"round trip {round_ms:.0f} ms")
if not 1.8e3 * DELAY_S < round_ms < 3e3 * DELAY_S:
    fail(f"a round trip of {round_ms} ms")

measured()

proxy.cut()
proxy.silent = True
time.sleep(2.0)
proxy.cut()
proxy.silent = False
wait(20, "they do not go on after a cut", lambda: all(room.notes("back") for room in rooms))
if any(room.notes("gone") for room in rooms):
    fail("a cut of 2 s parts them")
strike_in_turn(2)

proxy.silent = True
wait(15, "who is silent is not gone", lambda: all(room.notes("gone") for room in rooms))
time.sleep(5.0)
proxy.cut()
proxy.silent = False
wait(40, "they do not join anew", lambda: all(room.notes("paired") == 2 for room in rooms))
wait(20, "they do not play anew", playing)
strike_in_turn(2)
time.sleep(3.0)

allowed = (-signal.SIGKILL,)
lyon.process.kill()
wait(20, "who is killed is not gone", lambda: grenoble.notes("gone") == 2)
frame = grenoble.rows("SELECT max(number) FROM frame")[0][0]
wait(20, "the other does not live on", lambda: grenoble.rows("SELECT max(number) FROM frame")[0][0] > frame + 30)
allowed = (-signal.SIGKILL, 0)
grenoble.process.send_signal(signal.SIGTERM)
if grenoble.process.wait(30) != 0:
    fail(f"the host ended with {grenoble.process.returncode}")

for room in rooms:
    waits = room.rows("SELECT avg(waits) FROM link WHERE state = 'playing'")[0][0]
    print(f"{room.name}: waits in {100 * waits:.2f} % of the frames, games {room.rows('SELECT count(*) FROM game')[0][0]}")
compared = subprocess.run([carom, "compare", grenoble.file, lyon.file], text=True, capture_output=True)
print(compared.stdout, end="")
if compared.returncode != 0 or "the same game" not in compared.stdout or compared.stdout.count("game ") < 2:
    fail(f"compare: {compared.stdout} {compared.stderr}")

# One bit of one stroke: it is noticed.
with sqlite3.connect(lyon.file) as database:
    database.execute("UPDATE stroke SET offset_m = offset_m + 1e-12 WHERE rowid = 1")
changed = subprocess.run([carom, "compare", grenoble.file, lyon.file], text=True, capture_output=True)
if changed.returncode != 1 or "first difference: stroke 0" not in changed.stdout:
    fail(f"compare of a changed file: {changed.stdout} {changed.stderr}")
with sqlite3.connect(lyon.file) as database:
    database.execute("UPDATE stroke SET offset_m = offset_m - 1e-12 WHERE rowid = 1")

for room in rooms:
    again = out / f"{room.name}-again"
    for game in range(1, room.rows("SELECT count(*) FROM game")[0][0] + 1):
        subprocess.run([carom, "replay", room.file, "--game", str(game), "--capture", again, "--no-window"], check=True,
                       stderr=subprocess.DEVNULL)
    frames = {row[0] for row in room.rows("SELECT number FROM frame")}
    same = differ = 0
    for picture in sorted(again.glob("*.png")):
        shown = room.pictures / picture.name
        if not shown.exists():
            continue  # the killed one had not written it
        if filecmp.cmp(picture, shown, shallow=False):
            same += 1
        else:
            differ += 1
    print(f"{room.name}: {same} pictures are the same again, {differ} differ, of {len(frames)} frames")
    if differ or same < 0.9 * len(frames):
        fail("a replay differs from what was seen")
people()
