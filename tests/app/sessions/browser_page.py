"""Pages in Chromium: what tests of pages share."""

import json
import shutil
import time

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

OPEN = []  # the drivers of all browsers

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
for (const at of document.querySelectorAll("button, .choice, fieldset label, textarea, input:not([type=radio], [type=checkbox])")) {
  if (!shown(at)) continue;
  const box = at.getBoundingClientRect();
  if (box.height < 44 || box.width < 44) faults.push(`${at.tagName} "${at.textContent}": ${box.width} x ${box.height} px`);
}
if (document.documentElement.scrollWidth > innerWidth) faults.push(
  `scrolls sideways: ${document.documentElement.scrollWidth} of ${innerWidth} px`);
return faults;
"""


class BrowserPage:
    """A page in a Chromium of its own, with its files in `out` and its pictures in `shots`."""

    def __init__(self, name, address, out, shots, width=360, height=640):
        self.shots, self.width, self.height = shots, width, height
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

    def until(self, holds, words, patience_s=20.0):
        ends = time.monotonic() + patience_s
        while not holds():
            assert time.monotonic() < ends, f"{words}: {self.run('return document.body.innerText')}"
            time.sleep(0.05)

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

    def shot(self, name):
        (self.shots / f"{name}.png").write_bytes(self.driver.get_screenshot_as_png())

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
        self.size(self.width, self.height)
        self.media("light")
        return found


def close_all():
    """Ends all browsers."""
    for driver in OPEN:
        driver.quit()
