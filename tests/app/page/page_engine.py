"""page_engine.py CAROM OUT: see page_engine.sh. What the wasm of a page plays is what `carom simulate` plays, bit for bit;
what it sees is what `carom observe` sees; hostile words, cut pages and browsers without WebGL 2 are borne. All in one browser;
with CAROM_PAGE_FRAMES set, also what takes minutes where there is no card."""

import json
import math
import os
import pathlib
import random
import shutil
import subprocess
import sys
import time

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.actions.action_builder import ActionBuilder
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
from selenium.webdriver.common.keys import Keys

from chromium_page import OpenPage, UNDRAWN, content
from page_engine_frames import in_board_axes

carom, out = sys.argv[1], pathlib.Path(sys.argv[2])
SEED = 20261127
THOROUGH = "CAROM_PAGE_FRAMES" in os.environ
HOSTILE = ["</script><script>document.title='taken'</script>", 'a"b', "]]>", "\u202eabc", "白球"]


def ask(*arguments):
    return json.loads(subprocess.run([carom, *map(str, arguments), "--json", "-"], check=True, capture_output=True).stdout)


def make(source, page, *options):
    subprocess.run([carom, "page", source, "-o", page, *map(str, options)], check=True, capture_output=True)
    return page


SCENARIO = """title = {title}
light_speed_m_s = 1.42
[board]
length_m = 2.84
width_m = 1.42
[physics]
puck_restitution = 0.95
cushion_restitution = 0.9
friction_m_s2 = 0.01
"""
LESSON = """[lesson]
question = {words}
answers = [{words}, "No"]
right = 1
todo = {words}
notice = {words}
number = {words}
from_s = 0.0
until_s = 4.0
moment_s = 2.0
[observer]
position_m = [0.0, -2.0, 0.0]
"""
PUCK = """[[puck]]
name = {name}
radius_m = 0.06
height_m = 0.04
mass_kg = 0.2
position_m = [{x}, {y}]
beta = [0.0, 0.0]
"""


def scenario(file, title, names, strokes=()):
    words = json.dumps(title, ensure_ascii=False)
    text = SCENARIO.format(title=words) + LESSON.format(words=words)
    for i, name in enumerate(names):
        text += PUCK.format(name=json.dumps(name, ensure_ascii=False), x=-1.0 + 0.4 * i, y=0.3 * (-1) ** i)
    for stroke in strokes:
        text += f'[[stroke]]\nat_s = {stroke["at_s"]!r}\npuck = {json.dumps(stroke["puck"])}\nmomentum_kg_m_s = {stroke["p"]!r}\n'
    file.write_text(text)
    return file


def test_physics_and_words(page):
    random.seed(SEED)
    strokes = [{"at_s": 1.4 * i + random.random(), "puck": random.choice(HOSTILE),
                "p": [random.uniform(-0.25, 0.25), random.uniform(-0.25, 0.25)]} for i in range(20)]
    title = '</script>"]]>\u202e白球<!--'
    bare, struck = scenario(out / "bare.toml", title, HOSTILE), scenario(out / "struck.toml", title, HOSTILE, strokes)
    told = ask("simulate", struck, "--until", 30)["collisions"]
    page.open(UNDRAWN, make(bare, out / "bare.html", "--until", 1))
    assert page.run("return document.title") == "failed" and page.run("return document.querySelector('h1').textContent") == title
    names = page.run("return [...document.querySelectorAll('option')].map(one => one.textContent).join('|')")
    assert all(name in names for name in HOSTILE), names
    assert page.run("return document.getElementsByTagName('script').length") == 3
    assert page.call("about")["lesson"]["question"] == title
    print("words: hostile names, titles and lessons are words")

    given = [[HOSTILE.index(s["puck"]), s["at_s"], 0, 0, 0, 0, *s["p"], 0] for s in strokes]
    played = page.call("play", 30, given)
    expected = {(turn["puck"], turn["t_s"], *turn["r_m"], *turn["beta_after"], turn["proper_time_s"])
                for event in told for turn in event["turns"]}
    found = {(HOSTILE[int(turn["puck"])], turn["event"][0], *turn["event"][1:3], *turn["beta"], turn["properTime_s"])
             for event in played if event["kind"] in (0, 1, 4) for turn in event["turns"]}
    late = {turn for turn in found - expected if turn[1] > 30}
    missing, more = expected - found, found - expected - late
    print(f"physics: {len(expected)} turns after 20 strokes in 30 s, {len(missing)} missing, {len(more)} other (seed {SEED})")
    assert len(expected) > 50 and not missing, sorted(missing)[:3]
    assert all(turn[1] > 29 for turn in more), sorted(more)[:3]


