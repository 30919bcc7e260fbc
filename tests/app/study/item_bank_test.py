"""item_bank_test.py CONFIG: the shipped item bank. Its three forms ask the same: templates, concepts, keys, answers and their
misconceptions agree, while the places of the keys, the sides and the numbers do not. Every number in an answer follows from the
numbers of its question, by the equations of special relativity; so does which answer is the key."""

import math
import pathlib
import re
import sys
import tomllib
from collections import Counter

bank = tomllib.loads((pathlib.Path(sys.argv[1]) / "studies/items.toml").read_text())
items = {(item["id"], item["form"]): item for item in bank["item"]}
failed = False


def fail(*words):
    global failed
    failed = True
    print("FAILED:", *words)


def right(item):
    keys = [answer for answer in item["answer"] if answer.get("right")]
    assert len(keys) == 1, f"{item['id']} {item['form']} has {len(keys)} keys"
    return keys[0]


templates = sorted({name for name, _ in items})
if len(bank["item"]) != 54 or len(items) != 54 or len(templates) != 18:
    fail(f"{len(bank['item'])} items, {len(items)} of them different, of {len(templates)} templates")
for form in "ABC":
    concepts = Counter(item["concept"] for item in bank["item"] if item["form"] == form)
    if len(concepts) != 9 or set(concepts.values()) != {2}:
        fail(f"form {form} has {concepts}")
for name in templates:
    forms = [items[name, form] for form in "ABC"]
    meanings = [{a["id"]: (a.get("right", False), a.get("misconception")) for a in item["answer"]} for item in forms]
    if meanings[0] != meanings[1] or meanings[0] != meanings[2] or len(meanings[0]) != 4:
        fail(f"{name}: the answers of its forms differ: {meanings}")
    if len({item["concept"] for item in forms}) != 1 or not name.startswith(forms[0]["concept"]):
        fail(f"{name} asks for {[item['concept'] for item in forms]}")
    places = [item["answer"].index(right(item)) for item in forms]
    if len(set(places)) != 3:
        fail(f"{name}: the key stands in the places {places}")
    for item in forms:
        if len({answer["text"] for answer in item["answer"]}) != 4:
            fail(f"{name} {item['form']} has two equal answers")
        if any(not answer.get("right") and answer.get("misconception") is None for answer in item["answer"]) and all(
            answer.get("misconception") is None for answer in item["answer"]
        ):
            fail(f"{name} has no answer of a misconception")
for form in "ABC":  # guessing one place all the time gains nothing
    places = Counter(items[name, form]["answer"].index(right(items[name, form])) for name in templates)
    if max(places.values()) > 9:
        fail(f"form {form}: the keys stand in the places {places}")


def speeds(text):
    return [float(number) for number in re.findall(r"([\d.]+) c\b", text)]


def numbers(text):
    return [float(number) for number in re.findall(r"(?<![\w.])(\d+(?:\.\d+)?)(?= (?:c|s|m)\b|$)", text)]


def near(said, value):
    """Whether the number is the value, rounded to the digits that it has."""
    decimals = len(said.partition(".")[2])
    return abs(float(said) - value) <= 0.5 * 10.0**-decimals + 1e-12


VELOCITY = {"A": 0.6, "B": 0.8, "C": 0.96}
GAMMA = {"A": 1.25, "B": 1.67, "C": 3.57}
checked = 0


def check(item, answer, value):
    global checked
    checked += 1
    text = next(a["text"] for a in item["answer"] if a["id"] == answer)
    said = re.findall(r"\d+(?:\.\d+)?", text)
    if len(said) != 1 or not near(said[0], value):
        fail(f"{item['id']} {item['form']}, {answer}: '{text}', expected {value:.5g}")


def has_no_number(item, but=()):
    for answer in item["answer"]:
        if answer["id"] not in but and re.search(r"\d", re.sub(r"[Ee]vent \d", "", answer["text"])):
            fail(f"{item['id']} {item['form']}: a number that nothing checks: {answer['text']}")


