"""What tracker_gone.sh says: plays a controller to a session, falls silent, and reads the session's journal."""

import math
import pathlib
import re
import socket
import sqlite3
import subprocess
import sys
import time

RATE_HZ = 120.0
BEFORE_S, SILENT_S, AFTER_S = 3.0, 10.0, 4.0  # a silence is told of after 5 s, however busy the machine is
WALK_M_S = 0.5
FADED_S = 1.0  # devices/filter/head_filter.h: celerity is zero so long after the last sample
SLIDE_M_S = 1.0  # there: how fast the shown pose comes over to where samples go on
LIGHT_M_S = 1.42

carom, config, out = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])


def free_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


PORT = free_port()
rig = (config / "rigs/single-screen.toml").read_text()
rig = re.sub(r"(?m)^pixels = .*", "pixels = [32, 32]", rig)
rig = re.sub(r"(?m)^kind = .*", 'kind = "dtrack"', rig)
rig = re.sub(r"(?m)^source = .*", f'source = "udp://127.0.0.1:{PORT}"', rig)
rig = re.sub(r"(?m)^room_from_tracker = .*\n", "", rig)
if "source = " not in rig:
    rig = rig.replace('kind = "dtrack"', f'kind = "dtrack"\nsource = "udp://127.0.0.1:{PORT}"')
(out / "room.toml").write_text(rig)
name = re.search(r'(?m)^\[\[tracker\]\]\s*\nname = "(.*)"', rig).group(1)

sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
number = 0


def walk(seconds):
    """Sends a head that sways to and fro along x, as fast as WALK_M_S in the middle, for so long."""
    global number
    end = time.monotonic() + seconds
    while (now := time.monotonic()) < end:
        number += 1
        x_mm = 1e3 * WALK_M_S / math.pi * math.sin(math.pi * now)  # turning every second
        stamp = time.time()
        sender.sendto(
            f"fr {number}\r\nts2 {int(stamp)} {int(stamp % 1 * 1e6)} 0\r\n6d 1 [0 1.000]"
            f"[{x_mm:.3f} 1700.000 0.000][1 0 0 0 1 0 0 0 1]\r\n".encode(),
            ("127.0.0.1", PORT),
        )
        time.sleep(1.0 / RATE_HZ)


database = out / "game.db"
with open(out / "stderr", "w") as errors:
    session = subprocess.Popen(
        [carom, "cave", "--rig", out / "room.toml", "--session", database, "--no-window"], stderr=errors
    )
try:
    deadline = time.monotonic() + 120.0
    log = out / "game.db-wal"  # what SQLite writes first; before it is there, a reader would be in the way

    def begins():
        """Whether the journal holds some frames."""
        if not log.exists() or log.stat().st_size < 100_000:
            return False
        try:
            with sqlite3.connect(f"file:{database}?mode=ro", uri=True) as reader:
                return reader.execute("SELECT count(*) FROM frame").fetchone()[0] >= 5
        except sqlite3.OperationalError:  # busy
            return False

    while not begins() and session.poll() is None and time.monotonic() < deadline:
        walk(0.2)
    if begun := begins():
        walk(BEFORE_S)
        time.sleep(SILENT_S)
        walk(AFTER_S)
finally:
    ended_early = session.poll() is not None
    session.terminate()
    try:
        session.wait(30)
    except subprocess.TimeoutExpired:
        session.kill()
said = (out / "stderr").read_text()
if not begun:
    print("FAILED: the session does not begin:", said)
    sys.exit(1)
journal = sqlite3.connect(database)
rows = journal.execute(
    "SELECT display_s, proper_time_s, t_s, known, celerity_x_m_s, celerity_y_m_s, celerity_z_m_s, x_m, y_m, z_m"
    " FROM frame ORDER BY number"
).fetchall()
samples = [t for (t,) in journal.execute("SELECT time_s FROM sample ORDER BY time_s")]
failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)


expect(not ended_early, "the session ended by itself")
gap, last = max((later - earlier, earlier) for earlier, later in zip(samples, samples[1:]))
back = last + gap
expect(gap > SILENT_S - 1.0, f"the longest silence in the journal is {gap:.2f} s, {SILENT_S} s were sent")

silent = re.search(rf"(?m)^Tracker {name}: silent since second ([0-9.]+) of the session; the head is held$", said)
expect(silent is not None, "no line says that the tracker is silent")
expect(silent is None or abs(float(silent.group(1)) - last) < 1.0, f"it is said to be silent since another time than {last:.1f} s")
again = re.search(rf"(?m)^Tracker {name}: delivers again, after ([0-9.]+) s$", said)
expect(again is not None, "no line says that the tracker is back")
expect(again is None or abs(float(again.group(1)) - gap) < 1.5, f"it is said to have been away for another time than {gap:.1f} s")

held = [row for row in rows if last + FADED_S <= row[0] < back]
walked = [row for row in rows if row[0] <= last]
expect(len(held) > 10, f"only {len(held)} frames were shown in the silence")
expect(all(row[3] in ("held", "lost") for row in held), "a head without samples passes for measured")
expect(all(row[4:7] == (0.0, 0.0, 0.0) for row in held), f"celerity is not zero {FADED_S} s after the last sample")
expect(max((math.hypot(*row[4:7]) for row in walked), default=0.0) > 0.5 * WALK_M_S, "the walk before shows no celerity")
expect(len({row[7:10] for row in held if row[0] > last + FADED_S + 0.2}) == 1, "a head that is held moves on the board")
expect(len({row[7] for row in rows if row[0] > back + 0.5}) > 1, "the head does not walk on when the tracker is back")

# Board time goes on by dt = sqrt(dτ² + |dx|²/c²), and the shown head moves by its walk (by prediction at most three
# times as fast, from its first samples) and by the slide back. A head that was put elsewhere would take 0.2 s and more in one frame.
# Looked at from shortly before the silence until the head has come over. Not where a busy machine has kept samples from
# being sent for a while: the walk that was predicted meanwhile may have turned.
STALL_S, AFTER_STALL_S = 0.05, 0.5
stalls = [(a, b + AFTER_STALL_S) for a, b in zip(samples, samples[1:]) if STALL_S < b - a < 0.5 * SILENT_S]
fastest = math.hypot(1.0, (3.0 * WALK_M_S + SLIDE_M_S) / LIGHT_M_S)
for earlier, later in zip(rows, rows[1:]):
    if any(begin <= later[0] <= end for begin, end in stalls) or not last - 1.0 < later[0] < back + 3.0:
        continue
    lived, passed = later[1] - earlier[1], later[2] - earlier[2]
    moved_m = math.dist(earlier[7:10], later[7:10])
    if not (abs(passed - math.hypot(lived, moved_m / LIGHT_M_S)) < 1e-9 and passed <= lived * fastest):
        expect(False, f"board time goes on by {passed} s in {lived} s of the person at {later[0]:.3f} s")
        break
standing = [row for row in held if row[0] > last + FADED_S + 0.2]
for earlier, later in zip(standing, standing[1:]):
    expect(abs((later[2] - earlier[2]) - (later[1] - earlier[1])) < 1e-9, "board time of a head at rest is not its own")

print(f"{len(rows)} frames, {len(samples)} samples, silent from {last:.2f} s for {gap:.2f} s")
for failure in failures:
    print("FAILED:", failure)
if failures:
    print(said)
sys.exit(1 if failures else 0)
