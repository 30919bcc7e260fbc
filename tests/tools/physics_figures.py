#!/usr/bin/env python3
"""physics_figures.py FOLDER: computes the figures of app/doc/physics.md from the equations of that page and writes them as SVG.
They are kept in app/doc/figures; run it again after a change:  python3 tests/tools/physics_figures.py app/doc/figures"""

import math
import pathlib
import sys

INK, GREY, BLUE, RED, GREEN, ORANGE = "#222", "#999", "#1f6fb4", "#c0392b", "#2e8b57", "#d98200"


class Figure:
    """A drawing whose coordinates are those of the plot: x to the right, y upwards."""

    def __init__(self, x, y, width=480, height=320, margin=44):
        (self.x0, self.x1), (self.y0, self.y1) = x, y
        self.width, self.height, self.margin, self.parts = width, height, margin, []

    def at(self, x, y):
        across = self.margin + (x - self.x0) / (self.x1 - self.x0) * (self.width - 2 * self.margin)
        up = self.height - self.margin - (y - self.y0) / (self.y1 - self.y0) * (self.height - 2 * self.margin)
        return across, up

    def line(self, points, colour=INK, width=1.6, dash="", fill="none", closed=False):
        path = " ".join("%.1f,%.1f" % self.at(*point) for point in points)
        kind = "polygon" if closed else "polyline"
        style = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<{kind} points="{path}" fill="{fill}" stroke="{colour}" stroke-width="{width}"{style}/>')

    def dot(self, x, y, colour=INK, radius=3.5):
        self.parts.append('<circle cx="%.1f" cy="%.1f" r="%.1f" fill="%s"/>' % (*self.at(x, y), radius, colour))

    def text(self, x, y, words, colour=INK, anchor="start", dx=0, dy=0, size=13):
        across, up = self.at(x, y)
        self.parts.append(
            f'<text x="{across + dx:.1f}" y="{up + dy:.1f}" fill="{colour}" font-size="{size}" text-anchor="{anchor}">{words}</text>'
        )

    def axes(self, across, up, ticks_x=(), ticks_y=()):
        self.line([(self.x0, self.y0), (self.x1, self.y0)], GREY, 1)
        self.line([(self.x0, self.y0), (self.x0, self.y1)], GREY, 1)
        self.text(self.x1, self.y0, across, GREY, "end", 0, 34, 12)
        self.text(self.x0, self.y1, up, GREY, "start", -30, -10, 12)
        for tick in ticks_x:
            self.text(tick, self.y0, f"{tick:g}", GREY, "middle", 0, 16, 11)
        for tick in ticks_y:
            self.text(self.x0, tick, f"{tick:g}", GREY, "end", -6, 4, 11)

    def save(self, folder, name):
        head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" font-family="DejaVu Sans, sans-serif">'
        back = f'<rect width="{self.width}" height="{self.height}" fill="white"/>'
        (folder / f"{name}.svg").write_text("\n".join([head, back, *self.parts, "</svg>"]) + "\n")


def steps(low, high, count=120):
    return [low + (high - low) * i / count for i in range(count + 1)]


def crossing(gap, low, high):
    """The root of a function that falls from low to high."""
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if gap(middle) > 0 else (low, middle)
    return 0.5 * (low + high)


def emission():
    f = Figure((-1.5, 1.5), (-3.0, 0.6))
    f.axes("x (m)", "c t (m)", (-1, 0, 1), (-3, -2, -1, 0))
    place = lambda t: -0.9 + 0.6 * (t + 3.0) if t < -1.5 else 0.0 - 0.5 * (t + 1.5)
    eye = (0.9, 0.0)
    f.line([(place(t), t) for t in steps(-3, 0.6)], BLUE, 2.4)
    f.line([(eye[0] - 2.4, -2.4), eye, (1.5, -0.6)], ORANGE, 1.4, "5 4")
    sent = crossing(lambda t: (eye[1] - t) - abs(eye[0] - place(t)), -3, 0)
    f.dot(place(sent), sent, RED)
    f.dot(*eye, ORANGE)
    f.text(place(sent), sent, "emission event", RED, "end", -8, 4)
    f.text(*eye, "observation event", ORANGE, "middle", 0, -10)
    f.text(place(-2.6), -2.6, "world line", BLUE, "start", 8, 6)
    f.text(1.45, -0.7, "past light cone", ORANGE, "end", 0, 22)
    return f


