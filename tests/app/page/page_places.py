"""What a page holds of places: the eyes of its frames, the meshes of its pucks, the faces of its clocks; where a wall has them,
and where the page's graphics card and its kernel in double see them."""

import base64
import math

import numpy

from chromium_page import content

CLOCK = 9  # the paint (cave/scene/scene_part.h)
KINDS = {"f64": (numpy.float64, 8), "f32": (numpy.float32, 4), "i16": (numpy.int16, 2), "u32": (numpy.uint32, 4), "u8": (numpy.uint8, 1)}


def column(bulk, of):
    """A column of numbers, as app/page/page_bulk.h packs it."""
    kind, size = KINDS[of["kind"]]
    planes = numpy.frombuffer(bulk, numpy.uint8, size * of["count"], of["at"]).reshape(size, -1).T.copy()
    if of["kind"] in ("f64", "f32"):
        whole = planes.view({8: numpy.uint64, 4: numpy.uint32}[size]).ravel()
        return numpy.bitwise_xor.accumulate(whole).view(kind)
    return numpy.cumsum(planes.view(kind).ravel(), dtype=kind)


class Places:
    """Of one page."""

    def __init__(self, file):
        self.about, self.bulk = content(file)
        rows = column(self.bulk, self.about["frames"]["numbers"]).reshape(-1, self.about["frames"]["numbers"]["rows"])
        self.eyes = {int(n): {"left": rows[8:11, i], "right": rows[18:21, i], "mono": rows[28:31, i]} for i, n in enumerate(rows[0])}

    def vertices(self, part):
        """The places, normals and painted places of a part's vertices."""
        mesh = self.about["meshes"][part["mesh"]]
        places = numpy.array(mesh["middle_m"])[:, None] + column(self.bulk, mesh["places"]).reshape(3, -1) / 32767 * numpy.array(mesh["half_m"])[:, None]
        return places.T, column(self.bulk, mesh["normals"]).reshape(3, -1).T / 32767, column(self.bulk, mesh["surfaces"]).reshape(3, -1).T.astype(float)

    def puck(self, body):
        """The vertices of a puck."""
        parts = [part for part in self.about["parts"] if part["body"] == body and not part["isDecal"]]
        return numpy.concatenate([self.vertices(part)[0] for part in parts])

    def rim(self, body):
        """The upper edge of a round puck."""
        radius_m, height_m = self.about["game"]["pucks"][body - 1]["numbers"][:2]
        turn = numpy.linspace(0, 2 * math.pi, 72, endpoint=False)
        return numpy.stack([radius_m * numpy.cos(turn), radius_m * numpy.sin(turn), numpy.full(72, height_m / 2)], 1)

    def faces(self):
        """The faces of all clocks at rest: of each the middle of its field, the way to the right, and its width."""
        found = {}
        for part in self.about["parts"]:
            if part["paint"] != CLOCK or part["body"] != 0:
                continue
            for place, normal, surface in zip(*self.vertices(part)):
                right = numpy.cross([0, 0, 1], normal)
                aside = (surface[:2] / [4, 1] - 0.5) * surface[2] * [1, 0.4]
                middle = place - right * aside[0] - [0, 0, aside[1]]
                found.setdefault((*numpy.round(middle, 2), *numpy.round(normal, 1)), (middle, right, surface[2]))
        return list(found.values())


def on_face(face, across, up):
    """Places on a clock's face, from -0.5 to 0.5 of its field."""
    middle, right, width_m = face
    return middle + numpy.multiply.outer(across * width_m, right) + numpy.multiply.outer(up * 0.4 * width_m, [0, 0, 1])


def border_of(face):
    """The border of a clock's whole side (cave/scene/table_model.cpp), 18 places to an edge."""
    edge = numpy.linspace(-0.5, 0.5, 18, endpoint=False)
    half = numpy.full(18, 0.5)
    return on_face(face, numpy.concatenate([edge, half, -edge, -half]) / 0.9, numpy.concatenate([-half, edge, half, -edge]) * 0.46 / 0.36)


def projected(wall, eye_in_room, seen):
    """Seen places (from the eye, room axes) as pixels of a wall, from its upper left, and how far ahead of it they are."""
    left, right, upper = (numpy.array(wall[name]) for name in ("lowerLeft_m", "lowerRight_m", "upperLeft_m"))
    across, up = right - left, upper - left
    normal = numpy.cross(across, up)
    normal /= numpy.linalg.norm(normal)
    eye = numpy.array(eye_in_room)
    ahead = -(seen @ normal)
    hit = eye + seen * (normal @ (eye - left) / ahead)[:, None]
    share = numpy.stack([(hit - left) @ across / (across @ across), (hit - left) @ up / (up @ up)], 1)
    width, height = wall["pixels"]
    return numpy.stack([share[:, 0] * width, (1 - share[:, 1]) * height], 1), ahead


def seen(page, number, eye, body, places):
    """Where the graphics card and the kernel see places of a body, in the head's frame; not a number where they are unseen."""
    letters = page.run("""
      const [number, eye, body, places] = arguments, { carom } = window;
      const rows = ["seen", "twin"].flatMap(of => carom[of](number, eye, body, places)).map(at => at || [NaN, NaN, NaN]);
      const bytes = new Uint8Array(Float64Array.from(rows.flat()).buffer);
      let text = "";
      for (let i = 0; i < bytes.length; i += 4096) text += String.fromCharCode(...bytes.subarray(i, i + 4096));
      return btoa(text)""", number, eye, body, places.tolist())
    return numpy.frombuffer(base64.b64decode(letters)).reshape(2, -1, 3)
