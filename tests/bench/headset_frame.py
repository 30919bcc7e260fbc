#!/usr/bin/env python3
"""headset_frame.py BUILD: what a frame of a headset costs, with the tests' own runtime of OpenXR.

Plays `three-pucks` in two pictures of 1024 × 1024, 300 frames with a head that walks beside the table, and prints the
time from the located views to the finished pictures: median, 9 of 10, and longest. BUILD is build/release. Needs a
display; tests/with_display gives one.
"""
import math
import os
import statistics
import struct
import subprocess
import sys
import tempfile

FRAMES = 300
RECORD = struct.Struct("=6q")  # display_ns, layers, vibration, ours_ns, allocated, whether pictures follow
USUAL_NS = 11_111_111


def line(i):
    """One frame of the script: step, shown, flags, head, its attitude, trigger, hand, stick, event."""
    t_s = i / 90
    head_m = (0.3 * math.sin(1.3 * t_s), 1.65 + 0.02 * math.sin(5 * t_s), 0.3 + 0.1 * math.cos(0.9 * t_s))
    half_rad = 0.5 * (-0.4 + 0.1 * math.sin(2 * t_s))
    numbers = [USUAL_NS, 1, 15, *head_m, math.cos(half_rad), math.sin(half_rad), 0, 0, 0, 0.2, 1.2, -0.1, 0]
    return " ".join(map(str, numbers)) + " -\n"


def main():
    build = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        script, seen = os.path.join(folder, "script"), os.path.join(folder, "seen")
        with open(script, "w", encoding="ascii") as out:
            out.writelines(line(i) for i in range(FRAMES))
        environment = dict(os.environ, XR_RUNTIME_JSON=f"{build}/tests/cave/xr_double.json",
                           CAROM_XR_SCRIPT=script, CAROM_XR_SEEN=seen, CAROM_XR_HABITS="large silent")
        subprocess.run([f"{build}/bin/carom", "cave", "--rig", "headset", "--scenario", "three-pucks",
                        "--session", os.path.join(folder, "game.db"), "--no-window", "--silent"],
                       env=environment, check=True)
        with open(seen, "rb") as file:
            frames = [RECORD.unpack(record) for record in iter(lambda: file.read(RECORD.size), b"")]
    ours_ms = sorted(ours_ns / 1e6 for _, layers, _, ours_ns, _, _ in frames[30:] if layers)
    print(f"{len(ours_ms)} frames, two pictures of 1024 × 1024: median {statistics.median(ours_ms):.1f} ms, "
          f"9 of 10 within {ours_ms[len(ours_ms) * 9 // 10]:.1f} ms, longest {ours_ms[-1]:.1f} ms")


if __name__ == "__main__":
    main()
