#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Frame times of `skyline view` by pass, while a hand moves the camera, the sun and a lamp.

    PYTHONPATH=Testing/Tools /usr/bin/python3 Studies/FrameTimes.py PROGRAM [DISPLAY]

Without DISPLAY in an X server that nobody sees, on Mesa's llvmpipe. Prints a table: for each pass the
least and the median wall milliseconds of the pictures in which it ran.
"""
import re
import statistics
import subprocess
import sys
import tempfile
import time

from TestView import Hands, Server

SIZE = "1280x800"
MIDDLE = (640, 400)
STEPS = 60
REST = 5.0  # seconds until the exact picture stands, with time to spare
PAUSE = 0.1  # seconds between two moves of the hand


def pictures(text):
    """The passes of every picture: names and milliseconds."""
    lines = re.findall(r"picture \d+: (.*) ms", text)
    return [{name: float(ms) for name, ms in re.findall(r"([a-z ]+?) ([\d.]+)(?:, |$)", line)}
            for line in lines]


def measure(program, display):
    """Pictures of each phase, and those after it, at rest."""
    phases = {}
    with tempfile.NamedTemporaryFile("w+", suffix=".log") as log:
        viewer = subprocess.Popen(
            [program, "view", "--verbose", "--size", SIZE, "--time", "2026-06-22T02:00Z"],
            stderr=log, env={"DISPLAY": display, "PATH": "/usr/bin:/bin"})
        hands = Hands(display)
        time.sleep(2 * REST)
        seen = 0

        def phase(name):
            nonlocal seen
            log.flush()
            with open(log.name, encoding="utf-8") as file:
                found = pictures(file.read())
            phases[name], seen = found[seen:], len(found)

        def drag(name, dx, dy):
            hands.move(*MIDDLE)
            hands.button(1, True)
            for step in range(1, STEPS + 1):
                hands.move(MIDDLE[0] + dx * step // STEPS, MIDDLE[1] + dy * step // STEPS)
                time.sleep(PAUSE)
            phase(name)
            hands.button(1, False)
            time.sleep(REST)
            phase(name + ", at rest")

        phase("start")
        drag("camera", 120, 0)
        for _ in range(STEPS):
            hands.key("Left")
            time.sleep(PAUSE)
        phase("sun")
        time.sleep(REST)
        phase("sun, at rest")
        hands.move(*MIDDLE)
        hands.key("l")
        for _ in range(12):
            hands.key("Next")  # down to the ground, under the mouse
        time.sleep(REST)
        phase("a lamp is placed")
        drag("lamp", 200, 60)
        hands.key("q")
        viewer.wait()
    return phases


def main():
    program = sys.argv[1]
    server = Server("1600x1000") if len(sys.argv) < 3 else None
    phases = measure(program, server.name if server else sys.argv[2])
    if server:
        server.stop()
    names = list(dict.fromkeys(name for found in phases.values() for one in found for name in one))
    print("| | pictures |", " | ".join(names), "|")
    print("| --- " * (len(names) + 2) + "|")
    for phase, found in phases.items():
        cells = []
        for name in names:
            times = [one[name] for one in found if name in one]
            cells.append(f"{min(times):.3g}, {statistics.median(times):.3g}" if times else "")
        print(f"| {phase} | {len(found)} |", " | ".join(cells), "|")


if __name__ == "__main__":
    main()
