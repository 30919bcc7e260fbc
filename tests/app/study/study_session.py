"""study_session.py CAROM CONFIG OUT: see study_session.sh."""

import contextlib
import csv
import html.parser
import json
import math
import pathlib
import re
import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
import time
import tomllib
import urllib.error
import urllib.parse
import urllib.request

carom, config, out = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
PEOPLE, LESSONS = 12, ["light-clock", "seen-at-once"]
STUDY = f"""title = "Twelve"
seed = 3
participants = {PEOPLE}
lessons = {json.dumps(LESSONS)}
reasons = true
gender = true
primary = "gain between arms"
keep_until = 2030-01-01
[[arm]]
name = "moving"
rig = "room.toml"
[[arm]]
name = "still"
rig = "room.toml"
head = "still"
switches_off = ["aberration"]
views_off = ["events"]
"""
study, session, slips = out / "study.toml", out / "day.db", out / "slips.csv"
study.write_text(STUDY)
bank = tomllib.loads((config / "studies/items.toml").read_text())["item"]


def run(*words, status=0):
    ended = subprocess.run([carom, *map(str, words)], capture_output=True, text=True)
    assert ended.returncode == status, f"{words}: {ended.returncode} {ended.stdout} {ended.stderr}"
    return ended.stdout + ended.stderr


def query(sql, *values, file=session):
    with contextlib.closing(sqlite3.connect(f"file:{file}?mode=ro", uri=True, timeout=10)) as database:
        return database.execute(sql, values).fetchall()


class Page(html.parser.HTMLParser):
    """The fields of a page's form, and its words."""

    def __init__(self, text):
        super().__init__()
        self.text, self.hidden, self.radios = text, {}, {}
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        of = dict(attributes)
        if tag == "input" and of.get("type") == "hidden":
            self.hidden[of["name"]] = of["value"]
        if tag == "input" and of.get("type") == "radio":
            self.radios.setdefault(of["name"], []).append(of["value"])


class Session:
    def __init__(self, *options, of=(study, slips, session), rig="room.toml"):
        words = ["--study", of[0], "--slips", of[1], "--session", of[2], *([] if "--resume" in options else ["--rig", out / rig])]
        if "--console" not in options:
            words.append("--no-window")
        self.process = subprocess.Popen(
            [carom, "cave", "--silent", "--lesson", "shows", "--class-address", "127.0.0.1", "--class-port", "0", *words, *options],
            stdout=subprocess.PIPE, stderr=open(out / "stderr", "a"), text=True)
        line = self.process.stdout.readline()
        found = re.fullmatch(r"study: (http://127\.0\.0\.1:\d+/study)\n", line)
        assert found, f"the line of the study: {line!r}"
        self.address = found[1]

    def end(self):
        self.process.send_signal(signal.SIGTERM)
        assert self.process.wait(60) == 0

    def send(self, page, **fields):
        body = urllib.parse.urlencode({**(page.hidden if page else {}), **fields}).encode()
        with urllib.request.urlopen(self.address, body, timeout=30) as answer:
            assert answer.headers["Cache-Control"] == "no-store" and "default-src 'none'" in answer.headers["Content-Security-Policy"]
            return Page(answer.read().decode())


def items_of(form):
    return [item for item in bank if item["form"] == form]


def choose(item, number, place, phase):
    """What participant `number` answers: after the lessons they know more."""
    key = next(a["id"] for a in item["answer"] if a.get("right"))
    wrong = [a["id"] for a in item["answer"] if not a.get("right")]
    if (number + place) % 7 == 0:
        return "dont-know"
    return key if (number * 5 + place) % 10 < (3 if phase == "pre" else 7) else wrong[(number + place) % len(wrong)]


REASON = "Write to anna.b@example.org or 0171 / 23 45-678, I am 17"


def take_test(room, page, person, number, phase):
    for place, item in enumerate(items_of(person["forms"][{"pre": 0, "post": 1, "delayed": 2}[phase]])):
        assert f"Question {place + 1} of 18" in page.text, page.text
        assert page.radios["answer"] == [a["id"] for a in item["answer"]] + ["dont-know"]
        page = room.send(page, go="next", answer=choose(item, number, place, phase), confidence=1 + (number + place) % 4,
                         reason=REASON if place == 0 else "")
    assert "You have answered all questions" in page.text, page.text
    return room.send(page, go="next")


def wait_for(what, test, for_s=60):
    until = time.monotonic() + for_s
    while not test():
        assert time.monotonic() < until, f"{what} has not come"
        time.sleep(0.05)


def stop(room, page):
    """Stops: the page asks once."""
    page = room.send(page, go="stop")
    assert "Do you want to stop?" in page.text and "is kept, but left out of the analysis" in page.text, page.text
    page = room.send(page, go="stop-now")
    assert "You have stopped. What you answered so far is kept, but left out of the analysis" in page.text, page.text


