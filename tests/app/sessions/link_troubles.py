"""What link_troubles.sh says: what may happen to one room, and how it comes back."""

import re
import resource
import signal
import subprocess
import time

from linked_rooms import Proxy, Room, carom, compare, fail, free_port, host, out, playing, rooms, strike_in_turn, wait


def lives_on(room):
    frame = room.rows("SELECT max(number) FROM frame")[0][0]
    wait(20, f"{room.name} does not live on", lambda: room.rows("SELECT max(number) FROM frame")[0][0] > frame + 30)


def strokes_once(room):
    """Each stroke of a game is in its file once, and the numbers of each room's have no gap."""
    twice = room.rows("SELECT (SELECT max(number) FROM game WHERE first_frame <= frame) AS game, room, number, count(*) AS times, "
                      "min(number) FROM stroke GROUP BY game, room, number HAVING times > 1")
    if twice:
        fail(f"{room.name}: strokes are there more than once: {twice}")


port = free_port()
proxy = Proxy(port)
grenoble = host(port, ranks=2)
lyon = Room("lyon", -1, f"127.0.0.1:{proxy.own}")
wait(60, "they do not play together", playing)


def most_bytes(room, bytes):
    """Lets the room's files have so many bytes."""
    resource.prlimit(room.process.pid, resource.RLIMIT_FSIZE, (bytes, resource.RLIM_INFINITY))


# Lyon's disk is full: that is said, and the game goes on in both rooms.
most_bytes(lyon, 50000)
wait(30, "the disk is not full", lambda: "session goes on" in lyon.said())
print(re.search(r"^.*session goes on.*$", lyon.said(), re.M)[0].replace(str(out), ""))
time.sleep(2.0)
if not playing() or grenoble.notes("gone"):
    fail("a full disk in one room parts them")
most_bytes(lyon, resource.RLIM_INFINITY)
lives_on(lyon)
strike_in_turn(2)

# One of Grenoble's two computers is lost: its session ends and says so. Lyon plays on alone.
children = subprocess.run(["pgrep", "-P", str(grenoble.process.pid)], text=True, capture_output=True).stdout.split()
if len(children) != 2:
    fail(f"expected two nodes, found {children}")
grenoble.ends = (1, 137)
subprocess.run(["kill", "-KILL", max(children, key=int)], check=True)
wait(60, "a lost node ends no session", lambda: grenoble.process.poll() is not None)
print(re.search(r"^error: node 1 .*$", grenoble.said(), re.M)[0])
wait(20, "who has lost a node is not gone", lambda: lyon.notes("gone") == 1)
lives_on(lyon)

# It comes back as the host, with its game and all strokes; Lyon, which has played on alone, joins it anew.
grenoble.ends = ()
grenoble.start(["--resume", "--link", f"listen:127.0.0.1:{port}"])
wait(90, "the host does not come back", lambda: grenoble.notes("paired") == 2 and playing())
strike_in_turn(2)

# Lyon is killed; Grenoble plays on. Lyon comes back and joins anew, in the same file.
lyon.ends = (-signal.SIGKILL,)
lyon.process.kill()
wait(20, "who is killed is not gone", lambda: grenoble.notes("gone") >= 1)
lives_on(grenoble)
lyon.ends = ()
lyon.start(["--resume", "--link", f"127.0.0.1:{proxy.own}"])
wait(90, "who was killed does not join again", lambda: grenoble.notes("paired") == 3 and playing())
strike_in_turn(2)
time.sleep(3.0)
for room in rooms:
    room.ends = (0,)
    room.process.send_signal(signal.SIGTERM)
for room in rooms:
    if room.process.wait(30) != 0:
        fail(f"{room.name} ended with {room.process.returncode}")
    strokes_once(room)
games = [room.rows("SELECT count(*) FROM game")[0][0] for room in rooms]
if games != [1, 3]:
    fail(f"the files have {games} games, expected one of the host and three of who has joined three times")
compare(3)
