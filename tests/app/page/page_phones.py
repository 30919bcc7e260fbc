"""page_phones.py CAROM OUT SHOTS: see page_phones.sh."""

import base64
import contextlib
import http.client
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
import urllib.parse

from chromium_page import OpenPage

carom, out = sys.argv[1], pathlib.Path(sys.argv[2])
LOOKED_AT = len(sys.argv) > 3  # by somebody, afterwards
shots = pathlib.Path(sys.argv[3]) if LOOKED_AT else out / "shots"
pictures = out / "pictures"
shots.mkdir(parents=True, exist_ok=True)
PATIENCE_S = 300


def until(what, words):
    ends = time.monotonic() + PATIENCE_S
    while time.monotonic() < ends:
        found = what()
        if found:
            return found
        time.sleep(0.1)
    raise AssertionError(f"in vain: {words}")


class Wall:
    """The session, whose wall is captured."""

    def __init__(self):
        self.process = subprocess.Popen(
            [carom, "cave", "--rig", out / "room.toml", "--scenario", out / "two-cushions.toml", "--silent", "--capture", pictures,
             "--session", out / "game.db", "--class", "--class-address", "127.0.0.1", "--class-port", "0", "--take", "--follow"],
            stdout=subprocess.PIPE, stderr=open(out / "stderr", "w"), text=True)
        self.address = re.match(r"class: (\S+) ", self.process.stdout.readline())[1]
        self.at = urllib.parse.urlsplit(self.address)

    def picture(self):
        """The newest picture that is whole; the old ones go."""
        files = sorted(pictures.glob("*.png")) if pictures.exists() else []
        for old in files[:-4]:
            old.unlink()
        return files[-2] if len(files) > 3 else None

    def code(self):
        """What the QR code on the wall says."""
        picture = self.picture()
        if not picture:
            return ""
        return subprocess.run(["zbarimg", "-q", "--raw", picture], capture_output=True, text=True).stdout.strip()

    def restart(self):
        found = subprocess.run(["xdotool", "search", "--name", "Carom: screen"], capture_output=True, text=True)
        subprocess.run(["xdotool", "key", "--window", found.stdout.split()[0], "y"], check=True)

    def offered(self, not_this=""):
        """The address of the page that the wall offers."""
        address = until(lambda: (code := self.code()) and "/take/" in code and code != not_this and code, "an offer on the wall")
        assert re.fullmatch(re.escape(self.address) + "take/[A-HJ-NP-Z]{8}", address), address
        return address

    def get(self, path, source):
        with contextlib.closing(http.client.HTTPConnection(self.at.hostname, self.at.port, source_address=(source, 0))) as asks:
            asks.request("GET", path)
            answer = asks.getresponse()
            return answer.status, answer.read()


def never_reads(wall):
    """A follower that asks for all and reads nothing."""
    lazy = socket.create_connection((wall.at.hostname, wall.at.port))
    lazy.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    key = base64.b64encode(os.urandom(16)).decode()
    lazy.send((f"GET /follow/socket HTTP/1.1\r\nHost: {wall.at.netloc}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
               f"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {key}\r\n\r\n").encode())
    return lazy


def follow(page, wall):
    until(lambda: wall.get("/follow", "127.0.0.1")[0] == 200, "the page that follows")
    page.go(wall.address + "follow")
    page.until("return window.carom.told().messages > 0")


def hits(page):
    """The events of the list: their names with their place in the order of the present observer."""
    lines = page.run("return [...document.querySelectorAll('.events li')].map(one => one.textContent)")
    return {found[1]: int(found[2]) for line in lines if (found := re.match(r"(\w+) meets a cushion at 1\.\d+ s, here number (\d+)", line))}


