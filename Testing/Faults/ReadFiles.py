# SPDX-License-Identifier: BSD-3-Clause
"""Reads files with SkylineReadFiles (ReadFiles.cxx): many in one process, and a new one after each
crash."""
import os
import re
import resource
import subprocess

from Faults import LIBRARY, sanitized

PROGRAM = os.environ.get("SKYLINE_READ_FILES", "")

# Seconds for one file. Without sanitizers the slowest refused file takes less than 2.
PATIENCE = 60

# Address space of the process in MB: larger claims of a file fail for lack of memory.
MEMORY = 4096

# With a sanitizer the address space cannot be limited, and a failed allocation ends the process.
SANITIZER = {
    "ASAN_OPTIONS": "detect_leaks=0:allocator_may_return_null=1:max_allocation_size_mb=%d:"
                    "hard_rss_limit_mb=%d" % (MEMORY // 2, MEMORY),
    "UBSAN_OPTIONS": "print_stacktrace=1"}
OUT_OF_MEMORY = re.compile("allocation-size-too-big|out-of-memory|hard rss limit exhausted")


class Verdict:
    """The outcome of a file: "read", "refused", "wrong", "too large" or "crashed", and the reason."""

    def __init__(self, word, reason="", seconds=0.0, megabytes=0.0):
        self.word, self.reason = word, reason
        self.seconds, self.megabytes = seconds, megabytes

    def __str__(self):
        return "%s %s (%.1f s, %.0f MB)" % (self.word, self.reason, self.seconds, self.megabytes)


def limit():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if not sanitized(PROGRAM):
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY << 20, MEMORY << 20))


def why_it_ended(code, said):
    """The verdict for the file that a process was reading when it ended."""
    memory = OUT_OF_MEMORY.search(said)
    if memory:
        return Verdict("too large", memory.group())
    lines = [line for line in said.splitlines()
             if "ERROR: AddressSanitizer" in line or "runtime error" in line or "terminate" in line]
    return Verdict("crashed", "exit %d %s" % (code, (lines or said.splitlines()[-1:] or [""])[0]))


def read_files(files, log=""):
    """The verdicts of (kind, path) pairs, in their order. kind is "raster" or "light". The file `log` lists
    the addresses that the files tried to reach."""
    environment = dict(os.environ, SKYLINE_CALL_LOG=log, **SANITIZER)
    if LIBRARY and log and not sanitized(PROGRAM):
        environment["LD_PRELOAD"] = LIBRARY  # so that the log also lists opened files
    verdicts = []
    while len(verdicts) < len(files):
        rest = files[len(verdicts):]
        text = "".join("%s %s\n" % pair for pair in rest)
        done = subprocess.run([PROGRAM, str(PATIENCE)], input=text, capture_output=True,
                              encoding="utf-8", errors="replace", env=environment, preexec_fn=limit)
        lines = done.stdout.splitlines()
        reading = False
        for line in lines:
            if line.startswith("reading "):
                reading = True
            elif reading and line.startswith(("read ", "refused ", "wrong ")):
                word, seconds, megabytes, reason = (line.split(" ", 3) + [""])[:4]
                verdicts.append(Verdict(word, reason, float(seconds), float(megabytes)))
                reading = False
        if reading:
            verdicts.append(why_it_ended(done.returncode, done.stderr))
        elif len(lines) == 0:
            raise RuntimeError("%s: exit %d %s" % (PROGRAM, done.returncode, done.stderr[:500]))
    return verdicts
