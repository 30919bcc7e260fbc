"""class_network.py CAROM CONFIG OUT: see class_network.sh."""

import asyncio
import re
import signal
import subprocess
import sys
import time

from class_phones import Phone

carom, out = sys.argv[1], sys.argv[3]
ADDRESS = "198.51.100.7"  # of no network (RFC 5737)


def ip(*words):
    subprocess.run(["ip", *words], check=True)


async def refused():
    try:
        await asyncio.wait_for(Phone(f"http://{ADDRESS}:8080/").join(), 1.0)
    except (OSError, asyncio.TimeoutError):
        return
    raise AssertionError("a phone joined without a network")


async def main():
    ip("link", "set", "lo", "up")
    ip("address", "add", f"{ADDRESS}/32", "dev", "lo")
    session = subprocess.Popen(
        [carom, "cave", "--rig", f"{out}/room.toml", "--scenario", "seen-at-once", "--silent", "--class",
         "--class-address", ADDRESS], stdout=subprocess.PIPE, stderr=open(f"{out}/stderr", "w"), text=True)
    line = session.stdout.readline()
    found = re.fullmatch(rf"class: (http://{ADDRESS}:8080/) [A-Z]+ teacher (\d{{6}})\n", line)
    assert found, f"the usual port is 8080: {line!r}"
    address, pin = found.groups()
    teacher = await Phone(address, {"pin": pin}).join()
    phone = await Phone(address).join()
    await teacher.until(lambda told: told["phones"] == 1 and told["lesson"])
    await teacher.say({"do": "ask"})
    await phone.state("vote", 1)
    await phone.say({"answer": 2, "round": 1})
    await phone.until(lambda told: told.get("yours") == 2)

    ip("address", "del", f"{ADDRESS}/32", "dev", "lo")
    await refused()
    assert session.poll() is None, "the session goes on"
    ip("address", "add", f"{ADDRESS}/32", "dev", "lo")
    begun = time.monotonic()
    again = await Phone(address, {"hello": phone.token}).join()
    assert (again.token, again.told["state"], again.told["yours"]) == (phone.token, "vote", 2), again.told
    back_s = time.monotonic() - begun
    assert back_s < 3.0, back_s
    await teacher.say({"do": "close"})
    await again.state("closed", 1)
    session.send_signal(signal.SIGTERM)
    session.wait(60)
    print(f"back with its answer {back_s:.2f} s after the network")


asyncio.run(main())