def test_three_orders(page, wall):
    """Three followers, of whom two join in the middle."""
    driver, found = page.driver, {}
    lazy = never_reads(wall)
    for name, beta in (("at rest", 0.0), ("to the right", 0.5), ("to the left", -0.5)):
        if found:
            page.another_tab()
        if not LOOKED_AT:
            page.without_drawing()
        follow(page, wall)
        page.until("return window.carom.about().known_s > 5")
        observer = {"beta": [beta, 0, 0], "position_m": [0, -2.5, 1], "t_s": 4.9}
        at = page.call("observer", observer)
        assert not at["held"], at
        page.until(f"return document.querySelector('.facts').textContent.includes(\"table's: 4.9 s. Your speed: {abs(beta):.2f} \")")
        assert len(hits(page)) == 2, hits(page)
        found[name] = hits(page)
        page.until("return window.carom.told().messages > 3")
        page.run("document.querySelector('.menu').hidden = false; document.querySelector('.menu').scrollTop = 1e6")
        page.screenshot(shots / f"follow-{name.replace(' ', '-')}.png")
    print("follow: white and red hit their cushions,", "; ".join(
        f"for one {name} as number {of['white']} and {of['red']}" for name, of in found.items()))
    assert found["at rest"]["white"] == found["at rest"]["red"], found
    assert found["to the right"]["white"] < found["to the right"]["red"], found
    assert found["to the left"]["white"] > found["to the left"]["red"], found
    # Who joined in the middle knows what those know who were told news by news.
    moment_s = page.call("about")["known_s"] - 1.0
    told, seen = [], []
    for tab in driver.window_handles:
        driver.switch_to.window(tab)
        page.until(f"return window.carom.about().known_s > {moment_s}")
        at = page.call("observer", {"beta": [0.5, 0, 0], "position_m": [0, -2.5, 1], "t_s": moment_s})
        assert not at["held"], at
        seen.append([page.call("engine", None, "mono", body, [[0, 0, 0], [0.1, 0, 0]]) for body in (1, 2)])
        told.append(page.call("told"))
    assert seen[0] == seen[1] == seen[2], seen
    assert all(abs(at_m) < 6 for body in seen[0] for place in body for at_m in place), seen  # on the table, retarded
    print("follow: the three were told", told)
    # All is told anew to one who could not read for a while, as on a busy machine; not at each news.
    assert all(4 * one["wholes"] <= one["messages"] for one in told), told
    lazy.close()


def test_take(wall, address):
    with OpenPage(width=360, height=640) as phone:
        ready_s = phone.go(address)
        numbers = phone.call("frames")
        assert len(numbers) > 5 and phone.run("return window.carom.about().live") is None
        at_s = "return Number(document.querySelector('.bar input').value)"
        began_s = phone.run(at_s)
        phone.until(f"{at_s.replace('return', 'return -' + str(began_s) + ' +')} > 0.5")
        assert not phone.call("observer", {"beta": [0.3, 0, 0], "position_m": [0, -2, 1], "t_s": 2})["held"]
        phone.screenshot(shots / "take-home.png")
        strange = {url for url in phone.requested("http:") if not url.startswith("data:")} - {address}
        assert not strange, strange
    print(f"take home: a phone opens {address.rsplit('/', 1)[0]}/…, ready after {ready_s:.1f} s, {len(numbers)} frames; calls nobody else")
    return numbers


def test_codes(wall, first, second):
    path = urllib.parse.urlsplit(first).path
    pages = [wall.get(urllib.parse.urlsplit(address).path, "127.0.0.1") for address in (first, second)]
    assert [status for status, _ in pages] == [200, 200] and pages[0][1] != pages[1][1]
    for guess in range(10):
        status, _ = wall.get(f"/take/GUESS{guess:03}", "127.0.0.9")
        assert status == 404, status
    silence, words = wall.get(path, "127.0.0.9")
    assert silence == 429 and b"minute" in words, (silence, words)
    assert wall.get(path, "127.0.0.1")[0] == 200
    print("codes: each gives its own game; after ten guesses also the right one gives:", words.decode())


session = Wall()
try:
    with OpenPage(width=360, height=640) as opened:
        test_three_orders(opened, session)
        session.restart()
        taken = session.offered()
        shutil.copy(session.picture(), shots / "wall-offers.png")
        opened.driver.switch_to.window(opened.driver.window_handles[0])
        until(lambda: opened.run("return window.carom ? window.carom.about().live : 0") == 1, "the page of the next game")
        opened.until("return window.carom.about().known_s > 6")
    shown = test_take(session, taken)
    session.restart()
    other = session.offered(taken)
    test_codes(session, taken, other)
finally:
    session.process.send_signal(signal.SIGTERM)
    session.process.wait(60)
print("the session:", (out / "stderr").read_text().strip().splitlines()[-1])
