"""page_pictures.py OUT NAME[:SHARE] … NAME@TABLE …: the pictures of the page OUT/NAME.html are those that carom replay captured in OUT/NAME. In
some frames of each, for every wall and eye: the outline of every puck within half a pixel, found in both pictures along its
seen rim; colours within 3 of 255 on the mean, but for a pixel along edges; the solve of the graphics card beside that of
the kernel in double; and nobody is called. The page draws no panels and no marks of light: up to SHARE of a picture below its
upper panels may be theirs. Of NAME@TABLE, another observer of the page (page_observer.py). All in one browser."""

import io
import math
import os
import pathlib
import sys

import numpy
from PIL import Image

from chromium_page import OpenPage, UNDRAWN, content
from page_observer import check_observer

out = pathlib.Path(sys.argv[1])
FRAMES = int(os.environ.get("CAROM_PAGE_FRAMES", 2))  # of each session
MOST_PX, MOST_COLOUR = 0.5, 3.0


def pixels(data):
    return numpy.asarray(Image.open(io.BytesIO(data) if isinstance(data, bytes) else data).convert("RGB")).astype(float)


def near_edges(picture):
    """Where the picture changes from pixel to pixel, and a pixel around it."""
    grey = picture.mean(axis=2)
    edge = numpy.zeros(grey.shape, bool)
    for axis in (0, 1):
        step = numpy.abs(numpy.diff(grey, axis=axis)) > 12
        if axis == 0:
            edge[1:] |= step
            edge[:-1] |= step
        else:
            edge[:, 1:] |= step
            edge[:, :-1] |= step
    wide = edge.copy()
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            wide |= numpy.roll(numpy.roll(edge, dy, 0), dx, 1)
    return wide


def along(picture, points):
    """The picture's light at places between pixels."""
    height, width = picture.shape[:2]
    x = numpy.clip(points[..., 0] - 0.5, 0, width - 1.001)
    y = numpy.clip(points[..., 1] - 0.5, 0, height - 1.001)
    i, j = x.astype(int), y.astype(int)
    u, v = (x - i)[..., None], (y - j)[..., None]
    return (1 - v) * ((1 - u) * picture[j, i] + u * picture[j, i + 1]) + v * ((1 - u) * picture[j + 1, i] + u * picture[j + 1, i + 1])


def shift_px(mine, other, rim):
    """How far the outline of a puck in one picture is from that in the other, across it: the shift by which a strip of
    five pixels on each side of each sixth of its rim fits best; the largest of them. None where nothing stands out."""
    count = len(rim)
    tangent = numpy.roll(rim, -1, 0) - numpy.roll(rim, 1, 0)
    normal = numpy.stack([-tangent[:, 1], tangent[:, 0]], 1)
    normal /= numpy.maximum(numpy.linalg.norm(normal, axis=1), 1e-9)[:, None]
    away = numpy.linspace(-5, 5, 41)
    strip = rim[:, None, :] + away[None, :, None] * normal[:, None, :]
    first, worst = along(mine, strip), None
    shifts = numpy.linspace(-2, 2, 81)
    misfits = []
    for shift in shifts:
        second = along(other, strip + shift * normal[:, None, :])
        misfits.append(((first - second) ** 2).mean(axis=(1, 2)))
    misfits = numpy.array(misfits)
    contrast = (first.max(axis=1) - first.min(axis=1)).max(axis=1)
    for sixth in numpy.array_split(numpy.arange(count), 6):
        if contrast[sixth].mean() < 25:
            continue
        best = abs(shifts[misfits[:, sixth].mean(axis=1).argmin()])
        worst = best if worst is None else max(worst, best)
    return worst


def projected(wall, eye_in_room, seen):
    """Seen places (from the eye, room axes) as pixels of a wall, from its upper left."""
    left, right, upper = (numpy.array(wall[name]) for name in ("lowerLeft_m", "lowerRight_m", "upperLeft_m"))
    across, up = right - left, upper - left
    normal = numpy.cross(across, up)
    normal /= numpy.linalg.norm(normal)
    eye = numpy.array(eye_in_room)
    distance = normal @ (eye - left)
    ahead = -(seen @ normal)
    hit = eye + seen * (distance / ahead)[:, None]
    share = numpy.stack([(hit - left) @ across / (across @ across), (hit - left) @ up / (up @ up)], 1)
    width, height = wall["pixels"]
    return numpy.stack([share[:, 0] * width, (1 - share[:, 1]) * height], 1), ahead


