"""Another observer of a page, for page_pictures.py."""

import csv
import math

from chromium_page import UNDRAWN
from page_engine_frames import in_board_axes


def check_observer(page, out, name, table):
    """Another observer of the page OUT/NAME.html sees the centres of all bodies where `carom export --observer` has written
    them into the table OUT/TABLE."""
    rows = [row for row in csv.DictReader((out / table).open()) if row["status"] == "seen"]
    rows = rows[:: max(1, len(rows) // 60)]
    worst = fastest = 0.0
    page.open(UNDRAWN, out / f"{name}.html")
    known_s, held = page.call("about")["known_s"], 0
    for row in rows:
        number = {key: float(value) for key, value in row.items() if key not in ("body", "status")}
        beta = [number[f"beta_{axis}"] for axis in "xyz"]
        at = page.call("observer", {"beta": beta, "position_m": [number[f"{axis}_m"] for axis in "xyz"], "t_s": number["t_s"]})
        # The export goes on until light of something unrecorded arrives; the page holds at the last moment that was seen.
        if number["t_s"] > known_s:
            assert at["held"] and at["event"][0] == known_s, (at, row)
            held += 1
            continue
        assert not at["held"], (at, row)
        seen = page.call("engine", None, "mono", page.call("body", row["body"]), [[0, 0, 0]])[0]
        worst = max(worst, math.dist(in_board_axes(at["headFromBoard"], beta, seen), [number[f"seen_{axis}_m"] for axis in "xyz"]))
        fastest = max(fastest, math.hypot(*beta))
    print(f"{table}: {len(rows) - held} centres, {held} beyond the record held, the observer up to {fastest:.3f} c: within "
          f"{worst:.2g} m of carom export")
    assert len(rows) - held > 20 and worst < 1e-9
