#!/usr/bin/env python3
"""tidy.py ROOT [--all]: checks by clang-tidy what .clang-tidy lists: all headers of engine and devices, as one source; with --all
also each source of theirs, on all processors, which takes some minutes."""

import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

root = pathlib.Path(sys.argv[1]).resolve()
tidy = shutil.which("clang-tidy-14") or shutil.which("clang-tidy")
if not tidy:
    print("clang-tidy is not installed: nothing is checked")
    sys.exit(77)
found = subprocess.run(["pkg-config", "--cflags", "eigen3", "hidapi-hidraw", "libusb-1.0"], capture_output=True, text=True)
options = ["--", "-std=c++20", "-xc++", f"-I{root}", *found.stdout.split()]


def check(source):
    """Returns what the checks say of a source. Errors of the compiler do not count: clang 14 knows less of C++20 than GCC."""
    run = subprocess.run([tidy, "--quiet", f"--config-file={root}/.clang-tidy", str(source), *options], capture_output=True, text=True)
    return [line for line in run.stdout.splitlines() if re.search(r": (warning|error): .*\[(bugprone|readability)-", line)]


headers = sorted(header.relative_to(root) for top in ("engine", "devices") for header in (root / top).rglob("*.h"))
with tempfile.NamedTemporaryFile("w", suffix=".cpp") as every:
    every.write("".join(f'#include "{header}"\n' for header in headers))
    every.flush()
    said = check(every.name)
sources = []
if "--all" in sys.argv:
    sources = sorted(source for top in ("engine", "devices") for source in (root / top).rglob("*.cpp"))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        said += [line for lines in pool.map(check, sources) for line in lines]
for line in sorted(set(said)):
    print(line)
print(f"{len(headers)} headers, {len(sources)} sources")
sys.exit(1 if said else 0)
