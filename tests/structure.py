"""structure.py ROOT: no header includes itself by way of others, and every source file is in the format of .clang-format.

Which rooms a room may include from is not checked here: the build gives it no path to others (CMakeLists.txt)."""

import pathlib
import re
import shutil
import subprocess
import sys

root = pathlib.Path(sys.argv[1])
ROOMS = ["app", "cave", "devices", "engine"]
files = [file for room in ROOMS for file in (root / room).rglob("*") if file.suffix in (".h", ".cpp", ".glsl")]
failed = False


def module(path):
    """A .h, its .cpp and its .glsl are one module."""
    return str(path).rsplit(".", 1)[0]


includes = {}
for file in files:
    own = module(file.relative_to(root))
    for found in re.findall(r'(?m)^#include "((?:app|cave|devices|engine)/[^"]+)"', file.read_text()):
        if module(found) != own:
            includes.setdefault(own, set()).add(module(found))

done, path = set(), []


def visit(own):
    global failed
    if own in path:
        failed = True
        print("these include each other in a circle:", " -> ".join([*path[path.index(own) :], own]))
    elif own not in done:
        path.append(own)
        for other in sorted(includes.get(own, ())):
            visit(other)
        path.pop()
        done.add(own)


for own in sorted(includes):
    visit(own)

formatter = shutil.which("clang-format")
sources = sorted(file for file in [*files, *(root / "tests").rglob("*")] if file.suffix in (".h", ".cpp"))
if not formatter:
    print("clang-format is not here: the format is not checked")
elif subprocess.run([formatter, "--dry-run", "-Werror", *map(str, sources)]).returncode != 0:
    failed = True
    print("these files are not in the format of .clang-format: clang-format -i FILE")
print(f"{len(includes)} modules, {len(sources)} files")
sys.exit(1 if failed else 0)
