"""class_session.py CAROM CONFIG OUT: see class_session.sh."""

import asyncio
import contextlib
import pathlib
import re
import signal
import socket
import sqlite3
import subprocess
import sys
import time

from class_phones import Phone, lead

carom, config, out = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
file = out / "class.db"


class Session:
    """A session in a window; `address` and `pin` are those of its class."""

    def __init__(self, *options):
        self.errors = open(out / "stderr", "a")
        self.process = subprocess.Popen(
            [carom, "cave", *([] if "--resume" in options else ["--rig", out / "room.toml"]), "--silent",
             *map(str, options)],
            stdout=subprocess.PIPE, stderr=self.errors, text=True)
        self.address = self.word = self.pin = None
        if "--class" in options:
            line = self.process.stdout.readline()
            found = re.fullmatch(r"class: (http://[\d.]+:\d+/) ([A-Z]+) teacher (\d{6})\n", line)
            assert found, f"the class's line: {line!r}"
            self.address, self.word, self.pin = found.groups()

    def end(self, how=signal.SIGTERM):
        self.process.send_signal(how)
        self.process.wait(60)
        assert not self.process.stdout.read(), "nothing else is on standard output"

    def press(self, key):
        window = subprocess.run(["xdotool", "search", "--name", "Carom: screen"], capture_output=True, text=True)
        subprocess.run(["xdotool", "key", "--window", window.stdout.split()[0], key], check=True)

    def listening(self):
        """The ports on which the process listens."""
        inodes = set()
        for link in pathlib.Path(f"/proc/{self.process.pid}/fd").iterdir():
            with contextlib.suppress(OSError):
                inodes.update(re.findall(r"socket:\[(\d+)\]", str(link.readlink())))
        ports = []
        for table in "tcp", "tcp6", "udp", "udp6":
            with contextlib.suppress(FileNotFoundError):
                for row in pathlib.Path(f"/proc/{self.process.pid}/net/{table}").read_text().splitlines()[1:]:
                    fields = row.split()
                    if fields[9] in inodes and (table.startswith("udp") or fields[3] == "0A"):
                        ports.append(int(fields[1].split(":")[1], 16))
        return ports


def rows(sql):
    with contextlib.closing(sqlite3.connect(file, timeout=10)) as database:
        return database.execute(sql).fetchall()


def await_rows(sql, expected):
    for _ in range(300):
        found = rows(sql)
        if found == expected:
            return
        time.sleep(0.1)
    raise AssertionError(f"{sql}: {found}, expected {expected}")


def free_port():
    with contextlib.closing(socket.socket()) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


async def join_all(session, count):
    teacher = await Phone(session.address, {"pin": session.pin}).join()
    phones = [await Phone(session.address).join() for _ in range(count)]
    await teacher.until(lambda told: told["phones"] == count and told["lesson"])
    return teacher, phones


def votes_in_file():
    found = {}
    for lesson, round_, token, answer in rows("SELECT lesson, round, token, answer FROM vote"):
        votes = found.setdefault((lesson, round_), {})
        assert token not in votes, f"two votes of one phone: {token}"
        votes[token] = answer
    return found


others = []


