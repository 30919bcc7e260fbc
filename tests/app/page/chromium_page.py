"""A page that `carom page` has made, in a headless Chromium of its own, opened as a file."""

import base64
import json
import pathlib
import shutil
import tempfile
import time
import zlib

from selenium import webdriver
from selenium.webdriver.chrome.service import Service


# A picture that no page has: with this hash nothing is drawn, which takes long where there is no card.
UNDRAWN = "#frame=-1"


class OpenPage:
    """One browser, for one page after the other: it takes seconds to start. It draws by OpenGL, for which it needs a display:
    where there is no card, Mesa keeps its shaders from run to run, while the browser's own drawing by the processor makes each
    of them anew for seconds. On a fresh machine they are made for a minute or two, so nothing here is impatient, and the browser
    does not end what draws. The window is small: a picture in motion takes processor from what a test asks meanwhile."""

    def __init__(self, file=None, width=400, height=240, flags=()):
        self.show(file)
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        options = webdriver.ChromeOptions()
        options.binary_location = shutil.which("chromium")
        for flag in ("--headless=new", "--no-sandbox", "--force-device-scale-factor=1", "--disable-dev-shm-usage",
                     "--use-angle=gl", "--ignore-gpu-blocklist", "--enable-unsafe-swiftshader", "--disable-gpu-watchdog",
                     f"--user-data-dir={self.profile.name}",
                     f"--window-size={width},{height}", *flags):
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"performance": "ALL", "browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        self.driver.set_script_timeout(300)
        self.metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 400}
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", self.metrics)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()
        self.profile.cleanup()

    def show(self, file):
        """Sets the page that `open` opens."""
        self.file = pathlib.Path(file).resolve() if file else None

    def open(self, hash="", file=None):
        """Opens the page anew, or another one, and returns after how many seconds it has begun or given up."""
        if file:
            self.show(file)
        return self.go(f"file://{self.file}{hash}")

    def go(self, address):
        """Opens the page of an address."""
        self.driver.get("about:blank")
        begun = time.monotonic()
        self.driver.get(address)
        self.until("return document.body.classList.contains('ready') || !document.getElementById('sorry').hidden")
        return time.monotonic() - begun

    def without_webgl(self):
        """From now on pages find no WebGL 2 here."""
        self.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": """
          const given = HTMLCanvasElement.prototype.getContext;
          HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
            return kind === 'webgl2' ? null : given.call(this, kind, ...more); };"""})

    def without_drawing(self):
        """From now on pages in this tab compute all and draw nothing: where there is no card, drawing takes the processor."""
        self.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": """
          WebGL2RenderingContext.prototype.drawElements = () => {};"""})

    def another_tab(self):
        """Goes on in a tab of its own; the pages of the others stay."""
        self.driver.switch_to.new_window("tab")
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", self.metrics)

    def until(self, script, patience_s=300.0):
        ends = time.monotonic() + patience_s
        while not self.run(script):
            assert time.monotonic() < ends, f"in vain: {script}; the browser says {self.log()}"
            time.sleep(0.02)

    def run(self, script, *values):
        return self.driver.execute_script(script, *values)

    def call(self, name, *values):
        """Calls a function of window.carom."""
        return self.run("return window.carom[arguments[0]](...arguments[1])", name, list(values))

    def log(self):
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def wall(self, frame, wall, eye):
        """Returns a wall's picture, as the bytes of a PNG."""
        self.run("location.hash = arguments[0]", f"#frame={frame}&wall={wall}&eye={eye}&bare")
        self.until("return document.title === 'ready' || document.title === 'failed'")
        assert self.run("return document.title") == "ready", self.log()
        url = self.run("document.title = ''; return document.getElementById('picture').toDataURL()")
        return base64.b64decode(url.split(",", 1)[1])

    def screenshot(self, file):
        self.driver.save_screenshot(str(file))

    def requested(self, of="file:"):
        """The addresses that pages of such addresses have asked for."""
        found = set()
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            # The browser's own first page has requests, too.
            if message["method"] == "Network.requestWillBeSent" and message["params"]["documentURL"].startswith(of):
                found.add(message["params"]["request"]["url"])
            if message["method"] == "Network.webSocketCreated":
                found.add(message["params"]["url"])
        return found


def content(file):
    """Returns the description in a page and the bytes of its columns."""
    text = pathlib.Path(file).read_text()
    letters = text.split('id="visit"', 1)[1].split(">", 1)[1].split("<", 1)[0]
    whole = zlib.decompress(base64.b64decode(letters))
    length = int.from_bytes(whole[:4], "little")
    return json.loads(whole[4 : 4 + length]), whole[4 + length :]
