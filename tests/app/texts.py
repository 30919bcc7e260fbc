"""texts.py ROOT: no text that people read on walls or in windows stands outside the catalogue cave/texts/texts.h.

Scans every string literal of the C++ sources in the rooms of SCANNED. A literal that has a letter, apart from the
places for values in it, is a text for people unless it is one of these:
 - the identity of a part of a window, which Dear ImGui does not show: it begins with "##";
 - an argument of a call of NOT_SHOWN, which names something to the graphics card, a file or the log;
 - in a file of OWN_WORDS, for the reason given there; the name of a file or of a key.
Prints each text that it finds. Each text of the group "page" that a page names is used by one of app/page/pages, which
have no other. Checks also that no room outside SCANNED can show texts (it includes none of SHOWING), that
the catalogue has no text twice in one group nor one that nobody uses, that each text with values tells translators what
fills them, and that each part of this list is needed. A text that is put together without the language in use does not
compile: a Text of the catalogue is no format of fmt."""

import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
CATALOGUE = "cave/texts/catalogue"
# The sources of the pages of visits, which name the texts of the group "page".
PAGES = "app/page/pages"
SCANNED = ["app/class_server", "app/classroom", "app/console", "app/console_parts", "app/hand", "app/input", "app/live", "app/operator", "app/play",
           "app/replay", "app/report", "app/session", "app/viewer", "cave/bodies", "cave/display", "cave/hud", "cave/marks", "cave/overlay",
           "cave/patterns", "cave/render", "cave/sculpture", "cave/spectator"]
# Rows of this module name texts for the others.
NAMING = ["cave/record"]
# With these headers a module shows texts: on walls, in windows, as messages.
SHOWING = ["imgui.h", "cave/gl/gui.h", "cave/gl/glyph_bitmap.h", "cave/hud/panel_picture.h", "app/live/status_message.h"]
MAKES_LETTERS = ["cave/gl"]
# Ask which letters the fonts have, or which ones windows need, and show none.
ASKS_FOR_LETTERS = ["app/file_tools/check_translation.cpp", "app/stage/shared_languages.cpp"]
NOT_SHOWN = {
    # messages of the command line and of the log stand beside the code whose facts they name
    "note", "warn", "runtime_error", "invalid_argument",
    # names of programs, uniforms and attributes of shaders
    "makeProgram", "place", "at", "setUniform", "glGetUniformLocation", "stream_", "corners_",
    # names of commands and notes of a session file
    "keyFor", "Box", "kDriveModes", "decision.notes.push_back",
}
OWN_WORDS = {
    "app/play/hand_force.cpp": "notes of a session file about force devices",
    "app/class_server/class_address.cpp": "messages of the command line about addresses",
    "app/classroom/class_flow.h": "names of the teacher's steps, as pages send them",
    "app/class_server/class_pages.cpp": "names in pages and signs of HTML",
    "app/class_server/class_answers.cpp": "names of HTTP, and paths of pages",
    "app/class_server/class_host.h": "names of HTTP",
    "app/class_server/class_host.cpp": "paths of pages, and messages of the command line",
    "app/classroom/classroom_messages.cpp": "keys of the messages to pages",
    "app/class_server/study_desk.cpp": "the path of a page",
    "app/classroom/phone_message.cpp": "keys of the messages of pages",
    "app/hand/hand_input.h": "names of devices, by which the program tells them apart",
    "app/input/keyboard_layout.cpp": "keys of a US keyboard",
    "app/operator/command.cpp": "names and values of commands, as session files and their log hold them",
    "app/operator/visitor_choices.h": "names of shipped games",
    "app/report/chart_drawing.cpp": "SVG",
    "app/report/chart_file.cpp": "names of formats, and messages of the command line",
    "app/report/report_library.cpp": "names of files, and messages of the command line",
    "app/report/sculpture_export.cpp": "glTF",
    "app/report/sculpture_file.cpp": "names of formats and files, and messages of the command line",
    "app/session/status_file.cpp": "keys and values of the status file",
    "cave/display/display_facts.cpp": "names of X11",
    "cave/display/monitors.cpp": "messages of the command line about monitors",
    "cave/display/wall_window.cpp": "names of X11",
    "cave/display/window.cpp": "messages of the command line about windows",
    "cave/bodies/body_program.h": "names in a shader",
    "cave/bodies/body_shaders.cpp": "source of a shader",
    "cave/marks/mark_buffer.cpp": "a line of a shader",
    "cave/spectator/solid_drawer.cpp": "names in a shader",
    "app/viewer/hand_tracking.cpp": "messages of the log about trackers",
    "app/viewer/head_tracking.cpp": "messages of the log about trackers",
}
LITERALS = {
    "scenarios", ".toml", "-wal", "outside", "carom-pictures", "carom-best-shot", "carom-{:%F-%H%M%S}.db",  # parts of the names of files
    "the window of wall {} is {}",  # a message of the log
}
KEY = re.compile(r"[A-Z]|F\d+|W A S D")  # what is printed on a key
failed = False


def fail(words):
    global failed
    failed = True
    print(words)


TOKEN = re.compile(r"""//[^\n]*|/\*.*?\*/|R"\((?P<raw>.*?)\)"|"(?P<text>(?:[^"\\\n]|\\.)*)"|'(?:[^'\\]|\\.)+'"""
                   r"""|(?P<word>[A-Za-z_]\w*)|(?P<number>\d[\w.']*)|(?P<sign>[^\s])""", re.DOTALL)