def catch_up(offset, beta, speed=0.9, radius=1.0):
    """A point of a disc that a cushion throws back at `beta`: where it leaves its leg and where it has joined the next, (ct, x).
    The contact is at (0, 0), the centre turns there in the paper's convention when the signal arrives."""
    gamma = 1 / math.sqrt(1 - beta * beta)
    root = math.sqrt(1 + (gamma * beta) ** 2)
    turn_x = -radius * (root - gamma * beta)  # y = R (sqrt(1 + u²) − u)
    turn_t = -turn_x  # light from the contact
    incoming = lambda t: turn_x + beta * (t - turn_t) + offset / gamma
    outgoing = lambda t: turn_x - beta * (t - turn_t) + offset / gamma
    leaves = crossing(lambda t: abs(incoming(t)) - t, -20, 20)
    # In the outgoing rest frame the point runs straight to its place at `speed`.
    boost = lambda t, x: (gamma * (t + beta * x), gamma * (x + beta * t))
    a_t, a_x = boost(leaves - turn_t, incoming(leaves) - turn_x)
    b_t = a_t + abs(offset - a_x) / speed
    b = (gamma * (b_t - beta * offset) + turn_t, gamma * (offset - beta * b_t) + turn_x)
    return incoming, outgoing, leaves, b


def bounce():
    f = Figure((-2.6, 0.6), (-1.6, 2.6), 480, 400)
    f.axes("x (radii; cushion at 0)", "c t (radii)", (-2, -1, 0), (-1, 0, 1, 2))
    f.line([(0, -1.6), (0, 2.6)], GREEN, 2.5)
    f.line([(-2.4, 2.4), (0, 0)], ORANGE, 1.3, "5 4")
    for offset, colour in ((-1, BLUE), (-0.5, BLUE), (0, INK), (0.5, BLUE), (1, BLUE)):
        incoming, outgoing, leaves, (b_t, b_x) = catch_up(offset, 0.5)
        f.line([(incoming(t), t) for t in steps(-1.6, leaves)], colour, 1.8)
        f.line([(incoming(leaves), leaves), (b_x, b_t)], RED, 1.8)
        f.line([(outgoing(t), t) for t in steps(b_t, 2.6)], colour, 1.8)
        if offset:
            f.dot(incoming(leaves), leaves, RED, 2.5)
    f.dot(0, 0, ORANGE)
    f.text(0, 0, "contact", ORANGE, "start", 8, 14)
    f.text(-1.75, 1.6, "its signal, at c", ORANGE, "end", -4, 0)
    f.text(-0.75, -1.45, "points of the puck", BLUE, "start", 0, 0)
    f.text(0.04, 2.4, "cushion", GREEN, "start", 0, 0)
    return f


def sampled():
    f = Figure((-1.2, 1.2), (-2.4, 0.3))
    f.axes("x (m)", "c t (m)", (-1, 0, 1), (-2, -1, 0))
    place = lambda t: 0.35 * math.sin(2.2 * t) - 0.3
    rows = [(place(t), t) for t in steps(-2.4, 0, 12)]
    f.line([(place(t), t) for t in steps(-2.4, 0.3)], GREY, 1, "3 3")
    f.line(rows, BLUE, 1.8)
    for row in rows:
        f.dot(*row, BLUE, 2.6)
    eye = (0.9, 0)
    f.line([(eye[0] - 2.1, -2.1), eye], ORANGE, 1.4, "5 4")
    straight = lambda t: next(a[0] + (b[0] - a[0]) * (t - a[1]) / (b[1] - a[1]) for a, b in zip(rows, rows[1:]) if a[1] <= t <= b[1])
    sent = crossing(lambda t: -t - abs(eye[0] - straight(t)), -2.39, -1e-9)
    f.dot(straight(sent), sent, RED)
    f.dot(*eye, ORANGE)
    f.text(straight(sent), sent, "found by bisection", RED, "start", 9, 12)
    f.text(rows[2][0], rows[2][1], "samples of one vertex", BLUE, "start", 10, 4)
    f.text(*eye, "eye", ORANGE, "middle", 0, -9)
    return f


