"""page_pictures.py OUT NAME[:SHARE] … NAME@TABLE …: the pictures of the page OUT/NAME.html are those that carom replay has captured
in OUT/NAME. In some frames of each, for every wall and eye: the outlines of pucks and clocks within half a pixel, found in
both pictures along their seen rims; the same digits on the clocks; colours within 3 of 255 on the mean, but for a pixel along
edges; and for every vertex of every puck the solve of the graphics card beside that of the kernel in double. Nobody is called.
The page draws nothing of what lies over the walls' pictures: up to SHARE (a hundredth) of a picture below its upper panels may be covered by
plates, flags and hands. Of NAME@TABLE, another observer of the page (page_observer.py). All in one browser."""

import os
import pathlib
import sys

import numpy

from chromium_page import OpenPage, UNDRAWN
from page_observer import check_observer
from page_places import Places, border_of, on_face, projected, seen
from picture_matching import REACH_PX, along, lies_over, moves_px, near_edges, pixels, shifts_px, unlike_digits, widened

out = pathlib.Path(sys.argv[1])
FRAMES = int(os.environ.get("CAROM_PAGE_FRAMES", 2))  # of each session
MOST_PX, MOST_COLOUR, MOST_SOLVE_M, MOST_SOLVE_PX, MOST_UNLIKE = 0.5, 3.0, 1e-5, 0.01, 0.005
PANELS = 0.3  # of a wall's height, from above
USUAL_SHARE = 0.01
LEAST_FREE = 0.75  # of the parts of outlines; where more than USUAL_SHARE may be covered, of these and of the clocks
LEAST_FREE_MARKED = 0.3
READABLE_PX = 20  # a clock's face is at least so wide


class Found:
    """What was found in the pictures of a session."""

    def __init__(self, name, share):
        self.name, self.share = name, share
        self.shifts, self.unlike, self.colours, self.shares, self.away_m, self.away_px = ([] for _ in range(6))
        self.other_digits = []  # between the pictures of two moments
        self.points = self.pictures = self.parts = self.clocks = 0

    def told(self):
        return (f"{self.name}: {self.pictures} pictures: {len(self.shifts)} of {self.parts} parts of outlines within {max(self.shifts):.3f} px; "
                f"{len(self.unlike)} of {self.clocks} clocks alike but for {100 * max(self.unlike, default=0):.2f} % (of another moment: up to "
                f"{100 * max(self.other_digits, default=0):.0f} %); colours within {max(self.colours):.2f} of 255, up to "
                f"{100 * max(self.shares):.1f} % of a picture covered; the card's solve of {self.points} vertices within "
                f"{max(self.away_m):.2g} m, {max(self.away_px):.2g} px of the kernel")

    def check(self):
        least = LEAST_FREE if self.share <= USUAL_SHARE else LEAST_FREE_MARKED
        assert len(self.shifts) > least * self.parts > 0 and max(self.shifts) < MOST_PX
        assert max(self.colours) < MOST_COLOUR and max(self.shares) <= self.share and len(self.unlike) >= least * self.clocks
        assert max(self.unlike, default=0) < MOST_UNLIKE and max(self.away_m) < MOST_SOLVE_M and max(self.away_px) < MOST_SOLVE_PX
        assert not self.unlike or max(self.other_digits) > 2 * MOST_UNLIKE, "the test of digits is blind"


def within(rim, wall, top):
    width, height = wall["pixels"]
    margin = REACH_PX + 3
    return (rim[:, 0] > margin).all() and (rim[:, 1] > top + margin).all() and (rim[:, 0] < width - margin).all() and (rim[:, 1] < height - margin).all()


class Frame:
    """One stored frame: where one eye sees pucks and clocks in it."""

    def __init__(self, page, places, number, eye):
        self.number, self.eye, self.at = number, eye, places.eyes[number][eye]
        pucks = range(1, 1 + places.about["pucks"])
        self.pucks = {body: seen(page, number, eye, body, numpy.concatenate([places.rim(body), places.puck(body)])) for body in pucks}
        across, up = (side.ravel() for side in numpy.meshgrid(numpy.linspace(-0.48, 0.48, 60), numpy.linspace(-0.45, 0.45, 24)))
        self.clocks = [[seen(page, number, eye, 0, of)[0] for of in (border_of(face), on_face(face, across, up))] for face in places.faces()]


