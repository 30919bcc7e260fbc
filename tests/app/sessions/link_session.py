"""What link_session.sh says: two rooms play one game, and what their session files hold."""

import filecmp
import os
import pathlib
import re
import shutil
import signal
import sqlite3
import subprocess
import time

from linked_rooms import DELAY_S, Proxy, Room, carom, compare, fail, free_port, host, out, playing, rooms, strike_in_turn, wait


def alone(rig):
    """Runs a session without --link for a moment; returns the numbers of its TCP sockets and threads, and its tables."""
    session = out / f"{rig.stem}.db"
    with open(out / "alone.err", "w") as log:
        process = subprocess.Popen([carom, "cave", "--rig", rig, "--scenario", "two-cities", "--session", session, "--no-window",
                                    "--silent"], stderr=log)
    end = time.monotonic() + 60
    while time.monotonic() < end and not session.exists():
        time.sleep(0.2)
    time.sleep(2.0)
    inodes = {line.split()[9] for table in ("tcp", "tcp6")
              for line in pathlib.Path(f"/proc/{process.pid}/net/{table}").read_text().splitlines()[1:]}
    held = []
    for link in pathlib.Path(f"/proc/{process.pid}/fd").iterdir():
        try:
            held.append(os.readlink(link))
        except OSError:
            pass
    sockets = sum(f"socket:[{inode}]" in held for inode in inodes)
    threads = len(list(pathlib.Path(f"/proc/{process.pid}/task").iterdir()))
    process.send_signal(signal.SIGTERM)
    process.wait(30)
    with sqlite3.connect(session) as database:
        return sockets, threads, [row[0] for row in database.execute("SELECT name FROM sqlite_schema ORDER BY name")]


def plain():
    """Without --link and `with` a rig that has a [link] opens no socket, has no thread more and no table."""
    with_link, without = out / "with.toml", out / "without.toml"
    without.write_text(
        'title = "alone"\nunit = "m"\naxes = "x-right y-up z-back"\ndisplay_hz = 30.0\n[head]\ntracker = "walks"\n'
        'eye_separation = 0.064\n[[tracker]]\nname = "walks"\nkind = "simulated"\n[[wall]]\nname = "screen"\n'
        'lower_left = [-0.8, 0.9, -1.0]\nlower_right = [0.8, 0.9, -1.0]\nupper_left = [-0.8, 1.8, -1.0]\n'
        'pixels = [48, 32]\nstereo = "mono"\n')
    with_link.write_text(without.read_text() + '[link]\nname = "alone"\nkey = "room.key"\n')
    found, expected = alone(with_link), alone(without)
    if found != expected or any("link" in name for name in found[2]):
        fail(f"a session without --link has {found}, expected {expected}")
    print(f"without --link: {found[0]} TCP sockets (of MPI) and {found[1]} threads, as without [link], and no table of links")


def measured():
    """What `carom link --test` and `carom doctor` say of the line, beside what it is known to be."""
    address = f"127.0.0.1:{proxy.own}"
    rig = out / "annecy.toml"
    rig.write_text((out / "lyon.toml").read_text().replace('name = "lyon"\nkey', f'name = "annecy"\nwith = "{address}"\nkey'))
    for command in (["link", "--test", address, "--key", out / "room.key"], ["doctor", rig]):
        proxy.took_s = []
        said = subprocess.run([carom, *command], text=True, capture_output=True)
        known_ms = proxy.round_ms()
        found = re.search(r"round trip:? (?:median )?([0-9.]+) ms", said.stdout + said.stderr)
        if not found:
            fail(f"carom {command[0]} measures nothing: {said.stdout} {said.stderr}")
        print(f"carom {command[0]}: {found[1]} ms, known {known_ms:.1f} ms")
        if abs(float(found[1]) - known_ms) > 0.1 * known_ms:
            fail(f"carom {command[0]} says {found[1]} ms of a line of {known_ms:.1f} ms")