def literals(source):
    """Yields each string literal with its place and the names of the calls around it, innermost last."""
    calls, before = [], ""
    lines = re.sub(r"(?m)^#include[^\n]*$", "", source)
    for token in TOKEN.finditer(lines):
        kind = token.lastgroup
        if kind in ("text", "raw"):
            yield token.group(kind), source.count("\n", 0, token.start()) + 1, list(calls)
        elif kind == "sign" and token.group() in "([{":
            calls.append(before)
        elif kind == "sign" and token.group() in ")]}" and calls:
            calls.pop()
        if kind == "word":
            before = before + token.group() if before.endswith(".") else token.group()
        else:
            before = before + "." if token.group() == "." and before else ""


def isText(literal):
    """Whether a literal says something: letters outside of its places for values and its escapes."""
    bare = re.sub(r"\{[^}]*\}|%[-\d.*]*(?:ll)?[a-zA-Z]|\\.", " ", literal)
    return not literal.startswith("##") and re.search(r"[^\W\d_]", bare)


# English that a file or a log has, whatever the language in use.
ENGLISH = {
    "app/operator/command.cpp": "the values of commands in a session file",
    "app/operator/lesson.cpp": "the answers in a session file",
    "app/play/hand_force.cpp": "the notes of a session file",
    "app/live/announcements.cpp": "the notes of a session file",
    "app/session/director.cpp": "the answers in a session file",
    "app/live/linked_room.cpp": "how long a message is in the record",
}

needed = set()
for room in SCANNED:
    for file in sorted((root / room).glob("*")):
        if file.suffix not in (".cpp", ".h"):
            continue
        name = str(file.relative_to(root))
        for line, words in enumerate(file.read_text().splitlines(), 1):
            if ".english()" in words and "log::" not in words:
                if name not in ENGLISH:
                    fail(f"{name}:{line}: a text is in English, whatever the language in use is")
                needed.add(name + " ENGLISH")
        for literal, line, calls in literals(file.read_text()):
            if not isText(literal) or KEY.fullmatch(literal):
                continue
            if name in OWN_WORDS:
                needed.add(name)
            elif literal in LITERALS:
                needed.add(literal)
            elif NOT_SHOWN.intersection(calls):
                needed.update(NOT_SHOWN.intersection(calls))
            else:
                fail(f'{name}:{line}: "{literal}" is no text of {CATALOGUE} (in {calls[-1:]})')

for file in sorted(root.glob("*/*/*.*")):
    room = str(file.parent.relative_to(root))
    if file.suffix not in (".cpp", ".h") or room.split("/")[0] not in ("app", "cave", "devices", "engine"):
        continue
    if room in SCANNED + MAKES_LETTERS or str(file.relative_to(root)) in ASKS_FOR_LETTERS:
        continue
    for header in SHOWING:
        if re.search(rf'(?m)^#include ["<]{re.escape(header)}[">]', file.read_text()):
            fail(f"{file.relative_to(root)} includes {header}, so it can show texts, but {room} is not scanned for them")

for name in sorted(ENGLISH):
    if name + " ENGLISH" not in needed:
        fail(f"{name} is excepted, but has no English of its own")
for unused in sorted((NOT_SHOWN | LITERALS | set(OWN_WORDS)) - needed):
    fail(f"{unused} is excepted, but there is nothing to except")

ROW = re.compile(r'(?m)^(TEXT|PLURAL|TEXTS)\((\w+),((?:\s*"(?:[^"\\\n]|\\.)*"\s*,?)+)\)$')
sources = "\n".join(file.read_text() for room in SCANNED + NAMING + ["app/page", "app/commands", "app/output_commands", "app/room_commands", "app/hand"]
                    for file in (root / room).glob("*.*"))
scripts = "\n".join(file.read_text() for file in (root / PAGES).glob("*.js"))
html = (root / PAGES / "visit.html").read_text()
listed = re.findall(r'#include "(cave/texts/catalogue/\w+\.inc)"', (root / CATALOGUE / "all.inc").read_text())
for file in sorted((root / CATALOGUE).glob("*.inc")):
    group, text = file.stem, file.read_text()
    if group == "all":
        continue
    if str(file.relative_to(root)) not in listed:
        fail(f"{file.relative_to(root)} is not in {CATALOGUE}/all.inc")
    rows = ROW.findall(text)
    if len(rows) != len(re.findall(r"(?m)^(?:TEXT|PLURAL|TEXTS)\(", text)):
        fail(f"{file.relative_to(root)}: a row could not be read")
    names = [name for _, name, _ in rows]
    for kind, name, rest in rows:
        if names.count(name) > 1:
            fail(f"{file.relative_to(root)}: {name} is there {names.count(name)} times")
        if name[0] == "k" and not re.search(rf"\b{name}\b", sources):
            fail(f"{file.relative_to(root)}: nobody uses {name}")
        if group == "page" and name[0] != "k":
            if not re.search(rf'texts\.{name}\b|"{name}"', scripts) and f"{{{{{name}}}}}" not in html:
                fail(f"{file.relative_to(root)}: no page uses {name}")
        told = rest.rstrip().rstrip(",").count('",') + 1
        if "{" in rest and kind != "TEXTS" and told < (3 if kind == "PLURAL" else 2):
            fail(f"{file.relative_to(root)}: {name} does not say what fills its values")
    if group == "page":
        for name in sorted(set(re.findall(r"\btexts\.(\w+)", scripts)) - set(names)):
            fail(f"{PAGES}: {name} is no text of the group page")

sys.exit(1 if failed else 0)
