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

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

from class_phones import Phone

carom, out, shots = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
pictures = out / "pictures"
OPEN = []  # browsers
shots.mkdir(parents=True, exist_ok=True)

# What is wrong with the page as it is shown: contrast (WCAG 2.1, 1.4.3) below 4.5, targets below 44 px, sideways scrolling.
FAULTS = """
const faults = [];
const parts = colour => colour.match(/[\\d.]+/g).map(Number);
const light = ([r, g, b]) => [r, g, b].map(v => v / 255).map(v => v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
  .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
const ground = at => {
  for (; at; at = at.parentElement) {
    const colour = parts(getComputedStyle(at).backgroundColor);
    if (colour.length < 4 || colour[3] > 0) return colour;
  }
  return [255, 255, 255];
};
const shown = at => at.checkVisibility ? at.checkVisibility() : at.offsetParent !== null;
for (const at of document.querySelectorAll("body *")) {
  if (!shown(at) || ![...at.childNodes].some(node => node.nodeType === 3 && node.data.trim())) continue;
  const [a, b] = [light(parts(getComputedStyle(at).color)), light(ground(at))].sort((x, y) => y - x);
  const contrast = (a + 0.05) / (b + 0.05);
  if (contrast < 4.5) faults.push(`${at.tagName} "${at.textContent.trim()}": contrast ${contrast.toFixed(2)}`);
}
for (const at of document.querySelectorAll("button, .choice, textarea, input:not([type=radio])")) {
  if (!shown(at)) continue;
  const box = at.getBoundingClientRect();
  if (box.height < 44 || box.width < 44) faults.push(`${at.tagName} "${at.textContent}": ${box.width} x ${box.height} px`);
}
if (document.documentElement.scrollWidth > innerWidth) faults.push(
  `scrolls sideways: ${document.documentElement.scrollWidth} of ${innerWidth} px`);
return faults;
"""


class Page:
    """A page in a Chromium of its own."""

    def __init__(self, name, address, width=360, height=640):
        options = webdriver.ChromeOptions()
        options.binary_location = shutil.which("chromium")
        for flag in ("--headless=new", "--no-sandbox", "--force-device-scale-factor=1", "--disable-gpu",
                     "--disable-dev-shm-usage", f"--user-data-dir={out / name}"):
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"performance": "ALL"})
        self.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        OPEN.append(self.driver)
        self.size(width, height)
        begun = time.monotonic()
        self.driver.get(address)
        self.ready_s = time.monotonic() - begun

    def requested(self):
        """The addresses that the page has asked for."""
        found = set()
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                found.add(message["params"]["request"]["url"])
            if message["method"] == "Network.webSocketCreated":
                found.add(message["params"]["url"])
        return found

    def size(self, width, height):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                     {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": True})

    def media(self, scheme):
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                     {"features": [{"name": "prefers-color-scheme", "value": scheme}]})

    def run(self, script, *values):
        return self.driver.execute_script(script, *values)

    def text(self, part):
        return self.run("return document.getElementById(arguments[0]).innerText", part)

    def until(self, holds, words, patience_s=20.0):
        ends = time.monotonic() + patience_s
        while not holds():
            assert time.monotonic() < ends, f"{words}: {self.run('return document.body.innerText')}"
            time.sleep(0.05)

    def phase(self, words):
        self.until(lambda: self.text("phase") == words, words)

    def press(self, *keys):
        actions = ActionChains(self.driver)
        for key in keys:
            actions.send_keys(key)
        actions.perform()

    def tab_to(self, script):
        """Presses Tab until this holds of the element that has the focus."""
        for _ in range(40):
            if self.run("const at = document.activeElement; return " + script):
                return
            self.press(Keys.TAB)
        raise AssertionError(f"Tab never reaches {script}: {self.run('return document.activeElement.outerHTML')}")

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
        self.until(lambda: "counted" in self.text("said"), "the vote is counted")

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

    def shot(self, name):
        (shots / f"{name}.png").write_bytes(self.driver.get_screenshot_as_png())

    def faults(self, where):
        """All faults in the light and in the dark, at 360 and 320 px, and with letters twice as large."""
        found = []
        for scheme in "light", "dark":
            self.media(scheme)
            found += [f"{where}, {scheme}: {fault}" for fault in self.run(FAULTS)]
        self.shot(where + "-dark")
        for width, letters in (320, "100%"), (360, "200%"):
            self.size(width, 640)
            self.run("document.documentElement.style.fontSize = arguments[0]", letters)
            found += [f"{where}, {width} px, {letters}: {fault}" for fault in self.run(FAULTS)]
        self.run("document.documentElement.style.fontSize = ''")
        self.size(360, 640)
        self.media("light")
        return found


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
    phones = [Page(f"phone-{number}", address) for number in range(3)]
    ready = max(page.ready_s for page in phones)
    assert wall.word in phones[0].text("now") + phones[0].run("return document.querySelector('h1').innerText")
    tokens = {page.run("return localStorage.getItem('carom-class-token')") for page in phones}
    scripted = Scripted(address, 2)
    teacher = Page("teacher", address + "teacher", 360, 800)
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
    phones[2].until(lambda: "counted" in phones[2].text("said"), "back with its answer")
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
    for driver in OPEN:
        driver.quit()
    wall.process.send_signal(signal.SIGTERM)
    wall.process.wait(60)
