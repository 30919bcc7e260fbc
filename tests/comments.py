#!/usr/bin/env python3
"""comments.py ROOT: checks that comments read as plain English. Of the comment lines of each top folder at most 0.3 % may have a
turn of phrase that a field engineer would not write (ODD), and none is longer than 110 columns. Prints the share of each folder
and its lines over 110 columns; with --all each such line."""

import pathlib
import re
import sys

# "what is …" for a thing that has a name, "nobody", "so many", "of which" for "whose".
ODD = re.compile(r"\b(what (is|are|was|were)|whoever|whomever|nobody|so many|of (which|whom))\b", re.IGNORECASE)
MOST_ODD_SHARE = 0.003
MOST_COLUMNS = 110
TOPS = ["engine", "devices", "cave", "app"]
SUFFIXES = {".h", ".cpp", ".glsl", ".vert", ".frag"}
root = pathlib.Path(sys.argv[1])
failed = False


def comments(text):
    """Returns the lines of comments with their numbers: whole lines, and those behind code."""
    for number, line in enumerate(text.splitlines(), 1):
        found = re.search(r"(?:^|\s)(///?<? .*)$", re.sub(r'"(?:[^"\\]|\\.)*"', '""', line))
        if found:
            yield number, line, found[1]


for top in TOPS:
    lines = odd = long = 0
    for file in sorted(file for file in (root / top).rglob("*") if file.suffix in SUFFIXES):
        for number, line, comment in comments(file.read_text()):
            lines += 1
            is_odd, is_long = bool(ODD.search(comment)), len(line) > MOST_COLUMNS
            odd, long = odd + is_odd, long + is_long
            if "--all" in sys.argv and (is_odd or is_long):
                print(f"{file.relative_to(root)}:{number}: {line.strip()}")
    print(f"{top}: {lines} comment lines, {100 * odd / lines:.2f} % odd, {long} over {MOST_COLUMNS} columns")
    if long:
        failed = True
        print(f"FAILED: {top} has comment lines over {MOST_COLUMNS} columns: tests/comments.py . --all")
    if odd > MOST_ODD_SHARE * lines:
        failed = True
        print(f"FAILED: {top} has more odd comments than {100 * MOST_ODD_SHARE:g} %: tests/comments.py . --all")
sys.exit(1 if failed else 0)