for form, v in VELOCITY.items():
    gamma = 1 / math.sqrt((1 - v) * (1 + v))
    if abs(gamma - GAMMA[form]) > 0.005:
        fail(f"gamma of form {form} is {gamma}")
    of = lambda name: items[name, form]
    for name in templates:  # one speed in each scene
        if any(speed != v for speed in speeds(of(name)["question"])):
            fail(f"{name} {form} names another speed: {of(name)['question']}")
    for name in ["second-1", "second-2"]:
        check(of(name), "c-plus-v", 1 + v)
        check(of(name), "c-minus-v", 1 - v)
    check(of("second-1"), "between", 1 + v)
    has_no_number(of("second-1"), ["c-plus-v", "c-minus-v", "between"])
    has_no_number(of("second-2"), ["c-plus-v", "c-minus-v"])
    # Light of a lamp: (c + v) / (1 + v/c) = c, and so is its key.
    assert abs((1 - v) / (1 - v) - 1) < 1e-15 and right(of("second-1"))["id"] == right(of("second-2"))["id"] == "c"
    check(of("dilat-1"), "longer", 1 / math.sqrt(1 - v * v))
    check(of("dilat-1"), "equal", 1)
    check(of("dilat-1"), "shorter", math.sqrt(1 - v * v))
    has_no_number(of("dilat-1"), ["longer", "equal", "shorter"])
    for name in ["contr-1", "contr-2"]:
        assert "100 m" in of(name)["question"]
        check(of(name), "equal", 100)
        check(of(name), "shorter", 100 * math.sqrt(1 - v * v))
    check(of("contr-1"), "longer", 100 / math.sqrt(1 - v * v))
    check(of("contr-1"), "looks", 100)
    check(of("contr-2"), "rules", 100 * math.sqrt(1 - v * v))
    has_no_number(of("contr-1"), ["equal", "shorter", "longer", "looks"])
    has_no_number(of("contr-2"), ["equal", "shorter", "rules"])
    assert right(of("contr-1"))["id"] == "shorter" and right(of("contr-2"))["id"] == "equal"
    # Velocities add by their rapidities.
    together = math.tanh(2 * math.atanh(v))
    assert v < together < 1
    check(of("add-1"), "between", v)
    check(of("add-1"), "double", 2 * v)
    check(of("add-1"), "single", v)
    check(of("add-2"), "sum", together)
    check(of("add-2"), "double", 2 * v)
    has_no_number(of("add-1"), ["between", "double", "single"])
    has_no_number(of("add-2"), ["sum", "double"])
    # Neither caused the other: light needs longer than the time between them; the frame of their simultaneity is slower than c.
    away, later = (float(n) for n in re.search(r"are (\d+) light-seconds .* (\d+) s apart", of("cause-2")["question"]).groups())
    checked += 2
    if not 0 < later / away < 1 or right(of("cause-2"))["id"] != "neither":
        fail(f"cause-2 {form}: {away} light-seconds, {later} s")
    # Both ends are hit at once on the ground: t' = gamma (0 - v L) at the front is earlier.
    if not gamma * (0 - v * 100) < 0 or right(of("simul-2"))["id"] != "front":
        fail(f"simul-2 {form}")
    side = re.search(r"beside the (\w+) lamp", of("simul-1")["question"])[1]
    if side not in next(a["text"] for a in of("simul-1")["answer"] if a["id"] == "near"):
        fail(f"simul-1 {form}: the near lamp is the {side} one")
    for name in set(templates) - {"second-1", "second-2", "dilat-1", "contr-1", "contr-2", "add-1", "add-2"}:
        has_no_number(of(name))
if len({re.search(r"beside the (\w+) lamp", items["simul-1", form]["question"])[1] for form in "ABC"}) != 2:
    fail("simul-1 asks for the same side in each form")
if "UNVALIDATED" not in (pathlib.Path(sys.argv[1]) / "studies/items.toml").read_text() or "unvalidated" not in bank["title"]:
    fail("the bank does not say that it is unvalidated")
print(f"{len(bank['item'])} items, {checked} numbers")
sys.exit(1 if failed or checked < 60 else 0)
