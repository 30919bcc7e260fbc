"""study_browser.py CAROM OUT SHOTS: see study_browser.sh."""

import contextlib
import pathlib
import re
import signal
import sqlite3
import subprocess
import sys

from browser_page import BrowserPage, close_all

carom, out, shots = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
shots.mkdir(parents=True, exist_ok=True)
study, slips, session = out / "study.toml", out / "slips.csv", out / "day.db"
study.write_text("""title = "Standing or walking"
seed = 1
participants = 1
lessons = ["light-clock"]
reasons = true
[[arm]]
name = "one"
rig = "room.toml"
""")


class Tablet(BrowserPage):
    """A tablet with the pages of the study: a person taps what they read."""

    def title(self):
        return self.run("return document.querySelector('h1') ? document.querySelector('h1').innerText : document.body.innerText")

    def tap(self, name):
        """Taps a button, and waits for the page that comes."""
        self.run("document.documentElement.dataset.old = 'yes'")
        self.run("document.querySelector(`button[name=go][value=${arguments[0]}]`).click()", name)
        self.until(lambda: self.run("return document.readyState === 'complete' && !document.documentElement.dataset.old"), "the next page")

    def mark(self, field, value):
        self.run("document.querySelector(`input[name='${arguments[0]}'][value='${arguments[1]}']`).click()", field, value)

    def first_answers(self):
        """Takes the first of each group of answers."""
        self.run("for (const group of document.querySelectorAll('fieldset')) group.querySelector('input').click()")

    def shows_text(self, words):
        self.until(lambda: self.run("return document.readyState === 'complete' && document.body.innerText.includes(arguments[0])", words), words)

    def shows(self, title):
        assert self.title() == title, f"{title}: {self.run('return document.body.innerText')}"


def rows(sql):
    with contextlib.closing(sqlite3.connect(f"file:{session}?mode=ro", uri=True, timeout=10)) as database:
        return database.execute(sql).fetchall()


def take_part(tablet, code):
    """From the slip to the end of the study; returns what is wrong with the pages as they are shown."""
    faults = tablet.faults("1-code")
    tablet.driver.find_element("id", "code").send_keys(code.lower())
    tablet.tap("code")
    tablet.shows("Before you begin")
    faults += tablet.faults("2-consent")
    tablet.mark("part", "yes")
    tablet.tap("next")
    tablet.shows("About you")
    faults += tablet.faults("3-background")
    tablet.first_answers()  # under 18
    tablet.tap("next")
    tablet.shows("Before you begin")
    tablet.shows_text("consent of a parent or guardian on paper is needed")
    faults += tablet.faults("3-guardian")
    tablet.mark("part", "yes")
    tablet.mark("guardian", "yes")
    tablet.tap("next")
    tablet.first_answers()
    tablet.tap("next")
    take_test(tablet, faults, "4-before")
    tablet.mark("unwell-before", "0")
    faults += tablet.faults("5-unwell")
    tablet.tap("rate")
    tablet.until(lambda: rows("SELECT 1 FROM participation"), "the lesson in the room")
    tablet.driver.refresh()  # a form that is sent twice does nothing twice
    faults += tablet.faults("6-in-the-room")
    tablet.tap("next")
    tablet.shows("Go on all the same?")
    faults += tablet.faults("7-not-explained")
    tablet.tap("anyway")
    # Back and reload show a page of the study, of this person while they take part, and send no form again.
    text = tablet.run("return document.body.innerText")
    assert "Question 1 of 18" in text, text
    tablet.driver.back()
    tablet.shows_text("Question 1 of 18")
    tablet.driver.refresh()
    tablet.shows_text("Question 1 of 18")
    take_test(tablet, faults, "8-after")
    for rating in "unwell-after", "hard", "there":
        tablet.mark(rating, "1")
    tablet.tap("rate")
    tablet.shows_text("For today this was all")
    tablet.driver.refresh()
    tablet.shows_text("For today this was all")
    # The address of the visit is worth nothing any more: whoever has the tablet next goes back, and the server gives the page that asks
    # for a code. (A browser may show a page from its own memory until it is reloaded.)
    for _ in range(3):
        tablet.driver.back()
        tablet.driver.refresh()
        tablet.shows_text("The code of your slip")
    return faults


def take_test(tablet, faults, name):
    for number in range(1, 19):
        text = tablet.run("return document.body.innerText")
        assert f"Question {number} of 18" in text, text
        tablet.first_answers()
        if number == 2:
            faults += tablet.faults(name)
            tablet.driver.refresh()
        tablet.tap("next")
    faults += tablet.faults(name + "-done")
    tablet.tap("next")


subprocess.run([carom, "study", "codes", study, "-o", slips], check=True, capture_output=True)
code = slips.read_text().split(",")[-1].strip()
room = subprocess.Popen([carom, "cave", "--rig", out / "room.toml", "--study", study, "--slips", slips, "--session", session, "--silent", "--no-window",
                         "--lesson", "shows", "--class-address", "127.0.0.1", "--class-port", "0"], stdout=subprocess.PIPE, text=True)
try:
    address = re.fullmatch(r"study: (http://127\.0\.0\.1:\d+/study)\n", room.stdout.readline())[1]
    tablet = Tablet("tablet", address, out, shots, 820, 1180)
    found = take_part(tablet, code)
    assert not found, "\n".join(found)
finally:
    close_all()
    room.send_signal(signal.SIGTERM)
    room.wait(60)