def celerity():
    f = Figure((-2.6, 2.6), (0, 2.9))
    f.axes("room displacement of a step, dx/c (s)", "room time dT (s)", (-2, -1, 0, 1, 2), (1, 2))
    f.line([(-2.6, 2.6), (0, 0), (2.6, 2.6)], ORANGE, 1.3, "5 4")
    f.line([(x, math.sqrt(1 + x * x)) for x in steps(-2.6, 2.6)], BLUE, 2.4)
    for x in (0.0, 0.75, 2.0):
        t = math.sqrt(1 + x * x)
        f.line([(0, 0), (x, t)], INK, 1)
        f.dot(x, t, RED)
        f.text(x, t, f"w = {x:g} c, v = {x / t:.2f} c", RED, "end" if x > 1 else "start", -10 if x > 1 else 7, 4 if x > 1 else 18, 12)
    f.text(-2.2, 2.75, "all events that are one second of the walker's own time ahead", BLUE, "start", 0, -8, 12)
    f.text(-1.5, 1.5, "light", ORANGE, "end", -8, 8)
    return f


def platform():
    f = Figure((-0.4, 3.2), (-1.8, 1.8))
    f.axes("x (units of c²/g)", "c t", (0, 1, 2, 3), (-1, 0, 1))
    f.line([(0, 0), (1.8, 1.8)], RED, 1.6, "6 4")
    f.line([(0, 0), (1.8, -1.8)], RED, 1.6, "6 4")
    for start, colour in ((0.5, BLUE), (1.0, INK), (1.5, BLUE), (2.0, BLUE)):
        reach = math.asinh(1.8 / start)
        f.line([(start * math.cosh(e), start * math.sinh(e)) for e in steps(-reach, reach)], colour, 2.4 if start == 1 else 1.4)
    for e in (-0.6, -0.3, 0.3, 0.6):
        f.line([(0, 0), (3.1 * math.cosh(e) / math.cosh(0.6), 3.1 * math.sinh(e) / math.cosh(0.6))], GREY, 0.8)
    f.dot(1, 0, INK)
    f.text(1, 0, "head", INK, "start", 8, 14)
    f.text(2.05, 0, "the room", BLUE, "start", 8, 14)
    f.text(1.35, 1.5, "horizon: light from here", RED, "end", -4, -4)
    f.text(1.35, 1.3, "never catches up", RED, "end", -12, -2)
    return f


def ellipse(cx, cy, rx, ry):
    return [(cx + rx * math.cos(a), cy + ry * math.sin(a)) for a in steps(0, 2 * math.pi, 90)]


def contact():
    f = Figure((-3.2, 3.2), (-2.0, 2.0), 480, 320)
    beta, b = 0.6, 0.9
    gamma = 1 / math.sqrt(1 - beta * beta)
    dmin = math.sqrt(4 - b * b) / gamma
    for sign, colour in ((-1, BLUE), (1, RED)):
        x, y = sign * dmin / 2, sign * b / 2
        f.line(ellipse(x, y, 1 / gamma, 1), colour, 2)
        f.line([(x - sign * 0.95, y), (x - sign * 0.15, y)], colour, 1.6)
        f.dot(x, y, colour)
        f.line(ellipse(x + sign * 1.5, y, 1 / gamma, 1), colour, 0.8, "4 4")
    f.dot(0, 0, ORANGE)
    f.text(0, 0, "C", ORANGE, "start", 8, -4, 15)
    f.line([(-dmin / 2, -1.6), (dmin / 2, -1.6)], INK, 1)
    f.text(0, -1.6, "d = sqrt((R₁+R₂)² − b²)/γ′", INK, "middle", 0, 18)
    f.line([(-2.9, -b / 2), (-2.9, b / 2)], INK, 1)
    f.text(-2.85, 0, "b", INK, "start", 6, 4)
    f.text(0, 1.85, "the frame of equal and opposite speeds, when they touch", GREY, "middle", 0, -12, 12)
    return f


