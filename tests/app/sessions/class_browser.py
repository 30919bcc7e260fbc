"""class_browser.py CAROM OUT SHOTS: see class_browser.sh."""

import asyncio
import json
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import threading
import time

from selenium.webdriver.common.keys import Keys

from browser_page import BrowserPage, close_all
from class_phones import Phone

carom, out, shots = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
pictures = out / "pictures"
shots.mkdir(parents=True, exist_ok=True)

class Page(BrowserPage):
    """A page of a phone or of the teacher."""

    def text(self, part):
        return self.run("return document.getElementById(arguments[0]).innerText", part)

    def phase(self, words):
        self.until(lambda: self.text("phase") == words, words)

    def vote(self, answer, sure=2, reason=""):
        """Votes with the keyboard alone."""
        self.tab_to("at.name === 'answer'")
        self.choose(answer)
        self.press(Keys.TAB)
        self.tab_to("at.name === 'sure'")
        self.choose(sure)
        self.tab_to("at.id === 'reason'")
        if reason:
            self.press(reason)
        self.tab_to("at.id === 'send'")
        self.press(Keys.ENTER)
        self.until(lambda: "Counted" in self.text("said"), "the vote is counted")

    def choose(self, number):
        self.press(Keys.SPACE)
        for _ in range(8):
            if self.run("return document.activeElement.checked && document.activeElement.value == arguments[0]", number):
                return
            self.press(Keys.ARROW_DOWN)
        raise AssertionError(f"no choice {number}")

    def step(self, name):
        """Presses a button of the teacher with the keyboard alone."""
        self.until(lambda: self.run("return !document.querySelector(`button[value=${arguments[0]}]`).disabled", name), name)
        self.tab_to(f"at.value === '{name}'")
        self.press(Keys.ENTER)


class Wall:
    """The session, whose wall is captured."""

    def __init__(self):
        self.process = subprocess.Popen(
            [carom, "cave", "--rig", out / "room.toml", "--scenario", "seen-at-once", "--silent", "--capture", pictures,
             "--session", out / "class.db", "--class", "--class-address", "127.0.0.1", "--class-port", "0"],
            stdout=subprocess.PIPE, stderr=open(out / "stderr", "w"), text=True)
        found = re.fullmatch(r"class: (\S+) (\S+) teacher (\d{6})\n", self.process.stdout.readline())
        self.address, self.word, self.pin = found.groups()

    def picture(self):
        """The newest picture that is whole."""
        for _ in range(300):
            files = sorted(pictures.glob("*.png")) if pictures.exists() else []
            if len(files) > 3:
                return files[-2]
            time.sleep(0.1)
        raise AssertionError("no picture of the wall")

    def shot(self, name):
        before = self.picture()
        for _ in range(100):
            if int(re.search(r"(\d+)\.png", self.picture().name)[1]) > int(re.search(r"(\d+)\.png", before.name)[1]) + 6:
                break
            time.sleep(0.1)
        shutil.copy(self.picture(), shots / f"wall-{name}.png")
        for old in sorted(pictures.glob("*.png"))[:-8]:
            old.unlink()

    def read(self):
        """The address in the QR code on the wall."""
        return subprocess.run(["zbarimg", "-q", "--raw", self.picture()], capture_output=True, text=True).stdout.strip()


class Scripted:
    """Phones without a browser, in a loop of their own."""

    def __init__(self, address, count):
        self.loop = asyncio.new_event_loop()
        threading.Thread(target=self.loop.run_forever, daemon=True).start()
        self.phones = [self.do(Phone(address).join()) for _ in range(count)]

    def do(self, work):
        return asyncio.run_coroutine_threadsafe(work, self.loop).result(30)

    def vote(self, round_, answers):
        for phone, answer in zip(self.phones, answers):
            self.do(phone.state("vote", round_))
            self.do(phone.say({"answer": answer, "confidence": 2, "round": round_}))
            self.do(phone.until(lambda told, answer=answer: told.get("yours") == answer))
            assert "counts" not in phone.told


def votes_in_file():
    text = subprocess.run([carom, "answers", out / "class.db"], capture_output=True, text=True).stdout
    return "vote 1" in text