def go_on(room, page):
    """Goes on from a lesson that has not explained itself, of which the page asks once."""
    page = room.send(page, go="next")
    assert "The lesson has not explained itself yet" in page.text, page.text
    return room.send(page, go="anyway")


def take_part(room, code, person):
    number = person["number"]
    page = room.send(None, go="code", code=code.lower())
    assert "Before you begin" in page.text, page.text
    page = room.send(page, go="next", part="yes", **({"paths": "yes"} if number % 3 == 0 else {}))
    page = room.send(page, go="next", age_band="18-24", physics_years="1-2", relativity="read", games_hours="0", language="English", gender="woman")
    page = take_test(room, page, person, number, "pre")
    if number == PEOPLE:
        stop(room, page)
        return
    page = room.send(page, go="next", **{"unwell-before": "1"})
    for place, lesson in enumerate(person["lessons"]):
        assert f"Lesson {place + 1} of {len(LESSONS)}" in page.text, page.text
        wait_for(f"lesson {lesson} of {code}", lambda: query("SELECT 1 FROM participation WHERE code = ? AND lesson = ?", code, lesson))
        first = query("SELECT first_frame FROM participation WHERE code = ? AND lesson = ?", code, lesson)[0][0]
        wait_for("a second of it", lambda: (query("SELECT max(display_s) - min(display_s) FROM frame WHERE number >= ?", first)[0][0] or 0) > 0.5)
        page = go_on(room, page)
    page = take_test(room, page, person, number, "post")
    page = room.send(page, go="next", **{"unwell-after": "2", "hard": "4", "there": "7"})
    assert "For today this was all" in page.text, page.text


def rows_of(folder, name):
    with open(folder / name, newline="") as file:
        return list(csv.DictReader(file))


def check_codebook(folder):
    book = rows_of(folder, "codebook.csv")
    assert list(book[0]) == ["file", "name", "type", "unit", "meaning", "allowed"]
    for name in sorted({row["file"] for row in book}):
        columns = [row for row in book if row["file"] == name]
        with open(folder / name, newline="") as file:
            header, *rows = csv.reader(file)
        assert header == [column["name"] for column in columns], f"{name}: {header}"
        for row in rows:
            assert len(row) == len(columns), f"{name}: {row}"
            for value, column in zip(row, columns):
                where = f"{name}, {column['name']}: {value!r}"
                if value and column["type"] == "integer":
                    int(value)
                if value and column["type"] == "number":
                    assert math.isfinite(float(value)), where
                choices = column["allowed"].split("|")
                if len(choices) > 1 and all(re.fullmatch(r"[\w-]*", choice) for choice in choices):
                    assert value in choices, f"{where}, allowed {choices}"
    written = {path.name for path in folder.iterdir() if path.suffix == ".csv"}
    assert written == {row["file"] for row in book} | {"codebook.csv"}, written


def smooth_path(times, places):
    """The path, by another low-pass than the program's: a Gaussian window whose gain at 2 Hz is a half."""
    sigma = math.sqrt(math.log(2) / 2) / math.pi / 2
    count = int((times[-1] - times[0]) * 60) + 1
    even, at = [], 0
    for k in range(count):
        t = times[0] + k / 60
        while at + 2 < len(times) and times[at + 1] <= t:
            at += 1
        share = min(1, max(0, (t - times[at]) / max(1e-9, times[at + 1] - times[at])))
        even.append([a + share * (b - a) for a, b in zip(places[at], places[at + 1])])
    reach = int(4 * sigma * 60)
    weights = [math.exp(-((k / 60 / sigma) ** 2) / 2) for k in range(-reach, reach + 1)]
    even = [[2 * a - b for a, b in zip(even[0], even[k])] for k in range(reach, 0, -1)] + even + [[2 * a - b for a, b in zip(even[-1], even[-1 - k])] for k in range(1, reach + 1)]
    smooth = [[sum(w * even[i + k][axis] for k, w in enumerate(weights)) / sum(weights) for axis in range(3)] for i in range(count)]
    return sum(math.dist(a, b) for a, b in zip(smooth, smooth[1:]))


def turned(quaternion, vector):
    """The vector, turned by Rodrigues' formula: by the angle and about the axis of the quaternion."""
    w, *axis = quaternion
    sine = math.hypot(*axis)
    if sine < 1e-12:
        return list(vector)
    k, angle = [a / sine for a in axis], 2 * math.atan2(sine, w)
    cross = [k[1] * vector[2] - k[2] * vector[1], k[2] * vector[0] - k[0] * vector[2], k[0] * vector[1] - k[1] * vector[0]]
    along = sum(a * b for a, b in zip(k, vector))
    return [v * math.cos(angle) + c * math.sin(angle) + a * along * (1 - math.cos(angle)) for v, c, a in zip(vector, cross, k)]


