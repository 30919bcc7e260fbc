"""How far apart two pictures of one scene are: outlines in pixels, colours, digits."""

import io

import numpy
from PIL import Image

REACH_PX = 5  # of the strip along which an outline is looked for, to each side
MARKED = 12  # of 255: what differs by more than this is something else


def pixels(data):
    return numpy.asarray(Image.open(io.BytesIO(data) if isinstance(data, bytes) else data).convert("RGB")).astype(float)


def widened(where, by):
    wide = where.copy()
    for axis in (0, 1):
        narrow = wide.copy()
        for step in range(1, by + 1):
            wide |= numpy.roll(narrow, step, axis) | numpy.roll(narrow, -step, axis)
    return wide


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
    return widened(edge, 1)


def lies_over(mine, other):
    """Where something lies over the other picture: its colour is none of those around this pixel in mine. An outline that is
    a pixel off is no such place."""
    around = [numpy.roll(numpy.roll(mine, dy, 0), dx, 1) for dy in (-1, 0, 1) for dx in (-1, 0, 1)]
    least, most = numpy.minimum.reduce(around), numpy.maximum.reduce(around)
    return ((other < least - MARKED) | (other > most + MARKED)).any(axis=2)


def along(picture, points):
    """The picture's light at places between pixels."""
    height, width = picture.shape[:2]
    x = numpy.clip(points[..., 0] - 0.5, 0, width - 1.001)
    y = numpy.clip(points[..., 1] - 0.5, 0, height - 1.001)
    i, j = x.astype(int), y.astype(int)
    u, v = (x - i)[..., None], (y - j)[..., None]
    return (1 - v) * ((1 - u) * picture[j, i] + u * picture[j, i + 1]) + v * ((1 - u) * picture[j + 1, i] + u * picture[j + 1, i + 1])


def strips(rim):
    """Places across a closed line, REACH_PX to each side, and the way across at each of its points."""
    tangent = numpy.roll(rim, -1, 0) - numpy.roll(rim, 1, 0)
    normal = numpy.stack([-tangent[:, 1], tangent[:, 0]], 1)
    normal /= numpy.maximum(numpy.linalg.norm(normal, axis=1), 1e-9)[:, None]
    return rim[:, None, :] + numpy.linspace(-REACH_PX, REACH_PX, 41)[None, :, None] * normal[:, None, :], normal


def stands_out(strip):
    return (strip.max(axis=1) - strip.min(axis=1)).max(axis=1).mean() >= 25


def free_of(covered, strip):
    """At which points of a line nothing covers it in one of the pictures."""
    return along(covered[..., None].astype(float), strip).max(axis=(1, 2)) == 0


def shifts_px(mine, other, rim, covered):
    """How far the round outline of a body in one picture is from that in the other, across it: for each sixth of its rim the
    shift by which a strip along it fits best. Sixths that are covered by half, or do not stand out, are left out."""
    strip, normal = strips(rim)
    first, is_free = along(mine, strip), free_of(covered, strip)
    tried = numpy.linspace(-2, 2, 81)
    misfits = numpy.array([((first - along(other, strip + shift * normal[:, None, :])) ** 2).mean(axis=(1, 2)) for shift in tried])
    found = []
    for sixth in numpy.array_split(numpy.arange(len(rim)), 6):
        free = sixth[is_free[sixth]]
        if len(free) >= len(sixth) / 2 and stands_out(first[free]):
            found.append(abs(tried[misfits[:, free].mean(axis=1).argmin()]))
    return found


def moves_px(mine, other, border, inside, covered):
    """How far a face in one picture is from that in the other, to the side and up: a straight edge along a row of pixels is
    known to half of one only, so its whole border and what is painted inside are fitted together. Nothing if the border is
    covered by half."""
    strip, _ = strips(border)
    strip = strip[free_of(covered, strip)]
    if len(strip) < len(border) / 2 or not stands_out(along(mine, strip)):
        return []
    inside = inside[along(covered[..., None].astype(float), inside)[:, 0] == 0]
    places = numpy.concatenate([strip.reshape(-1, 2), inside])
    first, tried, found = along(mine, places), numpy.linspace(-2, 2, 81), numpy.zeros(2)
    for way in numpy.eye(2):
        misfits = [((first - along(other, places + found + move * way)) ** 2).mean() for move in tried]
        found += tried[numpy.argmin(misfits)] * way
    return list(abs(found))


def unlike_digits(mine, other, places):
    """Which share of these places on a clock's face is lit in one picture and dark in the other."""
    lights = [along(picture, places).max(axis=-1) for picture in (mine, other)]
    least, most = min(light.min() for light in lights), max(light.max() for light in lights)
    return (numpy.abs(lights[0] - lights[1]) > 0.4 * max(most - least, 40)).mean()