def test_sight(page):
    random.seed(SEED)
    worst = worst_twin = worst_card = 0.0
    count = 0
    names = ["white", "yellow", "red"]
    for _ in range(4 if THOROUGH else 2):
        t_s, place = random.uniform(0.5, 12), [random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(0.2, 1.5)]
        beta = [random.uniform(-0.5, 0.5) for _ in range(3)]
        at = page.call("observer", {"beta": beta, "position_m": place, "t_s": t_s})
        assert not at["held"], at
        points = [[random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), random.uniform(-0.01, 0.01)] for _ in range(3)]
        for name in names:
            body = page.call("body", name)
            seen = page.call("engine", None, "mono", body, points)
            twin, card = page.call("twin", None, "mono", body, points), page.call("seen", None, "mono", body, points)
            asked = ask("observe", "three-pucks", "--event", t_s, *place, "--beta", *beta,
                        *[word for point in points for word in ("--point", name, *point)])["points"]
            for mine, other, drawn, told in zip(seen, twin, card, asked):
                turned = in_board_axes(at["headFromBoard"], beta, mine)
                worst = max(worst, math.dist(turned, told["seen_m"]))
                worst_twin = max(worst_twin, math.dist(other, mine))
                worst_card = max(worst_card, math.dist(drawn, other))
                count += 1
    print(f"sight: {count} points of observers up to 0.87 c: engine - carom observe {worst:.2g} m, kernel - engine "
          f"{worst_twin:.2g} m, graphics card - kernel {worst_card:.2g} m")
    assert count >= 18 and worst < 1e-12 and worst_twin < 1e-9 and worst_card < 1e-5


def test_held(page):
    late = page.call("observer", {"beta": [0, 0, 0], "position_m": [0, -2, 1], "t_s": 1e6})
    fast = page.call("observer", {"beta": [2, 0, 0], "position_m": [0, -2, 1], "t_s": 3})
    known_s = page.call("about")["known_s"]
    assert late["held"] and late["event"][0] == known_s, late
    assert fast["held"] and abs(fast["headFromBoard"][0] - 1 / math.sqrt(1 - 0.999**2)) < 1e-9, fast
    print(f"held: an observer at 1e6 s at {late['event'][0]:.3f} s, one at 2 c at 0.999 c")


def covering(variants):
    """Returns few of the variants, among which are every sort of legs with every paint, and every state of the effects."""
    chosen, had = [], set()
    for key in variants:
        legs, paint, effects, moment = key.split("/")
        has = {(legs, paint, moment), effects}
        if has - had:
            chosen.append(key)
            had |= has
    return chosen