def apart_deg(a, b):
    """The angle between two directions, from the area that they span."""
    cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    return math.degrees(math.atan2(math.hypot(*cross), sum(x * y for x, y in zip(a, b))))


def solved(columns, right):
    """x of columns · x = right, by Cramer's rule."""
    def det(m):
        return sum(m[i][0] * (m[(i + 1) % 3][1] * m[(i + 2) % 3][2] - m[(i + 2) % 3][1] * m[(i + 1) % 3][2]) for i in range(3))
    rows = [[column[i] for column in columns] for i in range(3)]
    return [det([[right[i] if j == k else rows[i][j] for j in range(3)] for i in range(3)]) / det(rows) for k in range(3)]


def pointing(file, first, end, wall):
    """The shares of time in which the head points within 15 degrees of the table's middle, and of the middle of the wall."""
    middle = [(a + b) / 2 for a, b in zip(wall["lower_right"], wall["upper_left"])]
    total, table, panel, before = 0.0, 0.0, 0.0, None
    for t, *of in query("SELECT f.display_s, v.room_x_m, v.room_y_m, v.room_z_m, v.x_m, v.y_m, v.z_m, f.head_sensor_qw, f.head_sensor_qx, f.head_sensor_qy, f.head_sensor_qz, "
                        + ", ".join(f"f.board_from_room_{axes}" for axes in ("xx", "yx", "zx", "xy", "yy", "zy", "xz", "yz", "zz"))
                        + " FROM frame f JOIN viewer v ON v.frame = f.number WHERE f.number >= ? AND f.number < ? ORDER BY f.number", first, end, file=file):
        step, before = (0.0 if before is None else t - before), t
        forward = turned(of[6:10], (0, 0, -1))
        to_table = solved([of[10:13], of[13:16], of[16:19]], [-x for x in of[3:6]])
        total += step
        table += step * (apart_deg(forward, to_table) <= 15)
        panel += step * (apart_deg(forward, [m - x for m, x in zip(middle, of[:3])]) <= 15)
    return table / total, panel / total


def check_behaviour(folder, arms):
    wall = tomllib.loads((out / "room.toml").read_text())["wall"][0]
    rows, moved = rows_of(folder, "behaviour.csv"), []
    assert len(rows) == (PEOPLE - 1) * len(LESSONS), len(rows)
    for row in rows:
        first = query("SELECT first_frame FROM participation WHERE code = ? AND lesson = ?", row["participant"], row["lesson"])[0][0]
        end = query("SELECT coalesce(min(first_frame), 1e18) FROM game WHERE first_frame > ?", first)[0][0]
        frames = query("SELECT f.display_s, v.room_x_m, v.room_y_m, v.room_z_m, v.celerity_x_m_s, v.celerity_y_m_s, v.celerity_z_m_s, f.light_speed_m_s, "
                       "f.lesson_phase, f.switches, f.views, f.blank FROM frame f JOIN viewer v ON v.frame = f.number WHERE f.number >= ? AND f.number < ? ORDER BY f.number", first, end)
        times = [frame[0] for frame in frames]
        length = smooth_path(times, [frame[1:4] for frame in frames])
        # Two low-passes of 2 Hz agree where the frames show its waves, eight to a wave; a busy computer draws fewer.
        apart = 0.05 if max(t - s for s, t in zip(times, times[1:])) <= 1 / 16 else 0.5
        assert abs(float(row["path_m"]) - length) <= apart * length + 0.005, f"{row}: {length}"
        beta = [u / math.sqrt(1 + u * u) for u in (math.hypot(*frame[4:7]) / frame[7] for frame in frames)]
        mean = sum(b * (t - s) for b, s, t in zip(beta[1:], times, times[1:])) / (times[-1] - times[0])
        assert abs(float(row["beta_mean"]) - mean) < 1e-5 and abs(float(row["beta_most"]) - max(beta)) < 1e-5, f"{row}: {mean}"
        for name, share in zip(("towards_table", "towards_panel"), pointing(session, first, end, wall)):
            assert abs(float(row[name]) - share) < 1e-5, f"{row}: {name} {share}"
        explains = 3  # as in cave/record/lesson_words.h
        assert row["attempt"] == "1" and row["explained"] == ("1" if any(frame[8] == explains for frame in frames) else "0"), row
        asked = sum(t - s for frame, s, t in zip(frames[1:], times, times[1:]) if frame[8] == 1)
        assert abs(float(row["ask_s"]) - asked) < 1e-4, f"{row}: {asked}"
        still = arms[row["participant"]] == "still"
        if still:
            assert len({frame[1:4] for frame in frames}) == 1 and float(row["path_m"]) < 1e-9, "a still head moved"
            assert all(frame[9] & 4 == 0 and frame[10] & 8 == 0 for frame in frames[2:]), "what the arm leaves out was on"
        else:
            moved.append(length)
            assert any(frame[9] & 4 for frame in frames), "aberration was off in the other arm"
        assert not any(frame[11] for frame in frames[5:]), "the walls were black in a lesson"
    assert moved and min(moved) > 0 and max(moved) > 0.05, f"the simulated head stood: {moved}"