def kick():
    f = Figure((0, 0.999), (0, 95))
    f.axes("speed of the striking puck, v/c", "angle (degrees)", (0, 0.25, 0.5, 0.75), (0, 30, 60, 90))
    psi = math.asin(0.5)
    struck = lambda beta: math.atan(2 * math.tan(psi) / (1 / math.sqrt(1 - beta * beta) + 1))
    rows = steps(0, 0.999)
    f.line([(beta, 90 - math.degrees(psi)) for beta in rows], BLUE, 2)
    f.line([(beta, math.degrees(struck(beta))) for beta in rows], RED, 2)
    f.line([(beta, 90 - math.degrees(psi) + math.degrees(struck(beta))) for beta in rows], INK, 2)
    f.line([(0, 90), (0.999, 90)], GREY, 1, "4 4")
    f.text(0.03, 62, "θ₁ = 90° − ψ: the puck that strikes", BLUE)
    f.text(0.03, 33, "θ₂: the puck that is struck", RED)
    f.text(0.03, 84, "between them: always less than 90°", INK)
    return f


def spin():
    f = Figure((0, 3), (0, 2.2))
    f.axes("spin j/(k m)", "", (0, 1, 2, 3), (0, 1, 2))
    rows = steps(0, 3)
    f.line([(j, j / math.sqrt(1 + j * j)) for j in rows], BLUE, 2.2)
    f.line([(j, 0.5 + 0.5 * math.sqrt(1 + j * j)) for j in rows], RED, 2.2)
    f.line([(0, 1), (3, 1)], GREY, 1, "4 4")
    f.text(2.95, 0.72, "speed of the rim f (of c)", BLUE, "end")
    f.text(2.2, 1.95, "mass M(j)/m, k = 1/2", RED, "end")
    return f


def friction():
    f = Figure((0, 1.9), (0, 2.4))
    f.axes("x (units of c²/a)", "c t (units of c²/a)", (0, 0.5, 1, 1.5), (0, 1, 2))
    u0 = 2.0
    place = lambda t: math.sqrt(1 + u0 * u0) - math.sqrt(1 + max(u0 - t, 0) ** 2)
    f.line([(place(t), t) for t in steps(0, 2.4)], BLUE, 2.4)
    f.line([(0, 0), (1.9, 1.9)], ORANGE, 1.2, "5 4")
    for t in (0.5, 1.0, 1.5, 2.0):
        f.dot(place(t), t, BLUE, 2.8)
        u = u0 - t
        words = f"u = {u:g}, v = {u / math.sqrt(1 + u * u):.2f} c" if u > 0 else "at rest"
        f.text(place(t), t, words, INK, "start", 10, 14, 12)
    f.text(1.6, 1.75, "light", ORANGE, "end", 0, 0)
    return f


def jams():
    f = Figure((-4, 4), (-2.8, 2.8), 480, 362)
    for x, y in ((-1, 0), (1, 0), (0, 1.73), (0, -1.73)):
        f.line(ellipse(x, y, 1, 1), BLUE, 1.8)
        f.dot(x, y, BLUE, 2)
    for (ax, ay), (bx, by) in (((-1, 0), (1, 0)), ((-1, 0), (0, 1.73)), ((1, 0), (0, 1.73)), ((-1, 0), (0, -1.73)), ((1, 0), (0, -1.73))):
        f.dot((ax + bx) / 2, (ay + by) / 2, RED, 3.2)
    f.line([(-3.4, 0), (-2.2, 0)], INK, 2)
    f.text(-3.4, 0, "blow", INK, "start", 0, -8)
    f.text(0, -3.1, "each red contact takes plastic kicks until none closes", RED, "middle")
    return f


