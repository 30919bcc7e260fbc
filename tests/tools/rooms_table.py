#!/usr/bin/env python3
"""rooms_table.py CAROM FOLDER [EXPECTED]: imports the rooms of other programs that EXPECTED (FOLDER/corners.jsonl) names and
prints how far the corners of the rigs are from those there, which another program read from the same files. Each row of
EXPECTED: "file" (with "#ROOM" or a "room" where the file has several), "lower_left", "lower_right", "upper_left" in metres,
x right, y up, z back, from the file's origin; "preview" marks walls that are to be left out. Ends with 1 where a wall is
missing, is one too many, or is off by over 0.01 mm."""

import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

NEAR_MM = 0.01
UNITS_M = {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048}
DIRECTIONS = {
    "right": (1, 0, 0), "left": (-1, 0, 0), "up": (0, 1, 0), "down": (0, -1, 0), "back": (0, 0, 1), "forward": (0, 0, -1),
}
CORNERS = ("lower_left", "lower_right", "upper_left")


def expected_rooms(path):
    """Returns the rows of each (file, room)."""
    rooms = collections.defaultdict(list)
    for line in path.read_text().splitlines():
        row = json.loads(line)
        file, _, room = row["file"].partition("#")
        rooms[file, room or row.get("room", "")].append(row)
    return rooms


def in_metres(rig, place):
    """Returns a place of the rig in metres, x right, y up, z back."""
    unit = UNITS_M[rig["unit"]]
    axes = [DIRECTIONS[axis.split("-")[1]] for axis in rig["axes"].split()]
    return [unit * sum(value * axis[i] for value, axis in zip(place, axes)) for i in range(3)]


def stated_shift(rig, text):
    """Returns by how much the rig's comments say that everything is moved, in metres."""
    said = re.search(r"moved by \[([^]]*)\] (\w+)", text)
    return in_metres(rig, [float(number) for number in said[1].split(",")]) if said else [0.0] * 3


def difference_mm(wall, row):
    return max(1000.0 * sum((a - b) ** 2 for a, b in zip(mine, row[corner])) ** 0.5 for corner, mine in zip(CORNERS, wall))


def compare(carom, file, room, rows, folder):
    """Returns the words of one line of the table, and whether all is as expected."""
    rig_file = folder / "room.toml"
    rig_file.unlink(missing_ok=True)
    made = subprocess.run([carom, "import", file, "-o", rig_file] + (["--room", room] if room else []),
                          capture_output=True, text=True, check=False)
    if made.returncode != 0:
        return ["refused: " + "; ".join(line for line in made.stderr.splitlines() if line.startswith("error"))], False
    text = rig_file.read_text()
    rig = tomllib.loads(text)
    shift = stated_shift(rig, text)
    walls = [[[a - b for a, b in zip(in_metres(rig, wall[corner]), shift)] for corner in CORNERS]
             for wall in rig["wall"] if "lower_left" in wall]
    wanted = [row for row in rows if not row.get("preview")]
    worst = max((min(difference_mm(wall, row) for wall in walls) for row in wanted), default=0.0)
    strange = max((min(difference_mm(wall, row) for row in wanted) for wall in walls), default=0.0)
    checked = subprocess.run([carom, "check", rig_file], capture_output=True, text=True, check=False)
    errors = sum(line.startswith("error") for line in checked.stderr.splitlines())
    warnings = sum(line.startswith("warning") for line in checked.stderr.splitlines())
    # The two eyes of a screen may be two rows there and one wall in stereo here.
    eyes = sum(2 if wall.get("stereo", "mono") not in ("mono", "left", "right") else 1 for wall in rig["wall"])
    as_expected = worst <= NEAR_MM and strange <= NEAR_MM and errors == 0 and len(walls) <= len(rows)
    left_out = sum("left out" in line for line in made.stderr.splitlines())
    return [f"{len(wanted)}", f"{len(walls)} ({eyes})", f"{len(rows) - len(wanted)}", f"{left_out}",
            f"{worst:.4f}", f"{strange:.4f}", " ".join(f"{1000 * value:.0f}" for value in shift), f"{errors}/{warnings}"], as_expected


def main():
    carom, rooms = sys.argv[1], pathlib.Path(sys.argv[2])
    expected = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else rooms / "corners.jsonl"
    print("file | rows | walls (pictures) | previews | left out | farthest row, wall mm | moved mm | errors/warnings of check")
    whole, count = True, 0
    with tempfile.TemporaryDirectory() as folder:
        for (file, room), rows in expected_rooms(expected).items():
            words, as_expected = compare(carom, rooms / file, room, rows, pathlib.Path(folder))
            print(" | ".join([file + (" #" + room if room else "")] + words), "" if as_expected else " <- differs")
            whole = whole and as_expected
            count += sum(not row.get("preview") for row in rows)
    print(f"{count} walls: " + ("all as expected" if whole else "there are differences"))
    return 0 if whole and count > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
