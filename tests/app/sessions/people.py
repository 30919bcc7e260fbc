"""Several people in one room, for people.sh.

people.py write FOLDER CONFIG   writes walks, rigs and scenarios
people.py prove FILE THRUST     proves, from the session file alone, that each frame has one room time, that everybody's own
                                time follows from it, that the fastest keeps the display's time, that all presents are
                                spacelike and all world lines timelike
"""

import math
import pathlib
import random
import re
import sqlite3
import sys

LIGHT_M_S = 1.42
HZ = 100.0
PEOPLE = {"anna": (-0.2, 0.3), "ben": (-1.1, 0.2), "cleo": (0.6, 0.5)}  # where they walk, in the room
SPEEDS_M_S = {"anna": 0.2, "ben": 0.7, "cleo": 1.1}


def walk(name, seconds):
    """Samples of a head that goes to and fro, smoothly, with sway and a tracker's noise of 0.1 mm."""
    rng = random.Random(name)
    x0, z0 = PEOPLE[name]
    reach_m = 0.3
    omega = SPEEDS_M_S[name] / reach_m
    phase = rng.uniform(0.0, 2.0 * math.pi)
    lines = ["time_s,x_m,y_m,z_m,qx,qy,qz,qw"]
    for i in range(int(seconds * HZ)):
        t_s = i / HZ
        x = x0 + reach_m * math.sin(omega * t_s + phase) + rng.gauss(0.0, 1e-4)
        y = 1.65 + 0.01 * math.sin(9.0 * t_s) + rng.gauss(0.0, 1e-4)
        z = z0 + 0.5 * reach_m * math.sin(0.6 * omega * t_s) + rng.gauss(0.0, 1e-4)
        lines.append(f"{t_s:.3f},{x:.6f},{y:.6f},{z:.6f},0,0,0,1")
    return "\n".join(lines) + "\n"


def rig(names):
    text = 'title = "People"\nunit = "m"\naxes = "x-right y-up z-back"\ndisplay_hz = 30.0\n'
    for name in names:
        text += f'[[viewer]]\nname = "{name}"\ntracker = "{name}"\n'
        text += f'[[tracker]]\nname = "{name}"\nkind = "recorded"\nsource = "{name}.csv"\n'
        text += f'[[wall]]\nname = "front-{name}"\nlower_left = [-1.5, 0.0, -1.5]\nlower_right = [1.5, 0.0, -1.5]\n'
        text += f'upper_left = [-1.5, 3.0, -1.5]\npixels = [32, 32]\nviewer = "{name}"\n'
        text += "window = { position = [0, 0], size = [32, 32] }\n"
    return text


def write(folder, config):
    for name in PEOPLE:
        (folder / f"{name}.csv").write_text(walk(name, 10.0))
    names = list(PEOPLE)
    (folder / "two.toml").write_text(rig(names[:2]))
    (folder / "three.toml").write_text(rig(names))
    game = (config / "scenarios/three-pucks.toml").read_text()
    game = re.sub(r"(?ms)^\[tour\].*?(?=^\[\w|\Z)", "", game)
    (folder / "none.toml").write_text(game)
    # The strongest thrust that there is, to the right, away from ben, who is farthest from anna; then back.
    most_m_s2 = LIGHT_M_S**2 / 2.0
    tour = '\n[tour]\nstarts = "at once"\n'
    for leg, way in enumerate((1, -1, 1)):
        tour += f"[[tour.leg]]\nfor_s = 0.8\nthrust_m_s2 = [{way * most_m_s2}, 0.0, 0.0]\n"
    (folder / "half.toml").write_text(game + tour)


def minkowski(a, b):
    """The interval between two events, c²Δt² − Δr² (m²)."""
    return (LIGHT_M_S * (a[0] - b[0])) ** 2 - sum((p - q) ** 2 for p, q in zip(a[1:], b[1:]))


