"""structure.py ROOT: checks that no header includes itself through others, that the dependencies between
modules (the folders with a carom_module in their CMakeLists.txt) have no circle, that a module includes only
from modules that it uses, that no type is defined twice, that no class has more than 15 members
or 12 private functions but those named here with a reason, that app/doc/figures/modules.svg shows these modules, that none holds more than 14 pairs of a header and a source, 25
includes between them or 28 files of tests, that 70 % of the pairs of more than 100 lines have a test file of
their name, that each decoder of a device has a fuzz target and is among the tests of hostile data, and that every source file has the format of .clang-format. Prints a line for each folder and one for each of the rules."""

import pathlib
import re
import shutil
import subprocess
import sys

import modules

MOST_PAIRS, MOST_TESTS, MOST_ARROWS = 14, 28, 25
MOST_MEMBERS, MOST_PRIVATE = 15, 12
LONG, LEAST_TESTED = 100, 0.7  # lines of a header and its source; the share of those that long with a test of their name
# The classes that are larger, and why.
LARGE = {
    "BodyDrawer": "buffers, programs and uniforms of one pass of drawing",
    "Corners": "the state of one search for a contact of corners",
    "DueQueue": "a data structure: the operations on one heap",
    "LinkedPlay": "both sides of one protocol",
    "StudyRun": "a function for each step of a participant",
}
TOPS = ["app", "cave", "devices", "engine"]
root = pathlib.Path(sys.argv[1])
files = [file for top in TOPS for file in (root / top).rglob("*") if file.suffix in (".h", ".cpp", ".glsl")]
failed = False


def fail(*words):
    global failed
    failed = True
    print("FAILED:", *words)


def circles(arrows):
    """Returns the circles of a graph, one for each edge that leads back."""
    found, done, path = [], set(), []

    def visit(node):
        if node in path:
            found.append([*path[path.index(node) :], node])
        elif node not in done:
            path.append(node)
            for other in sorted(arrows.get(node, ())):
                visit(other)
            path.pop()
            done.add(node)

    for node in sorted(arrows):
        visit(node)
    return found


def pair(path):
    """Returns the name of a file without its ending: a .h, its .cpp and its .glsl are a pair."""
    return str(path).rsplit(".", 1)[0]


uses, errors = modules.modules_used(root)
for error in errors:
    fail(error)

# The pairs that each pair includes.
includes = {}
for file in files:
    own = pair(file.relative_to(root))
    for found in re.findall(r'(?m)^#include "((?:app|cave|devices|engine)/[^"]+)"', file.read_text()):
        if pair(found) != own:
            includes.setdefault(own, set()).add(pair(found))

found = circles(includes)
for circle in found:
    fail("these include each other in a circle:", " -> ".join(circle))
print(f"include circles {len(found)}")

found = circles(uses)
for circle in found:
    fail("these modules use each other in a circle:", " -> ".join(circle))
print(f"module circles {len(found)}")
if not found and (root / "app/doc/figures/modules.svg").read_text() != modules.figure(uses):
    fail("app/doc/figures/modules.svg shows other modules than the lists: python3 tests/modules.py .")


def below(module, seen):
    """Returns the modules that a module uses, directly or through others."""
    for other in uses.get(module, ()):
        if other not in seen:
            seen.add(other)
            below(other, seen)
    return seen


forbidden = 0
for own in sorted(includes):
    module = str(pathlib.PurePath(own).parent)
    if module not in uses:  # the program itself, in app/, may use any module
        continue
    for other in sorted(includes[own]):
        folder = str(pathlib.PurePath(other).parent)
        if folder not in {module} | below(module, set()) and not folder.startswith(module + "/"):  # lists of a module
            forbidden += 1
            fail(f"{own} includes {other}, but {module} does not use its folder")
print(f"includes of modules that are not used {forbidden}")

# Two types of one name in one namespace are ill-formed as soon as one source sees both headers.
defined = {}
for file in files:
    if file.suffix == ".h":
        for name in re.findall(r"(?m)^(?:struct|class|union|enum class|enum)(?: alignas\(\w+\))? (\w+)(?: final)?(?: :[^;{]*)? ?\{", file.read_text()):
            defined.setdefault(name, []).append(str(file.relative_to(root)))
twice = {name: places for name, places in defined.items() if len(places) > 1}
for name, places in sorted(twice.items()):
    fail(f"the type {name} is defined in", " and in ".join(sorted(places)))
print(f"types {len(defined)}, defined twice {len(twice)}")



def bodies(text):
    """Returns the name and the body of each class in a source."""
    text = re.sub(r'"(?:[^"\\\n]|\\.)*"', '""', re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.DOTALL))
    found = []
    for match in re.finditer(r"\bclass (\w+(?:::\w+)*)(?: final)?(?: :[^;{]*)? ?\{", text):
        if re.search(r"enum\s*$", text[: match.start()]):
            continue
        depth, end = 1, match.end()
        while depth:
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        found.append((match.group(1), text[match.end() : end - 1]))
    return found


