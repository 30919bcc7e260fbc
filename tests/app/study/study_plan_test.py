"""study_plan_test.py CAROM CONFIG: the allocation of `carom study plan` against a second reading of its rules, written here alone:
seeds 1 to 200, two and three arms, 3 to 6 lessons, 48 to 54 people. Counts of arms, orders and forms differ as little as they
can, each lesson stands in each place and follows each other one equally often; the same on each run."""

import hashlib
import itertools
import json
import pathlib
import subprocess
import sys
import tempfile
import time
from collections import Counter

carom, config = sys.argv[1], pathlib.Path(sys.argv[2])
LESSONS = ["seen-at-once", "two-cushions", "light-clock", "train-in-tunnel", "twins", "solid"]
MASK = (1 << 64) - 1


class SplitMix64:
    def __init__(self, seed):
        self.counter = seed

    def draw(self):
        self.counter = (self.counter + 0x9E3779B97F4A7C15) & MASK
        mixed = self.counter
        mixed = ((mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        mixed = ((mixed ^ (mixed >> 27)) * 0x94D049BB133111EB) & MASK
        return mixed ^ (mixed >> 31)

    def below(self, n):
        while True:
            drawn = self.draw()
            if drawn < 2**64 - 2**64 % n:
                return drawn % n

    def shuffled(self, values):
        values = list(values)
        for i in range(len(values) - 1, 0, -1):
            j = self.below(i + 1)
            values[i], values[j] = values[j], values[i]
        return values


assert SplitMix64(0).draw() == 0xE220A8397B1DCDAF  # the published first number
assert SplitMix64(1234567).draw() == 6457827717110365317


def williams(n):
    first, low, high = [0], 1, n - 1
    while len(first) < n:  # 1, n - 1, 2, n - 2, ...
        first.append(low)
        low += 1
        if len(first) < n:
            first.append(high)
            high -= 1
    rows = [[(place + r) % n for place in first] for r in range(n)]
    return rows if n % 2 == 0 else rows + [row[::-1] for row in rows]


def plan(seed, arms, lessons, people, orders="williams", forms="rotate"):
    random = SplitMix64(seed)
    given = []
    while len(given) < people:
        given += random.shuffled(arm for arm in arms for _ in range(2))
    given = given[:people]
    rows = williams(len(lessons))
    result = [{"number": i + 1, "arm": arm, "order_row": 0, "lessons": lessons, "forms": list("ABC")} for i, arm in enumerate(given)]
    for arm in arms:
        members = [one for one in result if one["arm"] == arm]
        if orders == "williams":
            drawn = random.shuffled(itertools.islice(itertools.cycle(range(len(rows))), len(members)))
            for one, row in zip(members, drawn):
                one["order_row"], one["lessons"] = row, [lessons[i] for i in rows[row]]
        if forms == "rotate":
            pairs = random.shuffled(itertools.islice(itertools.cycle(["AB", "BC", "CA", "BA", "CB", "AC"]), len(members)))
            for one, pair in zip(members, pairs):
                one["forms"] = [*pair, *(set("ABC") - set(pair))]
    return result


def check_counts(case, got, arms, lessons):
    for taken in range(1, len(got) + 1):
        counts = Counter(one["arm"] for one in got[:taken])
        assert max(counts.values()) - min(counts.get(arm, 0) for arm in arms) <= 2, f"{case}: the arms after {taken}: {counts}"
    rows = range(len(williams(len(lessons))))
    for arm in arms:
        of_arm = [one for one in got if one["arm"] == arm]
        for key, all_values in [("order_row", rows), ("forms", itertools.permutations("ABC"))]:
            counts = Counter(str(one[key]) for one in of_arm)
            counts = [counts[str(list(value) if key == "forms" else value)] for value in all_values]
            assert sum(counts) == len(of_arm) and max(counts) - min(counts) <= 1, f"{case}: {key} in {arm}: {counts}"


def check_square(n):
    rows = williams(n)
    assert len(rows) == (n if n % 2 == 0 else 2 * n)
    places = Counter((place, lesson) for row in rows for place, lesson in enumerate(row))
    follows = Counter(pair for row in rows for pair in zip(row, row[1:]))
    assert len(places) == n * n and len(set(places.values())) == 1, f"places in the square of {n}"
    assert len(follows) == n * (n - 1) and len(set(follows.values())) == 1, f"neighbours in the square of {n}"


for n in range(2, 12):
    check_square(n)

work = pathlib.Path(tempfile.mkdtemp(prefix="carom-plan-"))
study = work / "study.toml"


def write(seed, arms, lessons, people, more=""):
    text = f'title = "T"\nseed = {seed}\nparticipants = {people}\nlessons = {json.dumps(lessons)}\n{more}'
    text += "".join(f'[[arm]]\nname = "{arm}"\nrig = "desk"\n' for arm in arms)
    study.write_text(text)
    return text


def planned():
    return subprocess.run([carom, "study", "plan", study, "--json", "-"], check=True, capture_output=True, text=True).stdout


bank = (config / "studies/items.toml").read_bytes()
every = int(sys.argv[3]) if len(sys.argv) > 3 else 1
cases = 0
for seed in range(1, 201, every):
    # Each seed takes one of the 2 * 4 * 7 combinations for 200 seeds, in turn: all come three times or more.
    arms = ["first", "second", "third"][: 2 + seed % 2]
    lessons = LESSONS[: 3 + seed // 2 % 4]
    people = 48 + seed // 8 % 7
    text = write(seed, arms, lessons, people)
    case = f"seed {seed}, {len(arms)} arms, {len(lessons)} lessons, {people} people"
    said = planned()
    got = json.loads(said)
    assert list(got) == ["sha256", "participants"], f"{case}: {list(got)}"
    assert got["sha256"] == hashlib.sha256(text.encode() + bank).hexdigest(), f"{case}: another hash"
    wanted = plan(seed, arms, lessons, people)
    assert got["participants"] == wanted, f"{case}: the allocation is another one"
    check_counts(case, got["participants"], arms, lessons)
    if seed < 5:
        assert planned() == said, f"{case}: another plan on the next run"
    cases += 1

# What is fixed draws nothing.
for orders, forms in itertools.product(["williams", "fixed"], ["rotate", "fixed"]):
    write(7, ["a", "b"], LESSONS[:4], 50, f'orders = "{orders}"\nforms = "{forms}"\n')
    assert json.loads(planned())["participants"] == plan(7, ["a", "b"], LESSONS[:4], 50, orders, forms), f"{orders} {forms}"
# The smallest studies.
for arms, lessons, people in [(["a"], LESSONS[:1], 1), (["a"], LESSONS[:2], 3), (["a", "b", "c"], LESSONS[:1], 2)]:
    write(3, arms, lessons, people)
    assert json.loads(planned())["participants"] == plan(3, arms, lessons, people), f"{arms} {lessons} {people}"

write(1, ["a", "b"], LESSONS, 1000)
started = time.monotonic()
planned()
print(f"{cases} plans agree; one of 1000 people took {time.monotonic() - started:.2f} s")
