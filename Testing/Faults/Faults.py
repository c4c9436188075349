# SPDX-License-Identifier: BSD-3-Clause
"""Code that the tests of injected faults share: commands on small rasters, runs with a fault, and verdicts.

A run passes if it ends in time and either exits with 0 and has written the file that a run without
faults writes, or fails with a reason and leaves the earlier files unchanged. After the next run of the
same command there must be no other file.

Environment: SKYLINE_FAIL_CALLS is the library to preload (FailCalls.cxx), SKYLINE_TEST_RUNS the number
of runs, SKYLINE_TEST_JOBS how many run at a time (default 1), SKYLINE_TEST_SEED selects other faults.
"""
import collections
import concurrent.futures
import os
import random
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Tools"))

import Program  # noqa: E402
from Program import UTM10, gdal, hills, make, np  # noqa: E402

LIBRARY = os.environ.get("SKYLINE_FAIL_CALLS", "")
RUNS = int(os.environ.get("SKYLINE_TEST_RUNS", "30"))
JOBS = int(os.environ.get("SKYLINE_TEST_JOBS", "1"))
SEED = int(os.environ.get("SKYLINE_TEST_SEED", "1"))

# The types of calls in the order of FaultPlan.h, with the errors that a system returns for them.
ERRORS = {
    "open": ["EMFILE", "EACCES", "ENOENT", "EIO"],
    "read": ["EIO", "EINTR", "short"],
    "write": ["ENOSPC", "EIO", "EINTR", "EDQUOT", "short"],
    "close": ["EIO", "ENOSPC"],
    "sync": ["EIO", "ENOSPC"],
    "rename": ["EACCES", "EXDEV", "EIO"],
    "remove": ["EACCES", "EIO"],
    "truncate": ["ENOSPC", "EIO"],
    "status": ["ENOENT", "EACCES", "EIO"],
    "folder": ["EACCES", "ENOSPC"],
    "mode": ["EPERM", "EIO"],
    "map": ["ENOMEM"],
    "thread": ["EAGAIN"],
    "allocate": ["ENOMEM"],
}
KINDS = list(ERRORS)

# Seconds after which a run counts as hung. On an idle machine a run takes less than 1.
PATIENCE = 30.0

PYTHON = """
import ctypes, sys
import numpy, skyline
heights = skyline.to_array(skyline.read(sys.argv[1]))
arm = getattr(ctypes.CDLL(None), "SkylineArmFaults", None)
if arm:
    arm()
skyline.write(sys.argv[2], heights.astype(numpy.float32), like=sys.argv[1])
"""

# The earlier target and its side file. Beside a new raster the old side file would change its
# values.
OLD_SIDE_FILE = b"""<PAMDataset>
  <PAMRasterBand band="1"><NoDataValue>0.5</NoDataValue><Offset>7</Offset></PAMRasterBand>
</PAMDataset>
"""


def number_of(error):
    import errno
    return error if error.startswith(("short", "signal")) else str(getattr(errno, error))


def timeless(content):
    """The bytes of a file without the time of writing, which an EXR contains."""
    return content and re.sub(rb"\d{4}:\d\d:\d\d \d\d:\d\d:\d\d", b"", content)


class Fault:
    """One fault of one run, and a description with which it can be repeated."""

    def __init__(self, kind="", number=0, error="", lasting=False, least=0):
        self.kind, self.number, self.error = kind, number, error
        self.lasting, self.least = lasting, least

    def environment(self, counts, armed):
        values = {"SKYLINE_FAULT_COUNTS": counts, "SKYLINE_FAULT_ARMED": "1" if armed else "0",
                  "SKYLINE_FAULT_LEAST": str(self.least)}
        if self.kind:
            values.update({"SKYLINE_FAULT_CALL": self.kind,
                           "SKYLINE_FAULT_NUMBER": str(self.number),
                           "SKYLINE_FAULT_ERROR": number_of(self.error),
                           "SKYLINE_FAULT_LASTING": "1" if self.lasting else "0"})
        return values

    def __str__(self):
        if not self.kind:
            return "no fault"
        return "%s %d%s: %s%s" % (self.kind, self.number, " and later" if self.lasting else "",
                                  self.error, ", from %d bytes" % self.least if self.least else "")