def size_of(body):
    """Returns the number of a class's members and of its private functions."""
    flat, depth = [], 0
    for letter in body:
        depth -= letter == "}"
        if depth == 0:
            flat.append(letter)
        depth += letter == "{"
    flat = re.sub(r"\b(public|private|protected)\s*:", r";@\1;", "".join(flat))
    members = private = 0
    access = "private"
    for statement in re.sub(r"\{\}(?!\s*[;,])", "{};", flat).split(";"):
        statement = " ".join(statement.split())
        if statement.startswith("@"):
            access = statement[1:]
            continue
        for _ in range(3):
            statement = re.sub(r"<[^<>]*>", "", statement)
        if re.match(r"(friend|using|typedef|static_assert|static constexpr|inline static)\b", statement) or not statement:
            continue
        head = statement.split("=")[0]
        if re.match(r"(template )?(struct|class|enum)\b", head):
            members += len(re.findall(r"\{\} \w", head))
        elif "(" in head:
            private += access == "private"
        else:
            members += 1 + head.count(",")
    return members, private


sizes = {}
for file in files:
    if file.suffix in (".h", ".cpp"):
        for name, body in bodies(file.read_text()):
            sizes[name] = max(sizes.get(name, (0, 0)), size_of(body))
large = {name for name, (members, private) in sizes.items() if members > MOST_MEMBERS or private > MOST_PRIVATE}
for name in sorted(large):
    print(f"{sizes[name][0]:3} members, {sizes[name][1]:2} private functions in {name}: {LARGE.get(name, 'FAILED')}")
for name in sorted(large - LARGE.keys()):
    fail(f"{name} has more than {MOST_MEMBERS} members or {MOST_PRIVATE} private functions")
for name in sorted(LARGE.keys() - large):
    print(f"{name} is no longer large: take it from the list")
print(f"classes {len(sizes)}, large {len(large)}")

files_of = {}
for file in files:
    if file.suffix in (".h", ".cpp"):
        files_of.setdefault(str(file.parent.relative_to(root)), set()).add(file.stem)
for folder in sorted(files_of, key=lambda folder: (-len(files_of[folder]), folder)):
    print(f"{len(files_of[folder]):3} pairs in {folder}")
    inside = sum(str(pathlib.PurePath(other).parent) == folder for stem in files_of[folder] for other in includes.get(f"{folder}/{stem}", ()))
    if len(files_of[folder]) > MOST_PAIRS or inside > MOST_ARROWS:
        fail(f"{folder} holds {len(files_of[folder])} pairs that include each other {inside} times, expected {MOST_PAIRS} and {MOST_ARROWS} at most")

# The tests of a module lie in the folder of its name.
tested = {}
for file in (root / "tests").rglob("*_test.cpp"):
    tested.setdefault(str(file.parent.relative_to(root / "tests")), set()).add(file.stem.removesuffix("_test"))
for folder in [*uses, *TOPS]:
    count = sum(file.is_file() for file in (root / "tests" / folder).glob("*"))
    if count > MOST_TESTS:
        fail(f"tests/{folder} holds {count} files, expected {MOST_TESTS} at most")
namesakes = sum(len(names & tested.get(folder, set())) for folder, names in files_of.items())
print(f"pairs {sum(map(len, files_of.values()))}, with a test file of their name {namesakes}")
lines_of = {}
for file in files:
    if file.suffix in (".h", ".cpp"):
        lines_of[pair(file.relative_to(root))] = lines_of.get(pair(file.relative_to(root)), 0) + file.read_text().count("\n")
long = [pathlib.PurePath(name) for name, lines in lines_of.items() if lines > LONG]
untested = [name for name in long if name.name not in tested.get(str(name.parent), set())]
share = 1 - len(untested) / len(long)
print(f"pairs of more than {LONG} lines {len(long)}, with a test file of their name {100 * share:.1f} %")
if share < LEAST_TESTED:
    fail(f"{100 * share:.1f} % of the pairs of more than {LONG} lines have a test file of their name, expected {100 * LEAST_TESTED:.0f} % at least: "
         + ", ".join(map(str, sorted(untested))))

# What a device sends is hostile until it is decoded.
targets = (root / "tests/fuzz/CMakeLists.txt").read_text()
hostile = "".join(file.read_text() for file in (root / "tests/devices").rglob("hostile_*_test.cpp"))
decoders = sorted((root / "devices").rglob("*_decoder.h"))
for file in decoders:
    if not re.search(rf"carom_fuzz\(fuzz_{file.stem}\b", targets):
        fail(f"{file.relative_to(root)} has no fuzz target: tests/fuzz/fuzz_{file.stem}.cpp and its line in tests/fuzz/CMakeLists.txt")
    if f"/{file.name}\"" not in hostile:
        fail(f"{file.relative_to(root)} is in no tests/devices/…/hostile_*_test.cpp")
print(f"decoders of devices {len(decoders)}, each with a fuzz target and among the tests of hostile data")

formatter = shutil.which("clang-format-14") or shutil.which("clang-format")
version = subprocess.run([formatter, "--version"], capture_output=True, text=True).stdout if formatter else ""
sources = sorted(file for file in [*files, *(root / "tests").rglob("*")] if file.suffix in (".h", ".cpp"))
if "version 14." not in version:  # others format some lines otherwise
    print("clang-format 14 is not here: the format is not checked")
elif subprocess.run([formatter, "--dry-run", "-Werror", *map(str, sources)]).returncode != 0:
    fail("these files are not in the format of .clang-format: clang-format -i FILE")
print(f"{len(includes)} pairs that include others, {len(sources)} files")
sys.exit(1 if failed else 0)