def check_solve(frame, wall, found):
    for card, twin in frame.pucks.values():
        there = ~numpy.isnan(card[:, 0])
        assert (there == ~numpy.isnan(twin[:, 0])).all()
        places, ahead = projected(wall, frame.at, card[there])
        exact, _ = projected(wall, frame.at, twin[there])
        before = (ahead > 0.05) & (places > 0).all(axis=1) & (places < wall["pixels"]).all(axis=1)
        found.points += int(before.sum())
        found.away_m.append(numpy.abs(card - twin)[there].max(initial=0))
        found.away_px.append(numpy.abs(places - exact)[before].max(initial=0))


def outlines(frame, wall, top):
    """The rims of pucks and the borders of clocks that turn to the eye, as pixels of a wall; of the clocks also the places of
    their digits."""
    rims = [(card[:72], None) for card, _ in frame.pucks.values()] + [(border, field) for border, field in frame.clocks]
    for rim, field in rims:
        if numpy.isnan(rim).any():
            continue
        line, ahead = projected(wall, frame.at, rim)
        x, y = line.T
        turned = (x * numpy.roll(y, -1) - numpy.roll(x, -1) * y).sum() < 0
        if (ahead < 0.05).any() or not within(line, wall, top) or (field is not None and not turned):
            continue
        yield line, None if field is None else projected(wall, frame.at, field)[0]


def check_picture(frame, wall, mine, other, before, found):
    """`before`: the page's picture of another moment."""
    assert mine.shape == other.shape, (mine.shape, other.shape)
    top = int(PANELS * mine.shape[0])
    marks = lies_over(mine, other)
    calm = ~(near_edges(mine) | near_edges(other) | marks)
    found.shares.append(marks[top:].mean())
    found.colours.append(numpy.abs(mine - other)[top:][calm[top:]].mean())
    found.pictures += 1
    covered = widened(marks, 1)
    for line, field in outlines(frame, wall, top):
        shifts = shifts_px(mine, other, line, covered) if field is None else moves_px(mine, other, line, field, covered)
        if shifts and max(shifts) >= MOST_PX:
            print(f"{found.name} frame {frame.number} {wall['name']} {frame.eye}: {max(shifts):.2f} px at {line.mean(axis=0)}")
        found.shifts += shifts
        found.parts += 6 if field is None else 2
        if field is None or numpy.ptp(line[:, 0]) <= READABLE_PX:
            continue
        found.clocks += 1
        # A wrong digit looks like something that lies over the clock: only where such is expected a clock is left out.
        if found.share <= USUAL_SHARE or along(covered[..., None].astype(float), field).max() == 0:
            found.unlike.append(unlike_digits(mine, other, field))
            if before is not None:
                found.other_digits.append(unlike_digits(before, other, field))


def check(page, name, share):
    places, found = Places(out / f"{name}.html"), Found(name, share)
    ready_s = page.open(UNDRAWN, out / f"{name}.html")
    numbers = page.call("frames")
    chosen = [numbers[i * (len(numbers) - 1) // (FRAMES - 1)] for i in range(min(FRAMES, len(numbers)))]
    before = {}
    for number in chosen:
        for eye in sorted({eye for wall in places.about["walls"] for eye in wall["eyes"]}):
            frame = Frame(page, places, number, eye)
            for wall in (wall for wall in places.about["walls"] if eye in wall["eyes"]):
                check_solve(frame, wall, found)
                mine = pixels(page.wall(number, wall["name"], eye))
                other = pixels(out / name / f"{wall['name']}-{eye}-{number:06}.png")
                check_picture(frame, wall, mine, other, before.get((wall["name"], eye)), found)
                before[wall["name"], eye] = mine
    strange = {url for url in page.requested() if not url.startswith("data:") and url.split("#")[0] != f"file://{page.file}"}
    print(f"{found.told()}; ready after {ready_s:.1f} s, {(out / f'{name}.html').stat().st_size / 1e6:.2f} MB; called {len(strange)}")
    found.check()
    assert not strange, strange


with OpenPage() as opened:
    for one in sys.argv[2:]:
        if "@" in one:
            check_observer(opened, out, *one.split("@"))
            continue
        of, _, its_share = one.partition(":")
        check(opened, of, float(its_share or USUAL_SHARE))