def eyes_in_room(file):
    about, bulk = content(file)
    of = about["frames"]["numbers"]
    planes = numpy.frombuffer(bulk, numpy.uint8, 8 * of["count"], of["at"]).reshape(8, -1).T.copy()
    column = numpy.bitwise_xor.accumulate(planes.view(numpy.uint64).ravel()).view(numpy.float64).reshape(-1, of["rows"])
    return about, {int(n): {"left": column[8:11, i], "right": column[18:21, i], "mono": column[28:31, i]}
                   for i, n in enumerate(column[0])}


def check(page, name, share=0.0):
    about, eyes = eyes_in_room(out / f"{name}.html")
    ready_s = page.open(UNDRAWN, out / f"{name}.html")
    numbers = page.call("frames")
    chosen = [numbers[i * (len(numbers) - 1) // (FRAMES - 1)] for i in range(min(FRAMES, len(numbers)))]
    worst_px = worst_share = worst_colour = worst_solve = worst_solve_px = 0.0
    pictures = outlines = points = 0
    for number in chosen:
        for wall in about["walls"]:
            for eye in wall["eyes"]:
                mine = pixels(page.wall(number, wall["name"], eye))
                other = pixels(out / name / f"{wall['name']}-{eye}-{number:06}.png")
                assert mine.shape == other.shape, (mine.shape, other.shape)
                calm = ~(near_edges(mine) | near_edges(other))
                top = mine.shape[0] * 3 // 10  # above it are the walls' panels
                apart = numpy.abs(mine - other).max(axis=2)[top:]
                marks = calm[top:] & (apart > 12 if share else False)
                worst_share = max(worst_share, marks.mean())
                worst_colour = max(worst_colour, numpy.abs(mine - other)[top:][calm[top:] & ~marks].mean())
                pictures += 1
                for body in range(1, 1 + about["pucks"]):
                    puck = about["game"]["pucks"][body - 1]["numbers"]
                    circle = [[puck[0] * math.cos(a), puck[0] * math.sin(a), puck[1] / 2]
                              for a in numpy.linspace(0, 2 * math.pi, 72, endpoint=False)]
                    card, twin = page.call("seen", number, eye, body, circle), page.call("twin", number, eye, body, circle)
                    if any(place is None for place in card):
                        continue
                    card, twin = numpy.array(card), numpy.array(twin)
                    rim, ahead = projected(wall, eyes[number][eye], card)
                    exact, _ = projected(wall, eyes[number][eye], twin)
                    if (ahead < 0.05).any():
                        continue
                    worst_solve = max(worst_solve, numpy.abs(card - twin).max())
                    width, height = wall["pixels"]
                    inside = (rim[:, 0] > 8) & (rim[:, 1] > top + 8) & (rim[:, 0] < width - 8) & (rim[:, 1] < height - 8)
                    points += len(circle)
                    if not inside.all():
                        continue
                    worst_solve_px = max(worst_solve_px, numpy.abs(rim - exact).max())
                    shift = shift_px(mine, other, rim)
                    if shift is not None:
                        if shift >= MOST_PX:
                            print(f"{name} frame {number} {wall['name']} {eye} {about['bodies'][body]['name']}: {shift:.2f} px at {rim.mean(axis=0)}")
                        worst_px = max(worst_px, shift)
                        outlines += 1
    called = {url for url in page.requested() if not url.startswith("data:")}
    strange = {url for url in called if url.split("#")[0] != f"file://{page.file}"}
    print(f"{name}: {len(chosen)} frames, {pictures} pictures: {outlines} outlines within {worst_px:.3f} px, colours within "
          f"{worst_colour:.2f} of 255 ({100 * worst_share:.1f} % panels and marks); the card's solve of {points} places within {worst_solve:.2g} m, {worst_solve_px:.2g} px of "
          f"the kernel; ready after {ready_s:.1f} s, {(out / f'{name}.html').stat().st_size / 1e6:.2f} MB; called {len(strange)}")
    assert outlines and worst_px < MOST_PX and worst_colour < MOST_COLOUR and worst_share <= share
    assert worst_solve < 1e-5 and worst_solve_px < 0.01 and not strange, strange


with OpenPage() as opened:
    for one in sys.argv[2:]:
        if "@" in one:
            check_observer(opened, out, *one.split("@"))
            continue
        of, _, its_share = one.partition(":")
        check(opened, of, float(its_share or 0))