def test_programs(page):
    """Each text by a compiler of its own; in the browser, which takes a tenth of a second for each, by default few of
    them."""
    shaders = content(out / "page.html")[0]["shaders"]
    variants, folder = shaders["variants"], out / "shaders"
    assert len(variants) > 100
    folder.mkdir()
    texts = {(ending, "".join(shaders["parts"][part] for part in parts))
             for pair in variants.values() for ending, parts in zip(("vert", "frag"), pair)}
    files = [folder / f"{i}.{ending}" for i, (ending, _) in enumerate(texts)]
    for file, (_, text) in zip(files, texts):
        file.write_text(text)
    validator = shutil.which("glslangValidator")
    if validator:
        found = subprocess.run([validator, *files], capture_output=True, text=True)
        assert found.returncode == 0, found.stdout[-2000:]
    chosen = list(variants) if THOROUGH or not validator else covering(variants)
    A_LOT = 4  # a call is given up after minutes
    linked = sum(page.call("programs", chosen[first : first + A_LOT]) for first in range(0, len(chosen), A_LOT))
    assert linked == len(chosen)
    print(f"programs: {len(texts)} texts of {len(variants)} variants are valid, {len(chosen)} variants linked by the browser")


def said_with_picture(page):
    """What the page says has failed; the still picture is there."""
    assert page.run("return document.getElementById('still').getBoundingClientRect().height") > 50
    return page.run("return document.getElementById('sorry').innerText")


def test_trap(page):
    page.run("try { window.carom.seen(0, 'mono', 1e6, [[0, 0, 0]]); } catch (error) { /* as expected */ }")
    said = said_with_picture(page)
    assert "failed" in said, said
    print(f"broken: the engine traps: {said}")