def check_responses(folder, plan, codes):
    rows = rows_of(folder, "responses.csv")
    tests = [row for row in rows if row["phase"] in ("pre", "post")]
    assert len(tests) == PEOPLE * 2 * 18 and len(rows) == len(tests) + (PEOPLE - 1) * 4, (len(tests), len(rows))
    for person in plan:
        code = codes[person["number"]]
        for phase, form in zip(("pre", "post"), person["forms"]):
            mine = [row for row in tests if row["participant"] == code and row["phase"] == phase]
            for place, (row, item) in enumerate(zip(mine, items_of(form), strict=True)):
                assert (row["form"], row["item"], row["concept"], row["position"]) == (form, item["id"], item["concept"], str(place + 1)), row
                assert (row["study"], row["arm"], row["order_row"]) == ("Twelve", person["arm"], str(person["order_row"])), row
                if person["number"] == PEOPLE and phase == "post":
                    assert row["answer"] == row["correct"] == row["confidence"] == "", row
                    continue
                given = choose(item, person["number"], place, phase)
                answer = next((a for a in item["answer"] if a["id"] == given), {})
                assert row["answer"] == given and row["correct"] == ("1" if answer.get("right") else "0"), row
                assert row["misconception"] == answer.get("misconception", "") and row["confidence"] == str(1 + (person["number"] + place) % 4), row
                assert row["reason"] == ("Write to [masked] or [masked], I am 17" if place == 0 else ""), row
    people = rows_of(folder, "participants.csv")
    assert [row["participant"] for row in people] == [codes[n] for n in range(1, PEOPLE + 1)]
    for row, person in zip(people, plan, strict=True):
        assert row["forms"] == "".join(person["forms"]) and row["gender"] == "woman" and row["age_band"] == "18-24", row
        assert row["guardian"] == "0", row
        assert row["started_utc"] == time.strftime("%Y-%m-%d", time.gmtime()) and row["excluded"] == ("stopped" if person["number"] == PEOPLE else ""), row


def check_anonymous(folder):
    words = [socket.gethostname(), str(out), "/root", "/home", "127.0.0.1", "anna", "example.org", "0171 /", "day.db", "room.toml"]
    for path in folder.rglob("*"):
        if path.is_file():
            text = path.read_text()
            for word in words:
                assert word not in text, f"{path} has {word}"
            assert not re.search(r"\b\d\d:\d\d\b|T\d\d:|\d{1,3}\.\d{1,3}\.\d{1,3}\.\d{1,3}", text), f"{path} has a time of day or an address"


def others(code):
    """All rows of the other participants and of their games."""
    games = [row[0] for row in query("SELECT first_frame FROM participation WHERE code != ? ORDER BY 1", code)]
    rows = {table: query(f"SELECT * FROM {table} WHERE code != ? ORDER BY 1, 2, 3", code) for table in ("participant", "response", "response_change", "participation")}
    ends = [query("SELECT coalesce(min(first_frame), 1e18) FROM game WHERE first_frame > ?", game)[0][0] for game in games]
    rows["frames"] = [query("SELECT * FROM frame WHERE number >= ? AND number < ?", first, end) for first, end in zip(games, ends)]
    rows["viewers"] = [query("SELECT * FROM viewer WHERE frame >= ? AND frame < ?", first, end) for first, end in zip(games, ends)]
    rows["knots"] = [query("SELECT * FROM knot WHERE frame >= ? AND frame < ? ORDER BY 1, 2, 3", first, end) for first, end in zip(games, ends)]
    spans = [(frames[0], frames[-1]) for frames in rows["frames"]]
    return games, rows, spans


def pictures(number, name):
    run("replay", session, "--game", number, "--capture", out / name)
    return {path.name: path.read_bytes() for path in sorted((out / name).glob("*.png"))[::7]}


plan = json.loads(run("study", "plan", study, "--json", "-"))["participants"]
run("study", "codes", study, "-o", slips, "--html", out / "slips.html")
assert "is there already" in run("study", "codes", study, "-o", slips, status=1)
with open(slips, newline="") as file:
    codes = {int(row["number"]): row["code"] for row in csv.DictReader(file)}
assert len(set(codes.values())) == PEOPLE and all(code in (out / "slips.html").read_text() for code in codes.values())

assert slips.stat().st_mode & 0o777 == 0o600 and (out / "slips.html").stat().st_mode & 0o777 == 0o600, "others can read the codes"

