#!/usr/bin/env python3
"""modules.py ROOT: draws app/doc/figures/modules.svg from the CMakeLists.txt of all modules: each stands one floor above the
highest of those that it uses. Run it after a change of modules; structure.py compares the figure with the lists."""

import pathlib
import re
import sys

COLOURS = {"engine": "#dcebf7", "devices": "#e2f2e3", "cave": "#fbeedb", "app": "#f6e1e4"}
TOPS = list(COLOURS)


def modules_used(root):
    """Returns the modules that each module uses, by the lists, and those lists' errors."""
    uses, errors = {}, []
    for listing in sorted(file for top in TOPS for file in (root / top).rglob("CMakeLists.txt")):
        for module, rest in re.findall(r"(?m)^carom_module\((\S+)([^)]*)\)", listing.read_text()):
            named = re.search(r"\bUSES\s+(.*?)(?=\s+[A-Z_]{4,}\b|\s*$)", rest, re.DOTALL)
            uses[module] = set(named.group(1).split()) if named else set()
            errors += [f"{module} uses {other}, which is no folder" for other in uses[module] if not (root / other).is_dir()]
    return uses, errors


def floors(uses):
    """Returns the floor of each module, 0 for those that use none."""
    floor = {}

    def of(module):
        if module not in floor:
            floor[module] = 1 + max((of(other) for other in uses.get(module, ())), default=-1)
        return floor[module]

    for module in uses:
        of(module)
    return floor


def figure(uses):
    """Returns the drawing: a row for each floor, a column for each top folder."""
    floor = floors(uses)
    highest = max(floor.values())
    wide = {top: max([1] + [sum(floor[m] == f and m.startswith(top + "/") for m in floor) for f in range(highest + 1)]) for top in TOPS}
    left, at = {}, 40
    for top in TOPS:
        left[top], at = at, at + 96 * wide[top] + 16
    rows = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {at} {40 * highest + 84}" font-family="DejaVu Sans, sans-serif">',
            f'<rect width="{at}" height="{40 * highest + 84}" fill="white"/>']
    for top in TOPS:
        rows.append(f'<text x="{left[top]}" y="22" font-size="15" font-weight="bold">{top}</text>')
    for level in range(highest + 1):
        y = 40 * (highest - level) + 36
        rows.append(f'<text x="10" y="{y + 20}" font-size="12" fill="#777">{level}</text>')
        for top in TOPS:
            for i, module in enumerate(sorted(m for m in floor if floor[m] == level and m.startswith(top + "/"))):
                x = left[top] + 96 * i
                used = ", ".join(sorted(uses[module])) or "nothing"
                rows.append(f'<g id="{module}"><title>{module} uses {used}</title><rect x="{x}" y="{y}" width="90" height="30" rx="4" '
                            f'fill="{COLOURS[top]}" stroke="#888"/><text x="{x + 45}" y="{y + 20}" font-size="12" '
                            f'text-anchor="middle">{module.split("/")[1]}</text></g>')
    return "\n".join([*rows, "</svg>"]) + "\n"


if __name__ == "__main__":
    project = pathlib.Path(sys.argv[1])
    (project / "app/doc/figures/modules.svg").write_text(figure(modules_used(project)[0]))