def rotated(q, v):
    w, x, y, z = q
    u = (x, y, z)
    cross = lambda a, b: (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    t = tuple(2.0 * c for c in cross(u, v))
    return tuple(v[i] + w * t[i] + cross(u, t)[i] for i in range(3))


def expect(holds, what):
    if not holds:
        print("FAILED:", what)
        sys.exit(1)


def presents(platform, people, frame):
    """Expects all presents to be spacelike, and simultaneous in the room, where the heads are."""
    u, q = platform["u"], platform["q"]
    gamma = math.sqrt(1.0 + sum(c * c for c in u))
    names = list(people)
    for i, one in enumerate(names):
        for other in names[i + 1 :]:
            a, b = people[one], people[other]
            apart = minkowski(a["event"], b["event"])
            expect(apart < 0.0, f"frame {frame}: the presents of {one} and {other} are {apart} m² apart, not spacelike")
            dt = LIGHT_M_S * (b["event"][0] - a["event"][0])
            dr = [p - r for p, r in zip(b["event"][1:], a["event"][1:])]
            in_room_m = gamma * dt - sum(c * d for c, d in zip(u, dr))
            expect(abs(in_room_m) < 1e-9, f"frame {frame}: {one} and {other} are {in_room_m} m of light apart in the room")
            # The room's coordinates of the displacement: the board's, boosted back, then turned.
            along = sum(c * d for c, d in zip(u, dr))
            back = [d + u[k] * (along / (gamma + 1.0) - dt) for k, d in enumerate(dr)]
            room = rotated((q[0], -q[1], -q[2], -q[3]), tuple(back))
            place = [p - r for p, r in zip(b["place"], a["place"])]
            off_m = max(abs(p - r) for p, r in zip(room, place))
            expect(off_m < 1e-9, f"frame {frame}: {other} is {off_m} m beside the place in the room")


def prove(file, thrust):
    db = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
    platforms, frames = {}, {}
    for row in db.execute("SELECT frame, room_s, u_x, u_y, u_z, qw, qx, qy, qz, thrust_x_m_s2 FROM platform"):
        expect(row[0] not in platforms, f"frame {row[0]} has two room times")
        platforms[row[0]] = {"room_s": row[1], "u": row[2:5], "q": row[5:9], "thrust": row[9]}
    for row in db.execute(
        "SELECT frame, name, t_s, x_m, y_m, z_m, proper_time_s, room_x_m, room_y_m, room_z_m, lapse FROM viewer"
    ):
        frames.setdefault(row[0], {})[row[1]] = {
            "event": row[2:6],
            "own_s": row[6],
            "place": row[7:10],
            "lapse": row[10],
        }
    display_s = dict(db.execute("SELECT number, display_s FROM frame WHERE number >= 0"))
    worst = {"own time": 0.0, "display": 0.0}
    least_lapse, most_pace = 1.0, 1.0
    for frame in sorted(frames)[1:]:
        now, before = frames[frame], frames[frame - 1]
        expect(set(now) == set(before), f"frame {frame}: somebody is missing")
        step_s = display_s[frame] - display_s[frame - 1]
        room_s = platforms[frame]["room_s"] - platforms[frame - 1]["room_s"]
        presents(platforms[frame], now, frame)
        steps = []
        for name, here in now.items():
            there = before[name]
            expect(minkowski(here["event"], there["event"]) > 0.0, f"frame {frame}: {name} outruns light")
            expect(here["event"][0] > there["event"][0], f"frame {frame}: {name} goes back in time")
            own_s = here["own_s"] - there["own_s"]
            way_s = math.dist(here["place"], there["place"]) / LIGHT_M_S
            told_s = math.sqrt((here["lapse"] * room_s) ** 2 - way_s**2)
            worst["own time"] = max(worst["own time"], abs(own_s - told_s))
            least_lapse, most_pace = min(least_lapse, here["lapse"]), max(most_pace, own_s / step_s)
            steps.append(own_s)
        worst["display"] = max(worst["display"], abs(min(steps) - step_s))
    expect(worst["own time"] <= 1e-12, f"an own time is {worst['own time']} s beside that of the room and the lapse")
    expect(worst["display"] <= 1e-12, f"the fastest's own time is {worst['display']} s beside the display's")
    expect(most_pace > 1.001, "nobody ages more than the fastest")
    if thrust == "half":
        expect(0.49 < least_lapse < 0.52, f"the least lapse is {least_lapse}, expected 1/2")
    else:
        expect(least_lapse == 1.0, f"a lapse of {least_lapse} without thrust")
    print(
        f"{len(frames)} frames of {len(now)} people: own times to {worst['own time']:.1e} s, least lapse "
        f"{least_lapse:.4f}, pace up to {most_pace:.2f}"
    )


if sys.argv[1] == "write":
    write(pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]))
else:
    prove(sys.argv[2], sys.argv[3])
