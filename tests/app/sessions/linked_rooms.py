"""Two rooms of linked sessions, a proxy between them, and what their session files hold: for link_session.py and
link_troubles.py, whose arguments are the program, its configuration and a folder."""

import json
import math
import pathlib
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
rooms = []


def fail(words):
    for room in rooms:
        if room.process.poll() is None:
            room.process.kill()
        print(f"--- {room.name}:\n{room.said()[-3000:]}")
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
    """A session, and a person in it whose wand strikes pucks that lie still. It is one of `rooms` from now on. `ranks`: on so
    many computers, each with a wall."""

    def __init__(self, name, side, link, ranks=1):
        self.name, self.side = name, side  # side: 1 at −x, −1 at +x
        self.ends = ()  # exit codes with which it may end
        rooms.append(self)
        self.file, self.status = out / f"{name}.db", out / f"{name}.json"
        self.pictures = out / f"{name}-pictures"
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.hand, self.way, self.button, self.sways = (0.25, 1.2, -0.3), (0.0, 0.0, -1.0), 0, True
        self.rig = out / f"{name}.toml"
        wall = ('[[wall]]\nname = "{0}"\nlower_left = [-0.8, 0.9, {1}]\nlower_right = [0.8, 0.9, {1}]\n'
                'upper_left = [-0.8, 1.8, {1}]\npixels = [48, 32]\nstereo = "mono"\nnode = {2}\n')
        self.rig.write_text(
            f'title = "{name}"\nunit = "m"\naxes = "x-right y-up z-back"\ndisplay_hz = 30.0\n'
            '[head]\ntracker = "osc"\neye_separation = 0.064\n[hand]\ntracker = "osc"\nsensor = 1\n'
            f'[[tracker]]\nname = "osc"\nkind = "osc"\nsource = "udp://127.0.0.1:{self.port}"\n'
            'osc = { pose = "/pose/{sensor}", buttons = "/button/{sensor}/{n}" }\n'
            + "".join(wall.format(f"screen{rank or ''}", -1.0 - 0.1 * rank, rank) for rank in range(ranks))
            + f'[link]\nname = "{name}"\nkey = "room.key"\n'
        )
        threading.Thread(target=self.move, daemon=True).start()
        scenario = ["--scenario", "two-cities"] if link.startswith("listen") else []
        self.start(["--rig", self.rig, "--link", link, *scenario, "--capture", self.pictures], ranks)

    def start(self, options, ranks=1):
        """Starts the session; with "--resume" among its options, after the last one has ended."""
        mpi = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks)] if ranks > 1 else []
        with open(out / f"{self.name}.err", "a") as log:
            # The signals that Python ignores are ignored: also that of a file which becomes too large.
            self.process = subprocess.Popen(
                [*mpi, carom, "cave", *options, "--session", self.file, "--status", self.status, "--no-window", "--silent"],
                stderr=log, restore_signals=False)

    def said(self):
        return (out / f"{self.name}.err").read_text()

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
            if room.process.poll() not in (None, *room.ends):
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


def playing():
    return all(room.link().get("state") == "playing" for room in rooms)


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as free:
        return free.getsockname()[1]


def host(port, **options):
    """Makes a key, and begins the room that listens."""
    subprocess.run([carom, "link", "--new-key", out / "room.key"], check=True, stdout=subprocess.DEVNULL)
    room = Room("grenoble", 1, f"listen:127.0.0.1:{port}", **options)
    wait(60, "the host does not begin", lambda: room.rows("SELECT 1 FROM frame LIMIT 1"))
    return room


def compare(games):
    """Both files tell one game, so many times joined."""
    compared = subprocess.run([carom, "compare", *(room.file for room in rooms)], text=True, capture_output=True)
    print(compared.stdout, end="")
    if compared.returncode != 0 or "the same game" not in compared.stdout or compared.stdout.count("game ") < games:
        fail(f"compare: {compared.stdout} {compared.stderr}")