# A start that fails by the slips leaves no session file.
for wrong, words in (out / "none.csv", "there is no such file, expected the slips that carom study codes writes"), (out, "this is a folder, expected the slips that"):
    refused = subprocess.run([carom, "cave", "--silent", "--no-window", "--rig", out / "room.toml", "--session", session, "--study", study, "--slips", wrong,
                              "--class-address", "127.0.0.1", "--class-port", "0"], capture_output=True, text=True, timeout=60)
    assert refused.returncode == 1 and words in refused.stderr and not session.exists(), refused

# What of the template is left is told with its line.
said = run("check", study)
assert re.search(r"consent-en\.md:5:10: \[Name of the institution, .*\] stands in brackets", said) and "consent-en.md:3:2: this is still the template's sentence" in said, said
assert "study.toml:3:16: 6 people in an arm" in said, said

room = Session()


def refuses_to_delete():
    """Waits until no lesson is written, and is refused all the time."""
    def between_lessons():
        refused = subprocess.run([carom, "study", "delete", codes[1], session], capture_output=True, text=True)
        assert refused.returncode == 1 and "has data of this code" not in refused.stderr, f"deleted while it runs: {refused}"
        return "expected that its session is over" in refused.stderr
    wait_for("the end of the lesson", between_lessons)


refuses_to_delete()
for place in "/socket", "/class.js", "/teacher":
    try:
        urllib.request.urlopen(room.address.removesuffix("/study") + place, timeout=10)
        raise AssertionError(f"{place} is there")
    except urllib.error.HTTPError as error:
        assert error.code == 404
try:
    urllib.request.urlopen(urllib.request.Request(room.address, b"go=code&code=x", {"Origin": "http://evil.example"}), timeout=10)
    raise AssertionError("a form of another page was taken")
except urllib.error.HTTPError as error:
    assert error.code == 403
for person in plan[:6]:
    take_part(room, codes[person["number"]], person)
refuses_to_delete()
assert query("SELECT 1 FROM participant WHERE code = ?", codes[1])
room.end()

# A study that was changed meanwhile is refused; the same goes on in the same file.
words = [carom, "cave", "--silent", "--no-window", "--session", session, "--resume", "--study", study, "--slips", slips, "--class-address", "127.0.0.1", "--class-port", "0"]
study.write_text(STUDY + "# changed\n")
refused = subprocess.run(words, capture_output=True, text=True, timeout=60)
assert refused.returncode == 1 and "expected the same study, or --amended" in refused.stderr, refused
study.write_text(STUDY)
room = Session("--resume")
assert "This code was used" in room.send(None, go="code", code=codes[1]).text
for person in plan[6:]:
    take_part(room, codes[person["number"]], person)
room.end()
assert query("SELECT count(*) FROM participant")[0][0] == PEOPLE

# The export. The same session, also a copy of it, is refused.
data = out / "data"
copy = out / "copy.db"
shutil.copy(session, copy)
for other in session, copy:
    said = run("study", "export", session, other, "-o", data, status=1)
    assert f"{other} is the same session as {session}, expected each session once" in said, said
copy.unlink()
run("study", "export", session, "-o", data)
assert "is there already" in run("study", "export", session, "-o", data, status=1)
check_codebook(data)
check_responses(data, plan, codes)
arms = {codes[person["number"]]: person["arm"] for person in plan}
check_behaviour(data, arms)
check_anonymous(data)
assert not (data / "motion").exists()
assert "--consented" in run("study", "export", session, "-o", out / "no", "--motion", status=2)
run("study", "export", session, "-o", out / "with", "--motion", "--consented")
ticked = {f"sub-{codes[n]}" for n in range(1, PEOPLE) if n % 3 == 0}
assert {path.name for path in (out / "with/motion").iterdir()} == ticked
check_anonymous(out / "with")
motion = next((out / "with/motion").rglob("*_motion.tsv"))
rows = [line.split("\t") for line in motion.read_text().splitlines()]
channels = motion.with_name(motion.name.replace("_motion.tsv", "_channels.tsv")).read_text().splitlines()
assert len(rows) > 30 and all(len(row) == len(channels) - 1 for row in rows) and -0.1 < float(rows[0][0]) < 1

# Somebody withdraws.
code, number = codes[3], 3
games, before, spans = others(code)
all_games = [row[0] for row in query("SELECT first_frame FROM game WHERE EXISTS (SELECT 1 FROM frame WHERE number >= game.first_frame AND number < coalesce((SELECT min(first_frame) FROM game g WHERE g.first_frame > game.first_frame), 1e18)) ORDER BY 1")]
seen = pictures(all_games.index(games[-1]) + 1, "seen")
assert seen
said = run("study", "delete", code, session, data, out / "with")
assert "1 participant withdrew" in said, said
for path in [session, *out.glob("day.db-*"), *data.rglob("*"), *(out / "with").rglob("*")]:
    assert code not in path.name, path
    if path.is_file():
        content = path.read_bytes()
        for form in (code.encode(), code.lower().encode(), code.encode("utf-16-le"), code.encode("utf-16-be")):
            assert form not in content, f"{path} still has the code"
