# SPDX-License-Identifier: BSD-3-Clause
"""Records how many times faster the search is than other programs, and reports when it becomes slower.

    CheckRatios.py PROGRAM EXPECTED.json FOLDER

Measures in one quick run. Writes FOLDER/ratios.json, and FOLDER/ratio-drops.txt with one line for each
ratio that is below the expected one by more than the band (empty if there is none). A drop is not a
failure, because the machine may be busy; a program that does not measure is one. Ratios that could
not be measured (without Embree) are not compared.
"""
import json
import os
import subprocess
import sys
import tempfile

# Two runs on a machine with other load differ by less than this factor.
BAND = 2.5

COMMAND = ["--scenes", "hills,walls", "--sizes", "256", "--quantities", "horizon", "--methods",
           "exact,fast,every,embree", "--budget", "15", "--quiet"]


def drops(measured, expected):
    """Returns one line for each ratio that is below its band."""
    found = {(ratio["name"], ratio["scene"]): ratio["times"] for ratio in measured}
    lines = []
    for ratio in expected:
        times = found.get((ratio["name"], ratio["scene"]))
        if times is not None and times * BAND < ratio["times"]:
            lines.append("%s on %s: %.2f times, was %.2f" % (
                ratio["name"], ratio["scene"], times, ratio["times"]))
    return lines


def self_test():
    """Checks that the comparison finds a drop, and nothing else."""
    was = [{"name": "a", "scene": "s", "times": 10.0}, {"name": "b", "scene": "s", "times": 1.0}]
    for times, expected in [(10.0, 0), (10.0 / BAND + 0.1, 0), (10.0 / BAND - 0.1, 1), (99.0, 0)]:
        now = [{"name": "a", "scene": "s", "times": times}]
        assert len(drops(now, was)) == expected, (times, drops(now, was))
    assert drops([], was) == []


def main():
    program, expected, folder = sys.argv[1:]
    self_test()
    with tempfile.TemporaryDirectory() as report:
        subprocess.run([program, "benchmark", "-o", report, *COMMAND], check=True)
        with open(os.path.join(report, "results.json"), encoding="utf-8") as file:
            session = json.load(file)
    ratios = session["ratios"]
    assert any(ratio["name"] == "exact over every crossing" for ratio in ratios), ratios
    with open(os.path.join(folder, "ratios.json"), "w", encoding="utf-8") as file:
        json.dump({"machine": session["machine"], "ratios": ratios}, file, indent=1)
    with open(expected, encoding="utf-8") as file:
        lines = drops(ratios, json.load(file)["ratios"])
    with open(os.path.join(folder, "ratio-drops.txt"), "w", encoding="utf-8") as file:
        file.writelines(line + "\n" for line in lines)
    for ratio in ratios:
        print("%(name)s on %(scene)s: %(times).2f times" % ratio)
    if lines:
        print("\n" + "!" * 72)
        print("THE SEARCH HAS BECOME SLOWER than its peers, beyond the band of %g:" % BAND)
        print("\n".join(lines))
        print("!" * 72)


if __name__ == "__main__":
    main()
