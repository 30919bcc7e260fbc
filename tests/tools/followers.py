#!/usr/bin/env python3
"""followers.py CAROM CONFIG [PHONES] [TURNS]: what phones that follow a game cost its session. One session, in turn without them and
with so many (30), so many times (6), ten seconds each: processor time of the frames' thread a frame, of the server's thread,
the time from frame to frame, and how many frames each phone is told of. Needs a display (tests/with_display).

Where there is no card Mesa is told to draw nothing, so that a frame is what the program computes, and comes on time. The phones
run on the same computer as the session: their own processor time is theirs, so the frames' thread tells what the
session pays; the time from frame to frame also tells what the phones take from it where cores are few."""

import base64
import os
import pathlib
import re
import selectors
import signal
import socket
import sqlite3
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import urllib.parse

carom, config = sys.argv[1], pathlib.Path(sys.argv[2])
PHONES, TURNS = (int(sys.argv[i]) if len(sys.argv) > i else usual for i, usual in ((3, 30), (4, 6)))
TURN_S, SETTLE_S = 10.0, 2.0
SERVER_NICE = 10  # app/class_server/class_host.cpp


class Phones:
    """Follow the game in a thread of their own, and count the messages of each."""

    def __init__(self, at, count):
        self.told = [0] * count
        self.selector, self.ends = selectors.DefaultSelector(), False
        for number in range(count):
            phone = socket.create_connection((at.hostname, at.port), source_address=(f"127.0.1.{number % 250 + 1}", 0))
            key = base64.b64encode(os.urandom(16)).decode()
            phone.sendall((f"GET /follow/socket HTTP/1.1\r\nHost: {at.netloc}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                           f"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {key}\r\n\r\n").encode())
            answer = b""
            while b"\r\n\r\n" not in answer:
                answer += phone.recv(1)
            assert b" 101 " in answer, answer
            phone.setblocking(False)
            self.selector.register(phone, selectors.EVENT_READ, [number, bytearray()])
        self.thread = threading.Thread(target=self.read)
        self.thread.start()

    def read(self):
        while not self.ends:
            for key, _ in self.selector.select(0.2):
                number, held = key.data
                held += key.fileobj.recv(1 << 16)
                while (length := self.first(held)) and len(held) >= length:
                    del held[:length]
                    self.told[number] += 1

    @staticmethod
    def first(held):
        """The length of the first message with its head; 0 if that is not there yet."""
        if len(held) < 2:
            return 0
        short, more = held[1] & 127, {126: 2, 127: 8}.get(held[1] & 127, 0)
        if len(held) < 2 + more:
            return 0
        return 2 + more + (int.from_bytes(held[2 : 2 + more], "big") if more else short)

    def end(self):
        self.ends = True
        self.thread.join()
        for key in list(self.selector.get_map().values()):
            key.fileobj.close()


class Session:
    def __init__(self, out):
        rig = re.sub(r"(?m)^pixels = .*", "pixels = [64, 36]", (config / "rigs/single-screen.toml").read_text())
        (out / "room.toml").write_text(rig)
        self.database = out / "game.db"
        self.process = subprocess.Popen(
            [carom, "cave", "--rig", out / "room.toml", "--scenario", "welcome", "--silent", "--no-window", "--session", self.database,
             "--class", "--class-address", "127.0.0.1", "--class-port", "0", "--follow"],
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
            env=os.environ | {"GALLIUM_NOOP": "1"})  # fmt: skip
        self.at = urllib.parse.urlsplit(re.match(r"class: (\S+) ", self.process.stdout.readline())[1])

    def frames(self):
        try:
            with sqlite3.connect(f"file:{self.database}?mode=ro", uri=True) as db:
                return [row[0] for row in db.execute("SELECT display_s FROM frame ORDER BY number")]
        except sqlite3.OperationalError:  # not there yet
            return []

    def processor_s(self):
        """Of the frames' thread, and of the server's, which is the only one that is nice."""
        found = [0.0, 0.0]
        for task in pathlib.Path(f"/proc/{self.process.pid}/task").iterdir():
            fields = (task / "stat").read_text().rsplit(")", 1)[1].split()
            ran_s = int((task / "schedstat").read_text().split()[0]) * 1e-9
            if task.name == str(self.process.pid):
                found[0] = ran_s
            elif int(fields[16]) == SERVER_NICE:
                found[1] += ran_s
        return found


def turn(session, count):
    """Returns what was measured in ten seconds with so many phones."""
    phones = Phones(session.at, count)
    time.sleep(SETTLE_S)
    told, before, (frames_s, server_s), begun = list(phones.told), len(session.frames()), session.processor_s(), time.monotonic()
    time.sleep(TURN_S)
    lasted_s, (frames_after_s, server_after_s), shown = time.monotonic() - begun, session.processor_s(), session.frames()[before:]
    told = [(after - one) / lasted_s for one, after in zip(told, phones.told)]
    phones.end()
    steps_ms = [1e3 * (b - a) for a, b in zip(shown, shown[1:])]
    return {"frame_us": 1e6 * (frames_after_s - frames_s) / len(shown), "server": 100 * (server_after_s - server_s) / lasted_s,
            "step_ms": statistics.mean(steps_ms), "late_ms": sorted(steps_ms)[int(0.99 * len(steps_ms))], "told": min(told, default=0)}


with tempfile.TemporaryDirectory() as folder:
    session = Session(pathlib.Path(folder))
    try:
        while len(session.frames()) < 600:
            time.sleep(0.5)
        turns = {0: [], PHONES: []}
        for number in range(TURNS):
            for count in (0, PHONES) if number % 2 else (PHONES, 0):
                found = turn(session, count)
                turns[count].append(found)
                print(f"{count:3} phones: a frame {found['frame_us']:.0f} us of the frames' thread, every {found['step_ms']:.2f} ms, "
                      f"99 % within {found['late_ms']:.1f} ms; the server {found['server']:.1f} % of a core; told {found['told']:.1f} times a second or more",
                      flush=True)  # fmt: skip
    finally:
        session.process.send_signal(signal.SIGTERM)
        session.process.wait(60)
for what in ("frame_us", "step_ms", "late_ms"):
    ratios = [100 * (b[what] / a[what] - 1) for a, b in zip(turns[0], turns[PHONES])]
    print(f"{what}: {statistics.median(a[what] for a in turns[0]):.2f} without, {statistics.median(b[what] for b in turns[PHONES]):.2f} with; "
          f"by pairs {statistics.mean(ratios):+.1f} % ± {statistics.stdev(ratios) / len(ratios) ** 0.5:.1f} %")