after_games, after, _ = others(code)
assert after_games == games and after == before, "rows of others have changed"
left = [row[0] for row in query("SELECT first_frame FROM game WHERE EXISTS (SELECT 1 FROM frame WHERE number >= game.first_frame AND number < coalesce((SELECT min(first_frame) FROM game g WHERE g.first_frame > game.first_frame), 1e18)) ORDER BY 1")]
assert pictures(left.index(games[-1]) + 1, "again") == seen, "the replay of others differs"
assert query("SELECT value FROM session WHERE key = 'study_withdrew'")[0][0] == 1
run("study", "export", session, "-o", out / "rest")
for folder in out / "rest", data:
    assert {row["key"]: row["value"] for row in rows_of(folder, "study.csv")}["withdrew"] == "1"
    assert len(rows_of(folder, "participants.csv")) == PEOPLE - 1
assert "has data of this code" in run("study", "delete", code, session, status=1)
assert "is no code" in run("study", "delete", "AAAAAB", session, status=1)
if shutil.which("Rscript"):
    if subprocess.run(["Rscript", "-e", "quit(status = if (requireNamespace('lme4', quietly = TRUE)) 0 else 1)"], capture_output=True).returncode == 0:
        run("study", "report", out / "rest")
        report = (out / "rest/report.html").read_text()
        assert "Description only" in report and "1 withdrew" in report and "Left out by rule" in report
empty = subprocess.run([carom, "study", "report", out / "rest"], capture_output=True, text=True, env={"PATH": "/nowhere"})
assert empty.returncode == 1 and "r-base-core" in empty.stderr and "r-cran-lme4" in empty.stderr, empty

# Sessions of two studies do not go together; one without a study has none of its tables.
other = out / "other.db"
shutil.copy(session, other)
with sqlite3.connect(other) as database:
    text = database.execute("SELECT value FROM session WHERE key = 'study'").fetchone()[0]
    database.execute("UPDATE session SET value = ? WHERE key = 'study'", (text + "# another\n",))
database.close()
assert "of another study" in run("study", "export", session, other, "-o", out / "both", status=1)
plain = out / "plain.db"
run("cave", "--rig", out / "room.toml", "--frames", "5", "--no-window", "--silent", "--session", plain)
tables = {row[0] for row in query("SELECT name FROM sqlite_master", file=plain)}
assert not tables & {"participant", "response", "response_change", "participation"}, tables
assert "there is no study in this file" in run("study", "export", plain, "-o", out / "none", status=1)


def begin(room, code, called=False):
    """Takes part up to the test."""
    page = room.send(None, **({"go": "called"} if called else {"go": "code", "code": code}))
    assert "Before you begin" in page.text, page.text
    return room.send(room.send(page, go="next", part="yes"), go="next", age_band="18-24")


# Arms with other rigs: each rig has its sessions, the plan says whose they are, the export puts them together.
(out / "other.toml").write_text((out / "room.toml").read_text().replace("upper_left = [-0.8, 1.8, -1.0]", "upper_left = [-0.8, 2.8, -1.0]"))
rooms = out / "rooms.toml"
rooms.write_text('title = "Rooms"\nseed = 4\nparticipants = 6\nlessons = ["two-cushions"]\nkeep_until = 2001-02-03\n' + "".join(
    f'[[arm]]\nname = "{name}"\nrig = "{rig}.toml"\n' for name, rig in (("near", "room"), ("far", "other"))))
said = run("study", "plan", rooms)
arm_of = {person["number"]: person["arm"] for person in json.loads(run("study", "plan", rooms, "--json", "-"))["participants"]}
for arm, rig in ("near", "room"), ("far", "other"):
    assert f"session with --rig {rig}: numbers {', '.join(str(n) for n in sorted(arm_of) if arm_of[n] == arm)}\n" in said, said
assert "kept until 2001-02-03, expected that its session files, exports and copies are deleted" in run("check", rooms)
run("study", "codes", rooms, "-o", out / "rooms.csv")
with open(out / "rooms.csv", newline="") as file:
    code_of = {int(row["number"]): row["code"] for row in csv.DictReader(file)}
(out / "third.toml").write_text((out / "room.toml").read_text())
refused = subprocess.run([carom, "cave", "--rig", out / "third.toml", "--silent", "--no-window", "--session", out / "third.db", "--study", rooms, "--slips", out / "rooms.csv",
                          "--class-address", "127.0.0.1", "--class-port", "0"], capture_output=True, text=True, timeout=60)