def people():
    """Both rooms show the other's person: in their events, and in their pictures, which are others without."""
    for room in rooms:
        kinds = [row[0] for row in room.rows("SELECT kind FROM link_person ORDER BY rowid")]
        if kinds[0] != 1 or kinds.count(2) < 1 or 0 not in kinds:
            fail(f"{room.name}: people of kinds {set(kinds)}")
        table = subprocess.run([carom, "events", room.file, "--game", "1", "--csv", "-"], text=True, capture_output=True).stdout
        header = table.splitlines()[0]
        if header.count("_proper_time_s") != 2 or "seen_by_viewer_afar_t_s" not in header:
            fail(f"{room.name}: events do not say when the others saw them: {header}")
        seen = subprocess.run([carom, "export", room.file, "--game", "1", "--every", "10", "--csv", "-"], text=True,
                              capture_output=True).stdout
        if seen.count(",viewer_afar,seen,") < 10:
            fail(f"{room.name}: the other's person is not exported: {seen[:1000]}")
        bare = out / f"{room.name}-bare.db"
        shutil.copy(room.file, bare)
        with sqlite3.connect(bare) as database:
            database.execute("DELETE FROM link_person")
        pictures = out / f"{room.name}-bare"
        subprocess.run([carom, "replay", bare, "--game", "1", "--capture", pictures, "--no-window"], check=True,
                       stderr=subprocess.DEVNULL)
        names = [picture.name for picture in pictures.glob("*.png") if (room.pictures / picture.name).exists()]
        other = sum(not filecmp.cmp(pictures / name, room.pictures / name, shallow=False) for name in names)
        print(f"{room.name}: {other} of {len(names)} pictures show the other's person")
        if other < 0.3 * len(names):
            fail(f"{room.name}: the other's person is not seen")


port = free_port()
proxy = Proxy(port)
grenoble = host(port)
lyon = Room("lyon", -1, f"127.0.0.1:{proxy.own}")
plain()
wait(60, "they do not play together", playing)
strike_in_turn(4)
round_ms = lyon.link()["round_trip_ms"]["median"]
print(f"round trip {round_ms:.0f} ms")
if not 1.8e3 * DELAY_S < round_ms < 3e3 * DELAY_S:
    fail(f"a round trip of {round_ms} ms")

measured()

proxy.cut()
proxy.silent = True
time.sleep(2.0)
proxy.cut()
proxy.silent = False
wait(20, "they do not go on after a cut", lambda: all(room.notes("back") for room in rooms))
if any(room.notes("gone") for room in rooms):
    fail("a cut of 2 s parts them")
strike_in_turn(2)

proxy.silent = True
wait(15, "who is silent is not gone", lambda: all(room.notes("gone") for room in rooms))
time.sleep(5.0)
proxy.cut()
proxy.silent = False
wait(40, "they do not join anew", lambda: all(room.notes("paired") == 2 for room in rooms))
wait(20, "they do not play anew", playing)
strike_in_turn(2)
time.sleep(3.0)

lyon.ends = (-signal.SIGKILL,)
lyon.process.kill()
wait(20, "who is killed is not gone", lambda: grenoble.notes("gone") == 2)
frame = grenoble.rows("SELECT max(number) FROM frame")[0][0]
wait(20, "the other does not live on", lambda: grenoble.rows("SELECT max(number) FROM frame")[0][0] > frame + 30)
grenoble.ends = (0,)
grenoble.process.send_signal(signal.SIGTERM)
if grenoble.process.wait(30) != 0:
    fail(f"the host ended with {grenoble.process.returncode}")

for room in rooms:
    waits = room.rows("SELECT avg(waits) FROM link WHERE state = 'playing'")[0][0]
    print(f"{room.name}: waits in {100 * waits:.2f} % of the frames, games {room.rows('SELECT count(*) FROM game')[0][0]}")
compare(2)

# One bit of one stroke: it is noticed.
with sqlite3.connect(lyon.file) as database:
    database.execute("UPDATE stroke SET offset_m = offset_m + 1e-12 WHERE rowid = 1")
changed = subprocess.run([carom, "compare", grenoble.file, lyon.file], text=True, capture_output=True)
if changed.returncode != 1 or "first difference: stroke 0" not in changed.stdout:
    fail(f"compare of a changed file: {changed.stdout} {changed.stderr}")
with sqlite3.connect(lyon.file) as database:
    database.execute("UPDATE stroke SET offset_m = offset_m - 1e-12 WHERE rowid = 1")

for room in rooms:
    again = out / f"{room.name}-again"
    for game in range(1, room.rows("SELECT count(*) FROM game")[0][0] + 1):
        subprocess.run([carom, "replay", room.file, "--game", str(game), "--capture", again, "--no-window"], check=True,
                       stderr=subprocess.DEVNULL)
    frames = {row[0] for row in room.rows("SELECT number FROM frame")}
    same = differ = 0
    for picture in sorted(again.glob("*.png")):
        shown = room.pictures / picture.name
        if not shown.exists():
            continue  # the killed one had not written it
        if filecmp.cmp(picture, shown, shallow=False):
            same += 1
        else:
            differ += 1
    print(f"{room.name}: {same} pictures are the same again, {differ} differ, of {len(frames)} frames")
    if differ or same < 0.9 * len(frames):
        fail("a replay differs from what was seen")
people()
