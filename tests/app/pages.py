"""pages.py ROOT MANUAL SCHEMAS: every link in README.md and in the pages of app/doc leads to a page, a heading or a picture that is there,
also where they are installed (config/package.cmake), README.md links to every page, and the sections of app/doc/physics.md and
the headers that they name agree: each such header has a line "Theory: app/doc/physics.md, SECTION; SECTION.". The
card to print is well formed and has two sides; what app/doc/teachers.md says that many predict wrongly, and how to go on,
is what the lesson's own file says; every command and option that it and the page of the first day name is in the
manual page; each key of the files that people write (the schemas in the folder SCHEMAS) is named in code on a page."""

import html.parser
import json
import pathlib
import re
import sys
import tomllib

from schema_names import names_in

root = pathlib.Path(sys.argv[1]).resolve()
readme = root / "README.md"
pages = [readme, root / "CONTRIBUTING.md", root / "CHANGELOG.md", *sorted((root / "app/doc").glob("*.md"))]
card = root / "app/doc/card.html"
installed = {*pages, card, *(root / "app/pictures").glob("*.png"), *(root / "app/doc/figures").glob("*.svg")}
failed = False


def fail(words):
    global failed
    failed = True
    print(words)


def text_of(page):
    """The page without its code, in which brackets are no links and # begins no heading."""
    return re.sub(r"(?ms)^ *```.*?^ *```$", "", page.read_text())


def places_in(page):
    """The anchors that GitHub gives to a page's headings."""
    headings = re.findall(r"(?m)^#+ (.*)$", text_of(page))
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def lessons_on(page):
    """For each lesson the words behind "Predicted wrongly:" and "Go on with:", without marks."""
    for section in re.split(r"(?m)^#+ ", page.read_text())[1:]:
        heading, text = section.split("\n", 1)
        points = dict(re.findall(r"(?ms)^\* \*\*(.+?):\*\* (.*?)(?=^\* |^\S|\Z)", text))
        for lesson in re.findall(r"`([\w-]+)`", heading) if "Predicted wrongly" in points else []:
            yield lesson, {key: plain(points.get(key, "")) for key in ("Predicted wrongly", "Go on with")}


def plain(words):
    words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", " ".join(words.split()))
    return re.sub(r"(?<!\w)\*([^*]+)\*(?!\w)", r"\1", words.replace("**", "").replace("`", ""))


told = dict(lessons_on(root / "app/doc/teachers.md"))
for file in sorted((root / "config/scenarios").glob("*.toml")):
    lesson = tomllib.loads(file.read_text()).get("lesson")
    if lesson and {"Predicted wrongly": lesson.get("predicted_wrongly"), "Go on with": lesson.get("go_on_with")} != told.get(file.stem):
        fail(f"{file}: predicted_wrongly and go_on_with differ from what app/doc/teachers.md says: {told.get(file.stem)}")

linked = set()
for page in pages:
    for target in re.findall(r"\]\(([^)\s]+)\)", text_of(page)):
        if target.startswith(("http://", "https://")):
            continue
        name, _, place = target.partition("#")
        file = (page.parent / name).resolve() if name else page
        if page == readme:
            linked.add(file)
        if file not in installed:
            fail(f"{page}: the link to {target} leads to no page and no picture that is installed with it")
        elif place and place not in places_in(file):
            fail(f"{page}: the link to {target}: that page has no such heading, it has {sorted(places_in(file))}")
for page in pages[1:]:
    if page not in linked:
        fail(f"{readme} has no link to {page}")
if card not in linked:
    fail(f"{readme} has no link to {card}")


class Card(html.parser.HTMLParser):
    """Its open elements, its sides and what stands in code."""

    def __init__(self):
        super().__init__()
        self.open, self.sides, self.codes = [], 0, []

    def handle_starttag(self, tag, attributes):
        self.sides += tag == "section"
        if tag == "code":
            self.codes.append("")
        if tag not in ("meta", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            fail(f"{card}:{self.getpos()[0]}: </{tag}> closes nothing")

    def handle_data(self, data):
        if "code" in self.open:
            self.codes[-1] += data


parsed = Card()
parsed.feed(card.read_text())
if parsed.open or parsed.sides != 2:
    fail(f"{card}: open at the end: {parsed.open}; {parsed.sides} sides, expected 2")

# Commands, with the options that follow them, against the manual page.
manual = pathlib.Path(sys.argv[2]).read_text().replace("\\-", "-")
parts = {part.split()[1].strip('"'): part for part in re.split(r"(?m)^\.SS \"?", manual)[1:]}
first_day = (root / "app/doc/first-day.md").read_text()
codes = parsed.codes + re.findall(r"(?m)`([^`\n]+)`", first_day) + re.findall(r"(?m)^carom .*$", first_day)
commands = 0
for code in codes:
    for command, rest in re.findall(r"\bcarom ([a-z]+)\b([^;|&]*)", code):
        commands += 1
        if command not in parts:
            fail(f"'{code}': {command} is no command of the manual page")
            continue
        known = parts[command] + (parts["cave"] if command == "room" else "")
        for option in re.findall(r"(?<![\w-])--[a-z][a-z-]+", re.split(r"   |\s--\s", rest)[0]):
            if not re.search(re.escape(option) + r"(?![a-z-])", known):
                fail(f"'{code}': the manual page knows no {option} of {command}")
if commands < 25:
    fail(f"only {commands} commands are named by the first day and the card")

# The keys of files. The pages that list them all are made from their declarations; these are those that explain them.
explained = set()
for page in (root / "app/doc").glob("*.md"):
    fenced = re.findall(r"(?ms)^ *```.*?^ *```$", page.read_text())
    spans = re.findall(r"`([^`]+)`", text_of(page))
    explained |= set(re.findall(r"[\w-]+", " ".join(fenced + spans)))
schemas = sorted(pathlib.Path(sys.argv[3]).glob("*.schema.json"))
for schema in schemas:
    for key in sorted(names_in(json.loads(schema.read_text())) - explained):
        fail(f"{schema.name}: the key {key} is named in code on no page of app/doc")
if len(schemas) < 5:
    fail(f"{sys.argv[3]} has {len(schemas)} schemas, expected those of items, playlists, rigs, scenarios and studies")

# The page of physics and the headers name each other.
named = set()  # (header, section) by the page
for section in re.split(r"(?m)^## ", (root / "app/doc/physics.md").read_text())[1:]:
    title = section.splitlines()[0]
    for header in re.findall(r"`((?:engine|cave|devices)/[\w/]+\.(?:h|glsl))`", section):
        named.add((header, title))
told = set()  # by the headers
for folder in ("engine", "cave", "devices", "app"):
    for header in (root / folder).rglob("*"):
        if header.suffix in (".h", ".glsl"):
            words = re.sub(r"\n\s*// ?", " ", header.read_text())  # the formatter wraps comments
            line = re.search(r"Theory: app/doc/physics\.md, ([^.]*)\.", words)
            if line:
                told |= {(str(header.relative_to(root)), title) for title in line[1].split("; ")}
for header, title in sorted(named - told):
    fail(f"app/doc/physics.md, {title}, names {header}, which does not say: Theory: app/doc/physics.md, {title}.")
for header, title in sorted(told - named):
    fail(f"{header} names the section {title} of app/doc/physics.md, which does not name it")
if len(named) < 20:
    fail("app/doc/physics.md names too few headers")
print(f"{len(pages)} pages, {commands} commands, {len(named)} sections named by headers")
sys.exit(1 if failed or len(pages) < 3 else 0)