assert refused.returncode == 1 and "is that of no arm of the study, expected room or other" in refused.stderr, refused
for rig, own in ("room", "near"), ("other", "far"):
    room = Session(of=(rooms, out / "rooms.csv", out / f"day-{rig}.db"), rig=f"{rig}.toml")
    for number, code in code_of.items():
        if arm_of[number] != own:
            assert f"This code is for another room ({'other' if own == 'near' else 'room'})" in room.send(None, go="code", code=code).text
            continue
        page = begin(room, code)
        for _ in range(18):
            page = room.send(page, go="next", answer="dont-know")
        if number == 6:  # goes away here
            room.send(page, go="next")
            continue
        page = room.send(room.send(page, go="next"), go="rate", **{"unwell-before": "0"})
        wait_for("the lesson", lambda: query("SELECT 1 FROM participation WHERE code = ?", code, file=out / f"day-{rig}.db"))
        first = query("SELECT first_frame FROM participation WHERE code = ?", code, file=out / f"day-{rig}.db")[0][0]
        wait_for("a second of it", lambda: (query("SELECT max(display_s) - min(display_s) FROM frame WHERE number >= ?", first, file=out / f"day-{rig}.db")[0][0] or 0) > 0.5)
        stop(room, page)
    room.end()
run("study", "export", out / "day-room.db", out / "day-other.db", "-o", out / "rooms")
assert {row["participant"]: row["arm"] for row in rows_of(out / "rooms", "participants.csv")} == {code_of[n]: arm for n, arm in arm_of.items()}
assert {row["participant"]: row["excluded"] for row in rows_of(out / "rooms", "participants.csv")} == {code_of[n]: "unfinished" if n == 6 else "stopped" for n in arm_of}
check_codebook(out / "rooms")
behaved = rows_of(out / "rooms", "behaviour.csv")
assert len(behaved) == len(code_of) - 1
for row in behaved:
    rig = "room" if arm_of[next(n for n, code in code_of.items() if code == row["participant"])] == "near" else "other"
    file = out / f"day-{rig}.db"
    first = query("SELECT first_frame FROM participation WHERE code = ?", row["participant"], file=file)[0][0]
    end = query("SELECT coalesce(min(first_frame), 1e18) FROM game WHERE first_frame > ?", first, file=file)[0][0]
    share = pointing(file, first, end, tomllib.loads((out / f"{rig}.toml").read_text())["wall"][0])[1]
    assert abs(float(row["towards_panel"]) - share) < 1e-5, f"{row}: {share} of the panel of {rig}"
said = run("doctor", "--no-window", "--findings", "--folder", out)
assert [line.split(":")[1].strip() for line in said.splitlines() if "the data of the study 'Rooms'" in line] == ["day-other.db", "day-room.db"], said

# A withdrawal from several files is counted once; one more of another person is another one. The lesson of a person who comes to a
# session that goes on is begun again.
own = {rig: [code for number, code in code_of.items() if arm_of[number] == arm] for rig, arm in (("room", "near"), ("other", "far"))}
both = own["room"][0]
with sqlite3.connect(out / "day-other.db") as database:  # who came to both rooms
    database.execute("INSERT INTO participant SELECT ?, study, arm, order_row, forms, consent, consent_version, 99, started_utc, step, lesson, excluded FROM participant LIMIT 1", (both,))
database.close()
assert run("study", "delete", both, out / "day-room.db", out / "day-other.db").count("removed") == 2
def withdrew(name):
    run("study", "export", out / "day-room.db", out / "day-other.db", "-o", out / name)
    return {row["key"]: row["value"] for row in rows_of(out / name, "study.csv")}["withdrew"]
assert withdrew("once") == "1"
said = run("study", "delete", own["other"][0], out / "day-room.db", out / "day-other.db")
assert "day-room.db: has nothing of this code" in said and "1 participant withdrew" in said, said
assert withdrew("twice") == "2"
with sqlite3.connect(out / "day-other.db") as database:  # as older programs left it, which kept no identifier
    database.execute("DELETE FROM session WHERE key = 'study_withdrawals'")
database.close()
assert withdrew("older") == "3"

