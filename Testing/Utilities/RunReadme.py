# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands and the Python code of the README as they are written there.

RunReadme.py SOURCE PROGRAM OUTPUT PYTHONPATH
"""

import os
import re
import subprocess
import sys

source, program, output, python_path = sys.argv[1:]
readme = open(os.path.join(source, "README.md"), encoding="utf-8").read()

commands = [line.strip() for line in readme.splitlines() if line.strip().startswith("$skyline ")]
assert len(commands) >= 7, commands
environment = dict(
    os.environ, skyline=program, dem=os.path.join(source, "Testing/Data/dem/SainteHelens.tif")
)
written, left_out = [], []
for command in commands:
    print(command, flush=True)
    run = subprocess.run(
        ["bash", "-ec", command], cwd=output, env=environment, stderr=subprocess.PIPE, text=True
    )
    if "a perspective view needs OpenGL" in run.stderr:
        print("  left out:", run.stderr.strip())
        left_out.append(command)
        continue
    assert run.returncode == 0, run.stderr
    written += re.findall(r"-o (\S+)", command)
for name in written:
    assert os.path.getsize(os.path.join(output, name)) > 10000, name

environment["PYTHONPATH"] = python_path
codes = re.findall(r"```python\n(.*?)```", readme, re.S)
expected = ["(468, 327) [1. 0. 1.]", "153036 posts"]
assert len(codes) == len(expected), codes
for code, start in zip(codes, expected):
    printed = subprocess.run(
        [sys.executable, "-c", code], cwd=source, env=environment, check=True, stdout=subprocess.PIPE
    ).stdout.decode()
    assert printed.startswith(start), printed

if left_out:
    print("all other commands and programs passed; not run, for lack of OpenGL:", *left_out, sep="\n  ")
    sys.exit(77)  # ctest reports the test as skipped