async def whole_lessons(port):
    """Two lessons; then keys on the wall; then the session is killed while the second vote is open."""
    with open(out / "room.toml", "a") as rig:
        rig.write(f'\n[class]\naddress = "127.0.0.1"\nport = {port}\n')
    session = Session("--scenario", "seen-at-once", "--session", file, "--class")
    assert session.address == f"http://127.0.0.1:{port}/", "as the rig says"
    global others
    others = session.listening()
    others.remove(port)  # the rest are MPI's
    teacher, phones = await join_all(session, 6)
    _, voted = await lead(teacher, phones, 2)
    await_rows("SELECT count(*) FROM vote", [(24,)])
    assert votes_in_file() == voted, (votes_in_file(), voted)
    await_rows("SELECT value FROM input WHERE what = 'class' ORDER BY rowid LIMIT 9",
               [(phase,) for phase in ("idle", "vote 1", "closed 1", "discuss 1", "vote 2", "closed 2", "shown 2",
                                       "explained 2", "idle")])

    # Keys on the wall: the class follows, and what was answered counts.
    await teacher.say({"do": "next"})
    await teacher.until(lambda told: told["state"] == "idle" and told["lesson"] not in {key[0] for key in voted})
    await teacher.say({"do": "ask"})
    await phones[0].state("vote", 1)
    for phone in phones:
        await phone.say({"answer": 1, "round": 1})
    await teacher.until(lambda told: told["answered"] == 6)
    session.press("Return")
    shown = await phones[0].state("shown")
    assert shown["counts"][0][0] == 6, shown
    session.press("Return")
    await phones[0].state("explained")
    session.press("y")  # the question is asked anew
    await phones[0].state("idle")
    await_rows("SELECT count(*) FROM vote", [(30,)])

    # Killed while the second vote is open.
    await teacher.say({"do": "ask"})
    await teacher.state("vote", 1)
    for number, phone in enumerate(phones):
        await phone.say({"answer": 1 + number % 2, "round": 1})
    await teacher.until(lambda told: told["answered"] == 6)
    for step, state in (("close", "closed"), ("discuss", "discuss"), ("again", "vote")):
        await teacher.say({"do": step})
        await teacher.state(state)
    for phone in phones:
        await phone.say({"answer": 2, "round": 2})
    await teacher.until(lambda told: told["answered"] == 6)
    await_rows("SELECT value FROM input WHERE what = 'class' ORDER BY rowid DESC LIMIT 1", [("vote 2",)])
    await_rows("SELECT count(*) FROM vote", [(36,)])
    assert not rows("SELECT 1 FROM vote WHERE round = 2 AND lesson NOT IN ('%s')" %
                    "','".join(key[0] for key in voted)), "a vote that is open is in the file"
    session.end(signal.SIGKILL)
    for phone in phones:
        await phone.until(lambda told: told.get("closed"))
    return [phone.token for phone in phones]


async def resumed(port, tokens):
    session = Session("--session", file, "--resume", "--class", "--class-address", "127.0.0.1", "--class-port", port)
    teacher = await Phone(session.address, {"pin": session.pin}).join()
    begun = time.monotonic()
    phones = [await Phone(session.address, {"hello": token}).join() for token in tokens]
    assert [phone.token for phone in phones] == tokens, "the phones are known"
    for phone in phones:
        told = await phone.state("vote", 2)
        assert told["first"] in (1, 2) and told["yours"] is None, told
    assert time.monotonic() - begun < 10
    for phone in phones:
        await phone.say({"answer": 2, "round": 2})
    await teacher.until(lambda told: told["answered"] == 6)
    await teacher.say({"do": "close"})
    told = await teacher.state("closed", 2)
    assert told["counts"][0][:2] == [3, 3] and told["counts"][1][1] == 6, told
    await_rows("SELECT count(*) FROM vote", [(42,)])
    taken = subprocess.run([carom, "cave", "--rig", out / "room.toml", "--frames", "2", "--class", "--class-address",
                            "127.0.0.1", "--class-port", str(port)], capture_output=True, text=True)
    assert taken.returncode == 1 and f"class: port {port} of 127.0.0.1 is taken by another program" in taken.stderr, taken
    session.end()
    assert not rows("SELECT 1 FROM answer WHERE answer = '(skipped)'"), "who answers by phone skips nothing on the wall"
    text = subprocess.run([carom, "answers", file], capture_output=True, text=True, check=True).stdout
    assert "vote 1  vote 2" in text and text.count("phones that voted: 6, then 6") == 2, text
    assert "phones that voted: 12, then 6" in text, text


def without_class():
    global file
    file = out / "alone.db"
    session = Session("--scenario", "seen-at-once", "--session", file)
    for _ in range(300):
        if file.exists() and file.stat().st_size and rows("SELECT count(*) > 5 FROM sqlite_schema") == [(1,)]:
            break
        time.sleep(0.1)
    assert len(session.listening()) == len(others), session.listening()
    session.end()
    assert not rows("SELECT name FROM sqlite_schema WHERE name = 'vote'")
    assert not rows("SELECT 1 FROM input WHERE what = 'class'")


async def main():
    port = free_port()
    tokens = await whole_lessons(port)
    await resumed(port, tokens)
    without_class()
    print("two lessons of six phones, keys on the wall, a killed session resumed in an open vote; none without --class")


asyncio.run(main())