# At the console a code is typed; then keys are pressed in a lesson, and the export has each of them.
if shutil.which("xdotool"):
    AT, FIELD = (20, 20), (440, 426)  # the console, and its field for a code (app/console/console.cpp lays it out)
    (out / "keys.toml").write_text(re.sub(r"(?m)^window = .*", "window = { position = [1500, 900], size = [64, 36] }", (out / "room.toml").read_text())
                                   + f"\n[console]\nwindow = {{ position = [{AT[0]}, {AT[1]}], size = [1280, 860] }}\n")
    one, file = out / "one.toml", out / "keys.db"
    one.write_text('title = "Keys"\nseed = 1\nparticipants = 1\nlessons = ["two-cushions"]\n[[arm]]\nname = "a"\nrig = "keys.toml"\n')
    run("study", "codes", one, "-o", out / "one.csv")
    code = (out / "one.csv").read_text().split(",")[-1].strip()
    room = Session("--console", of=(one, out / "one.csv", file), rig="keys.toml")

    def do(*what):
        subprocess.run(["xdotool", *map(str, what)], check=True, stderr=subprocess.DEVNULL)

    def press(key):
        do("key", "--window", subprocess.run(["xdotool", "search", "--name", "Carom: screen"], capture_output=True, text=True).stdout.split()[0], key)

    def asks_for_the_code():
        """Types it at the console, and presses the tablet's button, until a page comes for it."""
        do("mousemove", AT[0] + FIELD[0], AT[1] + FIELD[1], "click", "1")
        time.sleep(0.5)
        do("type", "--delay", "60", code.lower())
        do("key", "Return")
        time.sleep(1)
        return "Before you begin" in room.send(None, go="called").text

    wait_for("the console", lambda: subprocess.run(["xdotool", "search", "--name", "Carom: console"], capture_output=True, text=True).stdout.split())
    assert "No code has been typed at the console" in room.send(None, go="called").text
    wait_for("the code typed at the console", asks_for_the_code)
    page = begin(room, code)
    for _ in range(18):
        page = room.send(page, go="next")
    room.send(room.send(page, go="next"), go="rate", **{"unwell-before": "0"})
    wait_for("the lesson", lambda: query("SELECT 1 FROM participation", file=file))
    first = query("SELECT first_frame FROM participation", file=file)[0][0]

    # Who goes to the right has the second velocity of this lesson, who goes to the left the third.
    VELOCITY = "CASE WHEN v.celerity_x_m_s > 0.1 THEN 2 WHEN v.celerity_x_m_s < -0.1 THEN 3 ELSE 1 END"
    FRAMES = "FROM frame f JOIN viewer v ON v.frame = f.number WHERE f.number >= ? ORDER BY f.number"

    def presses(key, sql, value):
        """Presses a key once the lesson runs, and waits until a frame has what it does."""
        newest = lambda: query(f"SELECT {sql} {FRAMES} DESC LIMIT 1", first, file=file)
        wait_for("the next frames", lambda: newest() and newest()[0][0] != value)
        press(key)
        wait_for(f"what {key} does", lambda: newest()[0][0] == value)

    PATHS, CLOCKS = 4, 16  # bits of the column `views`, in the order of kNamedViews
    presses("F3", VELOCITY, 2)
    presses("F4", VELOCITY, 3)
    presses("p", f"f.views & {PATHS}", PATHS)
    presses("c", f"f.views & {CLOCKS}", CLOCKS)
    presses("p", f"f.views & {PATHS}", 0)
    presses("F2", VELOCITY, 1)
    for key in "F5", "F6", "F7", "F8", "Escape", "q":  # the ways out of the lesson are locked
        press(key)
        time.sleep(0.3)
    presses("p", f"f.views & {PATHS}", PATHS)
    presses("p", f"f.views & {PATHS}", 0)
    assert (out / "stderr").read_text().count("is locked while people take part") == 4
    assert query("SELECT count(*) FROM game WHERE first_frame > ?", first, file=file) == [(0,)], "a key has ended the lesson"
    press("Return")
    wait_for("the explanation", lambda: query(f"SELECT f.lesson_phase {FRAMES} DESC LIMIT 1", first, file=file)[0][0] == 3)
    time.sleep(0.5)
    page = room.send(None, go="code", code=code)
    assert "Lesson 1 of 1" in page.text, page.text
    press("y")  # begins it again
    wait_for("the second attempt", lambda: query("SELECT count(*) FROM participation", file=file) == [(2,)])
    again = query("SELECT max(first_frame) FROM participation", file=file)[0][0]
    wait_for("some frames", lambda: query("SELECT count(*) > 20 FROM frame WHERE number >= ?", again, file=file)[0][0])
    page = room.send(page, go="next")
    assert "Question 1 of 18" in page.text, page.text
    room.end()
    run("study", "export", file, "-o", out / "keys")
    row, second = rows_of(out / "keys", "behaviour.csv")
    assert (row["attempt"], row["explained"], second["attempt"], second["explained"]) == ("1", "1", "2", "0"), (row, second)
    told = query("SELECT min(number) FROM frame WHERE number >= ? AND lesson_phase = 3", first, file=file)[0][0]
    # By another method: what was pressed, and the changes in the frames that were seen.
    # The explanation comes with the velocity that it is about.
    assert row["velocities"] == "2 3 1 2" and row["views_switched"] == "5" and row["strokes"] == "0", row
    seen = query(f"SELECT f.views, {VELOCITY} {FRAMES.replace('ORDER', f'AND f.number < {told} ORDER')}", first, file=file)
    assert {2, 3} <= {velocity for _, velocity in seen}, seen  # their order is not told by frames: the head sways, too
    assert sum(bin((now[0] ^ later[0]) & (PATHS | CLOCKS)).count("1") for now, later in zip(seen, seen[1:])) == 5
print(f"{PEOPLE} people, {len(games)} lessons of others")