def polygons():
    f = Figure((-2.6, 2.6), (-1.8, 1.8))
    beta = 0.5
    gamma = 1 / math.sqrt(1 - beta * beta)

    def bar(half, angle):
        corners = [(-0.15, -half), (0.15, -half), (0.15, half), (-0.15, half)]
        turn = lambda x, y: (x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle))
        return [(turn(*corner)[0] / gamma, turn(*corner)[1]) for corner in corners]

    left, right = bar(0.8, math.radians(-8)), bar(1.3, math.radians(14))
    corner = max(left)
    (ax, ay), (bx, by) = right[3], right[0]
    on_side = ax + (bx - ax) * (corner[1] - ay) / (by - ay)
    shift = corner[0] - on_side
    right = [(x + shift, y) for x, y in right]
    for shape, colour, sign in ((left, BLUE, -1), (right, RED, 1)):
        f.line(shape, colour, 2, closed=True, fill="#eef4fa" if sign < 0 else "#fbeeee")
        f.line([(x + sign * 0.9, y) for x, y in shape], colour, 0.8, "4 4", closed=True)
    f.dot(*corner, ORANGE)
    f.text(*corner, "a corner pierces a side", ORANGE, "start", 12, -40)
    f.text(0, 1.7, "the frame of equal speeds, when they touch", GREY, "middle", 0, -10, 12)
    return f


def aberration():
    f = Figure((0, 180), (0, 180))
    f.axes("direction at rest (degrees from ahead)", "direction seen (degrees)", (0, 45, 90, 135, 180), (0, 45, 90, 135, 180))
    for beta, colour in ((0.0, GREY), (0.5, GREEN), (0.8, BLUE), (0.95, RED)):
        seen = lambda a: math.degrees(2 * math.atan(math.sqrt((1 - beta) / (1 + beta)) * math.tan(math.radians(a) / 2)))
        rows = [(a, seen(a)) for a in steps(0, 179.9)]
        f.line(rows, colour, 2)
        f.text(135, seen(135), f"{beta:g} c", colour, "start", 6, 14)
    return f


def shock(push, sound):
    """The speed of a shock in a relaxed rod whose end is set to the speed `push`, and the own length behind it, of the relaxed
    one. With p = (a/2)(1/s² − 1): matter is kept, U = γV/(γ − s), and energy and momentum, U = p/(V(1 + p))."""
    gamma = 1 / math.sqrt(1 - push * push)
    pressure = lambda s: sound * sound / 2 * (1 / (s * s) - 1)
    by_matter = lambda s: gamma * push / (gamma - s)
    s = crossing(lambda s: pressure(s) / (push * (1 + pressure(s))) - by_matter(s), 1e-3, 1 - 1e-12)
    return by_matter(s), s


def soft():
    f = Figure((0, 0.9), (0, 1))
    f.axes("speed of the pushed end (of c)", "of c; of the relaxed length", (0, 0.3, 0.6, 0.9), (0, 0.25, 0.5, 0.75, 1))
    for sound, colour in ((0.25, GREEN), (0.5, BLUE), (0.7, RED)):
        rows = [(v, *shock(v, sound)) for v in steps(0.002, 0.9)]
        f.line([(v, speed) for v, speed, _ in rows], colour, 2)
        f.line([(v, length) for v, _, length in rows], colour, 1.4, "5 4")
        f.text(0.31, shock(0.31, sound)[0], f"sound {sound:g} c", colour, "start", 6, 17)
    f.text(0.25, 0.9, "speed of the shock", GREY, "start", 0, 0)
    f.text(0.08, 0.1, "dashed: own length behind it", GREY, "start", 0, 0)
    return f


FIGURES = (emission, bounce, sampled, celerity, platform, contact, kick, spin, friction, jams, polygons, soft, aberration)

if __name__ == "__main__":
    for figure in FIGURES:
        figure().save(pathlib.Path(sys.argv[1]), figure.__name__)