def lesson(wall):
    faults = []
    address = wall.read()
    assert address == wall.address, f"the wall says {address!r}, the session {wall.address!r}"
    phones = [Page(f"phone-{number}", address, out, shots) for number in range(3)]
    ready = max(page.ready_s for page in phones)
    assert wall.word in phones[0].text("now") + phones[0].run("return document.querySelector('h1').innerText")
    tokens = {page.run("return localStorage.getItem('carom-class-token')") for page in phones}
    scripted = Scripted(address, 2)
    teacher = Page("teacher", address + "teacher", out, shots, 360, 800)
    teacher.shot("teacher-enter")
    teacher.tab_to("at.id === 'pin'")
    teacher.press("000000", Keys.ENTER)
    teacher.until(lambda: "not the PIN" in teacher.text("refused"), "a wrong PIN")
    teacher.press(wall.pin, Keys.ENTER)
    teacher.until(lambda: teacher.run("return !document.getElementById('steps').hidden"), "the teacher is in")
    teacher.until(lambda: "5" in teacher.text("count"), "five phones have joined")
    tokens |= {page.run("return localStorage.getItem('carom-class-token')") for page in phones}
    tokens.discard(None)
    assert len(tokens) == 3, tokens
    phones[0].phase("Wait for the question")

    def shoot(state):
        phones[0].shot("phone-" + state)
        teacher.shot("teacher-" + state)
        wall.shot(state)

    def unseen():
        """No distribution is in a page, in the page's memory, or in what reads the journal."""
        for page in [*phones, teacher]:
            assert not page.run("return document.querySelectorAll('.bar').length"), "bars in an open vote"
            assert not page.run("return 'counts' in state"), "counts in an open vote"

    shoot("idle")
    teacher.step("ask")
    for page in phones:
        page.phase("Vote 1 of 2")
    shoot("vote-1-open")
    faults += phones[0].faults("phone-vote")
    phones[0].vote(1)
    phones[0].vote(2, 3, "light is late <script>alert(1)</script>")  # changes their mind
    phones[1].vote(3)
    phones[2].vote(2)
    scripted.vote(1, [1, 1])
    teacher.until(lambda: teacher.text("count").startswith("5 of 5"), "five have answered")
    unseen()
    assert not votes_in_file(), "votes in the session file before the vote is closed"
    shoot("vote-1")
    phones[2].driver.refresh()  # reloads, and is back with its answer
    begun = time.monotonic()
    phones[2].until(lambda: "Counted" in phones[2].text("said"), "back with its answer")
    back_s = time.monotonic() - begun
    assert back_s < 3.0, back_s
    assert "<script>alert(1)</script>" in teacher.text("reasons"), "a reason is text"
    teacher.step("close")
    phones[0].phase("Vote 1 is closed")
    phones[0].until(lambda: phones[0].run("return document.querySelectorAll('.bar').length") > 1, "bars")
    assert "40 % right" in teacher.text("hint") or "% right" in teacher.text("hint"), teacher.text("hint")
    shoot("closed-1")
    teacher.step("discuss")
    phones[0].phase("Discuss it with your neighbours")
    shoot("discuss")
    teacher.step("again")
    phones[0].phase("Vote 2 of 2")
    for page, answer in zip(phones, (2, 2, 2)):
        page.vote(answer, 4)
    scripted.vote(2, [2, 1])
    teacher.until(lambda: teacher.text("count").startswith("5 of 5"), "five have answered again")
    unseen()
    shoot("vote-2")
    teacher.step("close")
    phones[0].phase("Vote 2 is closed")
    faults += phones[0].faults("phone-closed-2")
    faults += teacher.faults("teacher-closed-2")
    shoot("closed-2")
    teacher.step("show")
    phones[0].phase("Watch the wall")
    time.sleep(1.5)
    assert wall.read() == address, "the small code is read as well"
    shoot("shown")
    teacher.step("explain")
    phones[0].phase("The explanation")
    assert phones[0].run("return document.querySelectorAll('.mark').length") == 1
    faults += phones[0].faults("phone-explained")
    time.sleep(1.0)
    shoot("explained")
    before = phones[0].text("lesson")
    teacher.step("next")
    phones[0].phase("Wait for the question")
    phones[0].until(lambda: phones[0].text("lesson") != before, "the next lesson")
    time.sleep(1.5)
    shoot("next")
    own = ("data:", "chrome:", address, address.replace("http", "ws"))  # chrome: the browser's own first page
    foreign = {url for page in [*phones, teacher] for url in page.requested() if not url.startswith(own)}
    assert not foreign, f"asked for from elsewhere: {foreign}"
    assert not faults, "\n".join(faults)
    assert votes_in_file()
    print(f"pages ready within {ready:.2f} s, a reloaded one back within {back_s:.2f} s; no fault in any page")


wall = Wall()
try:
    lesson(wall)
finally:
    close_all()
    wall.process.send_signal(signal.SIGTERM)
    wall.process.wait(60)
