"""Simulated phones of a class: WebSockets (RFC 6455) by asyncio alone. Used by class_session.py and class_browser.py; by hand:

    class_phones.py ADDRESS PIN PHONES LESSONS

joins with so many phones, leads them through so many lessons, prints how long each change of state takes to reach all of
them, and checks that every vote is counted once."""

import asyncio
import base64
import json
import os
import random
import statistics
import struct
import sys
import time
import urllib.parse


class Phone:
    """One WebSocket. `told` is the newest state that it was told."""

    def __init__(self, address, hello=None):
        self.url = urllib.parse.urlsplit(address)
        self.hello = {"hello": ""} if hello is None else hello
        self.told, self.token, self.changed, self.at = {}, "", asyncio.Event(), {}

    async def join(self):
        self.reader, self.writer = await asyncio.open_connection(self.url.hostname, self.url.port)
        key = base64.b64encode(os.urandom(16)).decode()
        self.writer.write((f"GET /socket HTTP/1.1\r\nHost: {self.url.netloc}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                           f"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {key}\r\n\r\n").encode())
        answer = await self.reader.readuntil(b"\r\n\r\n")
        assert b" 101 " in answer.split(b"\r\n")[0], answer
        self.listens = asyncio.ensure_future(self.listen())
        await self.say(self.hello)
        await self.until(lambda told: "state" in told)
        return self

    async def listen(self):
        try:
            while True:
                first, second = await self.reader.readexactly(2)
                size = second & 0x7F
                if size == 126:
                    size, = struct.unpack("!H", await self.reader.readexactly(2))
                elif size == 127:
                    size, = struct.unpack("!Q", await self.reader.readexactly(8))
                payload = await self.reader.readexactly(size)
                if first & 0xF == 9:
                    self.frame(0x8A, payload)
                if first & 0xF != 1:
                    continue
                self.told = json.loads(payload)
                if self.told.get("token"):
                    self.token = self.told["token"]
                state = (self.told.get("state"), self.told.get("round"))
                self.at.setdefault(state, time.monotonic())
                self.changed.set()
        except (asyncio.IncompleteReadError, ConnectionError):
            self.told = {"closed": True}
            self.changed.set()

    def frame(self, first, payload):
        size = len(payload)
        head = bytes([first]) + (bytes([0x80 | size]) if size < 126 else b"\xfe" + struct.pack("!H", size))
        mask = os.urandom(4)
        self.writer.write(head + mask + bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload)))

    async def say(self, message):
        self.frame(0x81, json.dumps(message).encode())
        await self.writer.drain()

    async def until(self, holds, patience_s=20.0):
        """Returns the first state for which this holds."""
        ends = time.monotonic() + patience_s
        while not holds(self.told):
            self.changed.clear()
            try:
                await asyncio.wait_for(self.changed.wait(), ends - time.monotonic())
            except (asyncio.TimeoutError, ValueError):
                raise AssertionError(f"not told in {patience_s} s; the newest: {self.told}") from None
        return self.told

    async def state(self, name, round_=None, patience_s=20.0):
        return await self.until(
            lambda told: told.get("state") == name and (round_ is None or told.get("round") == round_), patience_s)

    def leave(self):
        self.listens.cancel()
        self.writer.close()


async def lead(teacher, phones, lessons, seed=37):
    """Leads a class through lessons: asks, votes, discusses, votes again, shows, explains, goes on. Returns the times in
    which each change of state reached all phones, and what was voted: (lesson, round) to token to answer."""
    chance, spread_s, voted = random.Random(seed), [], {}

    async def step(name, state, round_):
        for phone in phones:
            phone.at.pop((state, round_), None)
        begun = time.monotonic()
        await teacher.say({"do": name})
        await asyncio.gather(*(phone.state(state, round_) for phone in [teacher, *phones]))
        spread_s.append(max(phone.at[state, round_] for phone in phones) - begun)

    async def vote(phone, round_):
        await asyncio.sleep(chance.uniform(0.0, 2.0))
        choices = len(phone.told["answers"])
        answers = [chance.randint(1, choices) for _ in range(2)]
        for answer in answers:  # everybody changes their mind
            await phone.say({"answer": answer, "confidence": chance.randint(1, 4), "round": round_})
        await phone.until(lambda told: told.get("yours") == answers[-1])
        voted.setdefault((phone.told["lesson"], round_), {})[phone.token] = phone.told["answers"][answers[-1] - 1]

    for number in range(lessons):
        for round_ in 1, 2:
            await step("ask" if round_ == 1 else "again", "vote", round_)
            assert "counts" not in teacher.told and all("counts" not in phone.told for phone in phones)
            await asyncio.gather(*(vote(phone, round_) for phone in phones))
            await step("close", "closed", round_)
            counts = teacher.told.get("counts")
            assert len(phones) < 5 or sum(counts[round_ - 1]) == len(phones), teacher.told
            if round_ == 1:
                await step("discuss", "discuss", 1)
        await step("show", "shown", 2)
        await asyncio.sleep(1.0)
        await step("explain", "explained", 2)
        assert teacher.told["right"] >= 1
        if number + 1 < lessons:
            before = teacher.told["lesson"]
            await step("next", "idle", 0)
            await teacher.until(lambda told: told["lesson"] != before)
    return spread_s, voted


async def main():
    address, pin, count, lessons = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    teacher = await Phone(address, {"pin": pin}).join()
    phones = []
    for _ in range(count):
        phones.append(await Phone(address).join())
    spread_s, voted = await lead(teacher, phones, lessons)
    print(f"{count} phones, {lessons} lessons: a change of state reached all within {max(spread_s):.3f} s at most, "
          f"{statistics.median(spread_s):.3f} s in the median; votes: {[len(votes) for votes in voted.values()]}")
    json.dump([[lesson, round_, votes] for (lesson, round_), votes in voted.items()], open("voted.json", "w"))


if __name__ == "__main__":
    asyncio.run(main())