class Case:
    """A command in a folder of its own, with the files before the run and the expected output."""

    def __init__(self, folder, name, arguments, out):
        self.folder = os.path.join(folder, name)
        os.mkdir(self.folder)
        self.temporary = os.path.join(self.folder, "temporary")
        os.mkdir(self.temporary)
        self.counts = os.path.join(folder, name + "-counts")
        self.name = name
        self.out = os.path.join(self.folder, out) if out else ""
        self.python = arguments[0] == "python"
        if self.python:
            self.command = [sys.executable, "-c", PYTHON, *arguments[1:], self.out]
        else:
            self.command = [Program.PROGRAM, *arguments, *(["-o", self.out] if out else [])]
        # The libraries of OpenImageIO start threads.
        self.images = any(word.endswith((".exr", ".png")) for word in self.command)
        self.good = b""
        self.good_raster = None
        self.old = {}
        self.learnt = None

    def environment(self, fault):
        values = dict(os.environ, TMPDIR=self.temporary, HOME=self.folder)
        if LIBRARY:
            values["LD_PRELOAD"] = LIBRARY
        values.update(fault.environment(self.counts, not self.python))
        return values

    def learn(self, least=0):
        """Runs without a fault, to get the right output and the number of calls of each type."""
        if self.learnt == least:
            return
        self.learnt = least
        self.clear()
        start = time.monotonic()
        done = subprocess.run(self.command, env=self.environment(Fault(least=least)),
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=10 * PATIENCE,
                              cwd=self.folder)
        self.seconds = time.monotonic() - start
        if done.returncode != 0:
            raise RuntimeError("%s: %s" % (" ".join(self.command), done.stderr.decode()))
        self.calls = self.counted()
        self.good = timeless(self.bytes_of(self.out)) if self.out else done.stdout
        self.good_raster = self.raster() if self.out.endswith(".tif") else None

    def counted(self):
        if not os.path.exists(self.counts):
            return dict.fromkeys([*KINDS, "failed", "sent"], 0)
        with open(self.counts, "rb") as file:
            numbers = struct.unpack("%dQ" % (len(KINDS) + 2), file.read())
        return dict(zip([*KINDS, "failed", "sent"], numbers))

    def clear(self):
        """Restores the folder before the command: an old raster and its side file, and nothing else."""
        for place in [self.folder, self.temporary]:
            for name in os.listdir(place):
                path = os.path.join(place, name)
                if not os.path.isdir(path):
                    os.unlink(path)
        self.put_old()

    def put_old(self):
        if os.path.exists(self.counts):
            os.unlink(self.counts)
        if not self.out:
            return
        self.old = {self.out: b"II*\0 what was here before", self.out + ".aux.xml": OLD_SIDE_FILE}
        for path, content in self.old.items():
            with open(path, "wb") as file:
                file.write(content)

    @staticmethod
    def bytes_of(path):
        try:
            with open(path, "rb") as file:
                return file.read()
        except FileNotFoundError:
            return None

    def raster(self):
        """All that a user reads from the raster, including side files."""
        raster = gdal.Open(self.out)
        bands = [raster.GetRasterBand(k + 1) for k in range(raster.RasterCount)]
        return (raster.ReadAsArray(), raster.GetGeoTransform(), raster.GetProjection(),
                [(band.GetDescription(), band.GetUnitType(), band.GetOffset(), band.GetScale(),
                  band.GetOverviewCount(), repr(band.GetNoDataValue())) for band in bands])

    def is_good(self):
        """Whether the target is the output of a run without faults."""
        found = timeless(self.bytes_of(self.out))
        stale = os.path.exists(self.out + ".aux.xml")
        if found == self.good and not stale:
            return True
        if not found or self.good_raster is None:
            return False
        try:
            raster = self.raster()
        except RuntimeError:
            return False
        return (np.array_equal(raster[0], self.good_raster[0], equal_nan=True) and
                raster[1:] == self.good_raster[1:])

    def is_old(self):
        return all(self.bytes_of(path) == content for path, content in self.old.items())

    def is_old_for_the_next_run(self):
        """After SIGKILL, or where the system refuses all renames: the old raster remains, and its side file
        has another name until the next run that writes to this folder restores it."""
        raster, side = self.old
        aside = [name for name in os.listdir(self.folder)
                 if name.endswith(".of." + os.path.basename(side))]
        return (self.bytes_of(raster) == self.old[raster] and len(aside) == 1 and
                self.bytes_of(os.path.join(self.folder, aside[0])) == self.old[side])

    def litter(self):
        """Files that no user asked for."""
        known = {os.path.basename(self.out), os.path.basename(self.out) + ".aux.xml"}
        found = [name for name in os.listdir(self.folder) if name not in known]
        found.remove("temporary")
        return sorted(name for name in found if not os.path.isdir(os.path.join(self.folder, name))
                      ) + sorted(os.listdir(self.temporary))

    def start(self, fault):
        self.put_old()
        return subprocess.Popen(self.command, env=self.environment(fault), cwd=self.folder,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE,
                                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CORE, (0, 0)))

    def run(self, fault):
        """Runs with the fault. Returns the verdict, the output, and the seconds (after the signal, if the
        fault is one)."""
        start = time.monotonic()
        running = self.start(fault)
        try:
            out, said = running.communicate(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            running.kill()
            running.communicate()
            return "HUNG", "", time.monotonic() - start
        end = time.monotonic()
        sent = self.counted()["sent"] * 1e-9
        seconds = end - sent if sent else end - start
        verdict = self.judge(running.returncode, out, said, fault.error.startswith("signal"))
        return verdict, said.decode(errors="replace"), seconds

    def judge(self, code, out, said, killed=False):
        if code == 0:
            if not self.out:
                return "right" if out == self.good else "WRONG"
            return "right" if self.is_good() else "WRONG"
        if self.out and not self.is_old() and not self.is_old_for_the_next_run():
            # The last steps, such as syncing the folder, can fail when the new file is already in
            # place. A kill can come before the old side file is removed.
            whole = timeless(self.bytes_of(self.out)) == self.good if killed else self.is_good()
            return "failed, new file" if whole else "SPOILT"
        if code in (-signal.SIGSEGV, -signal.SIGBUS, -signal.SIGFPE, -signal.SIGILL):
            return "CRASHED"
        if code < 0:
            return "ended by the signal" if killed else "died"
        if not self.python and not said.strip():
            return "silent"
        return "refused" if code == 1 else "exit %d" % code

    def sweep(self):
        """Runs once more without a fault: the output must be right, and no other file may be left."""
        verdict, said, _ = self.run(Fault())
        if verdict != "right":
            return ["%s, after all faults: %s %s" % (self.name, verdict, said)]
        return self.left_over("after the next run")

    def left_over(self, when):
        return ["%s: LITTER %s: %s" % (self.name, when, name) for name in self.litter()]


# Verdicts that are wrong for each fault.
BAD = ["HUNG", "LATE", "WRONG", "SPOILT", "CRASHED", "silent"]
USUAL = ["right", "refused", "ended by the signal"]


def make_cases(folder, names=None):
    """The commands, each in a folder of its own below `folder`, on shared rasters."""
    # Several blocks per band, so that GDAL compresses with threads.
    big = make(os.path.join(folder, "big.tif"), hills(600, 520), epsg=UTM10,
               kind=gdal.GDT_Float32)
    small = make(os.path.join(folder, "small.tif"), hills(16, 32), epsg=UTM10,
                 kind=gdal.GDT_Float32)
    light = os.path.join(folder, "light.exr")
    subprocess.run([Program.PROGRAM, "shade", small, "-o", light, "--azimuths", "8"], check=True)
    cases = {
        "horizon": (["horizon", big, "--azimuths", "4"], "out.tif"),
        "horizon-cog": (["horizon", big, "--azimuths", "4", "--cloud-optimized"], "out.tif"),
        "sky-view": (["sky-view", small, "--azimuths", "8"], "out.tif"),
        "sun": (["sun", small, "--time", "2026-06-21T18:00Z"], ""),
        "irradiance": (["irradiance", small, "--environment", light, "--azimuths", "8"], "out.tif"),
        "shade-png": (["shade", small, "--azimuths", "8"], "out.png"),
        "shade-exr": (["shade", small, "--azimuths", "8"], "out.exr"),
        "shade-tif": (["shade", small, "--azimuths", "8"], "out.tif"),
        "shadow-height": (["shadow-height", small, "--sun", "300,10"], "out.tif"),
    }
    if os.environ.get("SKYLINE_TEST_PYTHON") == "1":
        cases["python-write"] = (["python", big], "out.tif")
    return [Case(folder, name, arguments, out) for name, (arguments, out) in cases.items()
            if names is None or name in names]


def rounds(cases, kinds, count, rng):
    """`count` triples (case, type, number of the call): all cases and types in turn, no call twice."""
    # The libraries of OpenImageIO may wait forever for a thread that failed to start.
    pairs = [(case, kind) for case in cases for kind in kinds
             if case.calls[kind] > 0 and not (kind == "thread" and case.images)]
    taken = set()
    while len(taken) < count and pairs:
        rng.shuffle(pairs)
        for case, kind in list(pairs):
            calls = case.calls[kind]
            free = [n for n in rng.sample(range(1, calls + 1), min(calls, 8))
                    if (case.name, kind, n) not in taken]
            if not free:
                pairs.remove((case, kind))
            elif len(taken) < count:
                taken.add((case.name, kind, free[0]))
                yield case, kind, free[0]


class Tally:
    """The verdicts of many runs, each of which may take `patience` seconds."""

    def __init__(self, patience=PATIENCE):
        self.patience = patience
        self.verdicts = collections.Counter()
        self.slowest = 0.0
        self.findings = []

    def add(self, case, fault, verdict, said, seconds):
        if seconds > self.patience and verdict != "HUNG":
            verdict = "LATE"
        self.verdicts[verdict] += 1
        self.slowest = max(self.slowest, seconds)
        line = "%s, %s: %s in %.2f s %s" % (
            case.name, fault, verdict, seconds, " | ".join(said.split("\n"))[:300])
        if verdict in BAD:
            self.findings.append(line)
        if verdict not in USUAL:
            print(line, flush=True)  # at once, because hundreds of runs may follow

    def __str__(self):
        counts = ", ".join("%d %s" % (n, verdict) for verdict, n in self.verdicts.most_common())
        return "%d runs: %s; slowest %.1f s" % (
            sum(self.verdicts.values()), counts or "none", self.slowest)


def run_all(plan, tally, clean=False):
    """Runs (case, fault) pairs: those of a case in sequence, cases in parallel. `clean`: no file may be
    left even before the next run."""
    by_case = collections.defaultdict(list)
    for case, fault in plan:
        by_case[case].append(fault)

    def run_case(case):
        case.clear()
        for fault in by_case[case]:
            tally.add(case, fault, *case.run(fault))
        left = case.left_over("before the next run") if clean else []
        tally.findings += left + case.sweep()

    with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
        list(pool.map(run_case, by_case))


def report(test, tally):
    """Prints the counts, and fails if a verdict was wrong."""
    print("\n" + test.id().split(".", 1)[-1] + ":", tally, flush=True)
    test.assertEqual(tally.findings, [], "\n" + "\n".join(tally.findings))


# A selection if there is no time for all: one command for each way of writing.
FEW = ["horizon-cog", "irradiance", "shade-png", "shade-exr"]
MANY_RUNS = 100


def sanitized(program):
    with open(program, "rb") as file:
        return b"__asan_init" in file.read()


class FaultTest(Program.ToolTest):
    """The cases in a folder of the class, and the faults that the seed selects."""

    @classmethod
    def setUpClass(cls):
        if not LIBRARY:
            raise unittest.SkipTest("SKYLINE_FAIL_CALLS names no library to preload")
        if sanitized(Program.PROGRAM):
            raise unittest.SkipTest("a sanitizer's own allocations cannot be replaced")
        cls.shared = tempfile.mkdtemp(prefix="skyline-faults-")
        cls.addClassCleanup(shutil.rmtree, cls.shared, ignore_errors=True)
        cls.all_cases = make_cases(cls.shared, FEW if RUNS < MANY_RUNS else None)

    def setUp(self):
        super().setUp()
        self.rng = random.Random(SEED)

    def cases(self, least=0):
        for case in self.all_cases:
            case.learn(least)
        return self.all_cases