def test_broken(page):
    whole = (out / "page.html").read_bytes()
    (out / "cut.html").write_bytes(whole[: len(whole) * 9 // 10])
    page.open(file=out / "cut.html")
    said = said_with_picture(page)
    assert "cut off" in said, said
    print(f"broken: a page cut at 90 %: {said}")
    page.without_webgl()
    page.open(file=out / "page.html")
    said = said_with_picture(page)
    assert "WebGL 2" in said, said
    print(f"broken: no WebGL 2: {said}")


def test_no_card():
    with OpenPage(out / "page.html", flags=("--disable-3d-apis",)) as page:
        page.open()
        assert "WebGL 2" in said_with_picture(page)


def test_visit(page):
    """Somebody who was not there tries all there is, by pointer and keys; the page fails nowhere and calls nobody."""
    page.requested()  # by the pages before
    page.open(file=out / "page.html")
    driver = page.driver
    canvas = driver.find_element("id", "picture")
    page.until("return window.carom.where(1) !== null")
    page.run("document.querySelector('.menu').hidden = true")  # it lies over the picture of a small window
    ActionChains(driver).drag_and_drop_by_offset(canvas, 40, 20).perform()
    ActionChains(driver).scroll_from_origin(ScrollOrigin.from_element(canvas), 0, 200).perform()
    for key in (" ", " ", Keys.ARROW_LEFT, Keys.ARROW_RIGHT, "h", "h"):
        ActionChains(driver).send_keys_to_element(canvas, key).perform()
    page.run("document.querySelector('.menu').hidden = false")
    for select in driver.find_elements("css selector", "select"):
        for value in range(len(select.find_elements("tag name", "option"))):
            page.run("arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('change'))", select, value)
            time.sleep(0.05)
            for key in "wasd":
                ActionChains(driver).send_keys_to_element(canvas, key).perform()
    for box in driver.find_elements("css selector", ".check input"):
        for _ in range(2):
            page.run("arguments[0].click()", box)
            time.sleep(0.05)
    page.run("const slider = document.querySelector('input[type=range]'); slider.value = 5; slider.dispatchEvent(new Event('input'))")
    page.until("return document.querySelectorAll('.events li').length > 0")
    assert page.run("return document.getElementById('sorry').hidden"), page.log()
    strange = {url for url in page.requested() if not url.startswith("data:")} - {f"file://{page.file}"}
    assert not strange, strange
    print("visit: every control was used; nobody was called")


def test_stroke(page):
    """Aims and pulls by the browser's own pointer events: the line to aim by is shown, and the stroke arrives."""
    page.requested()  # by the pages before
    page.open(file=out / "page.html")
    page.until("return window.carom.where(1) !== null")
    page.run("document.querySelector('.menu').hidden = true; document.querySelector('.key').click()")
    names = ["white", "yellow", "red"]
    places = {name: [round(of) for of in page.run("return window.carom.where(arguments[0]).at", page.call("body", name))] for name in names}
    name = min(names, key=lambda one: math.dist(places[one], (200, 120)))  # the nearest to the window's middle
    (x, y), body = places[name], page.call("body", name)
    pull = -30 if y > 120 else 30
    struck = f"return [...document.querySelectorAll('.events li')].filter(one => one.textContent.includes('{name} is struck')).length"
    assert page.run(struck) == 0
    pulls = ActionBuilder(page.driver)
    pulls.pointer_action.move_to_location(x, y).pointer_down().move_to_location(x + 10, y + pull).pause(0.1)
    pulls.perform()
    aim = page.run("""const line = document.querySelector('.aim.shown line');
      return line && ['x1', 'y1', 'x2', 'y2'].map(name => Number(line.getAttribute(name)))""")
    assert aim and max(abs(aim[0] - x), abs(aim[1] - y)) < 44 and aim[2:] == [x + 10, y + pull], (aim, x, y)
    lets_go = ActionBuilder(page.driver)
    lets_go.pointer_action.pointer_up()
    lets_go.perform()
    assert not page.run("return document.querySelector('.aim.shown')")
    page.until(f"{struck} > 0")
    from_x, from_y, _ = page.run(f"return window.carom.where({body}).onBoard")
    page.until(f"const [x, y] = window.carom.where({body}).onBoard; return Math.hypot(x - {from_x}, y - {from_y}) > 0.02")
    strange = {url for url in page.requested() if not url.startswith("data:")} - {f"file://{page.file}"}
    assert not strange, strange
    print(f"stroke: {name} is pulled by a pointer, and struck; nobody was called")


def test_lost_context(page):
    page.open(file=out / "page.html")
    lit = """const gl = document.getElementById('picture').getContext('webgl2'), at = new Uint8Array(4);
      let sum = 0;
      for (let x = 1; x < 10; ++x) { gl.readPixels(gl.drawingBufferWidth * x / 10, gl.drawingBufferHeight / 2, 1, 1, gl.RGBA,
        gl.UNSIGNED_BYTE, at); sum += at[0] + at[1] + at[2]; }
      return sum > 100"""
    page.until(lit)
    page.run("""const gl = document.getElementById('picture').getContext('webgl2').getExtension('WEBGL_lose_context');
      gl.loseContext(); setTimeout(() => gl.restoreContext(), 300);""")
    page.until("return document.getElementById('picture').getContext('webgl2').isContextLost()")
    page.until("return !document.getElementById('picture').getContext('webgl2').isContextLost()")
    page.until(lit)
    assert page.run("return document.getElementById('sorry').hidden")
    print("broken: a lost context came back")


def test_said(page):
    """The page that is open says why an observer is held."""
    says = "return document.querySelector('.says').textContent.includes(arguments[0])"
    for observer, words in (({"beta": [0, 0, 0], "position_m": [0, -2, 1], "t_s": 1e6}, "The recording ends here"),
                            ({"beta": [2, 0, 0], "position_m": [0, -2, 1], "t_s": 3}, "faster than 0.999")):
        page.call("observer", observer)
        page.until(says.replace("arguments[0]", json.dumps(words)))
    print("held: said on the page")


with OpenPage() as opened:
    test_physics_and_words(opened)
    opened.open(UNDRAWN, out / "page.html")
    for test in (test_sight, test_held, test_programs, *([test_visit] if THOROUGH else []), test_stroke, test_lost_context, test_said, test_trap, test_broken):
        begun = time.monotonic()
        test(opened)
        print(f"  {time.monotonic() - begun:.1f} s")
if THOROUGH:
    test_no_card()
