#!/usr/bin/env python3
"""page_figures.py CAROM [MINUTES]: what pages cost. Sizes and times of making them; in a browser the first picture, a look of ten
bodies, JavaScript a frame without drawing, and memory while the page plays for so long (by default 10 minutes). Needs a display
(tests/with_display) and the packages of config/packages-browser.txt. Times hold for a computer that does nothing else."""

import base64
import gzip
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

here = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(here / "app/page"))
from chromium_page import OpenPage

carom, MINUTES = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 10.0
SCRIPTS = here.parent / "app/page/pages"
TEN = """title = "Ten"
light_speed_m_s = 1.42
[board]
length_m = 2.84
width_m = 1.42
[physics]
puck_restitution = 1.0
cushion_restitution = 1.0
[observer]
position_m = [0.0, -2.0, -0.75]
""" + "".join(f"""[[puck]]
name = "{number}"
radius_m = 0.05
height_m = 0.03
mass_kg = 0.2
position_m = [{-1.1 + 0.5 * (number % 5)}, {0.3 - 0.6 * (number // 5)}]
beta = [{0.6 - 0.13 * number}, {0.3 - 0.05 * number}]
""" for number in range(10))


def made(source, page, *options):
    begun = time.monotonic()
    subprocess.run([carom, "page", source, "-o", page, *options], check=True, capture_output=True)
    return time.monotonic() - begun


def metrics(page):
    return {one["name"]: one["value"] for one in page.driver.execute_cdp_cmd("Performance.getMetrics", {})["metrics"]}


def engine_size(page):
    letters = page.read_text().split('id="engine"', 1)[1].split(">", 1)[1].split("<", 1)[0]
    packed = base64.b64decode(letters)
    return len(gzip.decompress(packed)), len(packed)


def look_ms(page):
    """Milliseconds of a look at all bodies by the engine in the page, halfway through the game."""
    scripts = "".join((SCRIPTS / f"{name}.js").read_text() for name in ("engine", "data", "room"))
    return page.driver.execute_async_script(scripts + """
      const done = arguments[arguments.length - 1];
      Promise.all([Content.load(lettersIn("visit")), Engine.load(lettersIn("engine"))]).then(([content, engine]) => {
        const known = new Known(content, engine), frames = new Frames(content), times = [];
        known.goToEnd();
        for (let round = 0; round < 40; ++round) {
          const begun = performance.now();
          for (let i = 0; i < 50; ++i) {
            const frame = frames.stored((i * frames.count / 50) | 0);
            engine.look(frame.eyes.mono.event, frame.headFromBoard, 7, 0);
          }
          times.push((performance.now() - begun) / 50);
        }
        done(times.sort((a, b) => a - b)[20]);
      })""")


def counting_frames(page):
    page.without_drawing()
    page.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": """
      window.shownFrames = 0;
      const ask = window.requestAnimationFrame.bind(window);
      window.requestAnimationFrame = work => ask(ms => { ++window.shownFrames; work(ms); });"""})


def memory_mb(page):
    page.driver.execute_cdp_cmd("HeapProfiler.collectGarbage", {})
    held = metrics(page)["JSHeapUsedSize"]
    processes = subprocess.run(["ps", "-eo", "rss,args"], capture_output=True, text=True).stdout.splitlines()
    largest = max(int(one.split()[0]) for one in processes if "--type=renderer" in one and page.profile.name in one)
    return held / 1e6, largest / 1e3


with tempfile.TemporaryDirectory() as folder:
    out = pathlib.Path(folder)
    (out / "ten.toml").write_text(TEN)
    for name, source, options in (("minute", "welcome", ("--until", "60")), ("five minutes", "welcome", ("--until", "300")), ("ten", out / "ten.toml", ())):
        took_s = made(source, out / f"{name}.html", *options)
        print(f"{name}: {(out / f'{name}.html').stat().st_size / 1e6:.2f} MB, made in {took_s:.2f} s")
    whole, packed = engine_size(out / "minute.html")
    print(f"the engine: {whole / 1e3:.0f} kB, compressed {packed / 1e3:.0f} kB")
    with OpenPage(out / "minute.html", 1280, 720) as page:
        shows = "return performance.getEntriesByType('mark').length >= 0 && Boolean(document.querySelector('.facts').textContent)"
        firsts = []
        for _ in range(5):
            page.driver.get("about:blank")
            begun = time.monotonic()
            page.driver.get(f"file://{page.file}")
            page.until("return document.body.classList.contains('ready')")
            page.until(shows)
            firsts.append(time.monotonic() - begun)
    print("first picture after", ", ".join(f"{one:.2f}" for one in firsts), "s")
    with OpenPage(out / "ten.html") as page:
        page.without_drawing()
        page.open()
        print(f"a look at ten bodies: {statistics.median(look_ms(page) for _ in range(3)):.3f} ms")
    with OpenPage(out / "minute.html", 1280, 720) as page:
        counting_frames(page)
        page.driver.execute_cdp_cmd("Performance.enable", {})
        page.open()
        time.sleep(5)
        before, shown = metrics(page)["ScriptDuration"], page.run("return window.shownFrames")
        time.sleep(20)
        spent, frames = metrics(page)["ScriptDuration"] - before, page.run("return window.shownFrames") - shown
        print(f"JavaScript a frame: {1e3 * spent / frames:.2f} ms over {frames} frames")
        ends = time.monotonic() + 60 * MINUTES
        while True:
            heap, process = memory_mb(page)
            print(f"memory {ends - time.monotonic():5.0f} s before the end: {heap:.2f} MB of scripts, {process:.0f} MB of the process", flush=True)
            if time.monotonic() > ends:
                break
            time.sleep(min(60, max(1, ends - time.monotonic())))
            page.run("const play = document.querySelector('.bar button'); if (play.textContent === 'Play') play.click()")
