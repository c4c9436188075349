# SPDX-License-Identifier: BSD-3-Clause
"""Runs the examples of an idea as Documentation/examples.md writes them, and checks their output.

    TestExample.py IDEA SOURCE BIN OUTPUT PROGRAM...

The picture of each program is checked by numbers taken from it, and compared with the picture of the
page and with that of the other language.
"""

import os
import re
import shlex
import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SKIPPED = 77  # the exit code of an example without OpenGL
DRIFT = 4.0  # sRGB codes, mean: the edges of another OpenGL differ by less, another light by far more
# The two languages make the same calls. The values that numpy and C++ compute themselves may round
# differently, by one code, and pixels of contour lines or edges by more.
ROUNDED, OTHER_PIXELS = 1.0, 1e-3


def read(file):
    """(rows, columns, channels), where row 0 is the top."""
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels.reshape(rows, columns, -1)[::-1].astype(float)


def grey(picture):
    return picture[..., :3].mean(axis=-1)


def command_of(name):
    """The line of the page that runs the program."""
    with open(os.path.join(SOURCE, "Documentation", "examples.md"), encoding="utf-8") as page:
        lines = [line.strip() for line in page if line.startswith("    ") and name in line]
    assert len(lines) == 1, (name, lines)
    return lines[0]


def run(command):
    """Runs a line of the page in the folder OUTPUT."""
    environment = dict(os.environ, dem=os.path.join(SOURCE, "Testing/Data/dem/SainteHelens.tif"),
                       maps=os.path.join(SOURCE, "Testing/Data/light-maps"))
    command = command.replace("build/bin/", f"{BIN}/").replace(" Examples/", f" {SOURCE}/Examples/")
    command = command.replace("python3 ", shlex.quote(sys.executable) + " ")
    done = subprocess.run(["bash", "-ec", command], cwd=OUTPUT, env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode == SKIPPED:
        print((done.stdout + done.stderr).strip())
        sys.exit(SKIPPED)
    assert done.returncode == 0, (done.returncode, done.stdout, done.stderr)
    assert "rror" not in done.stderr, done.stderr
    return done.stdout


def check_sky_view_array(picture, said):
    assert said.startswith("468 x 327 posts"), said
    assert picture.shape[:2] == (468, 327)
    crater, plain = grey(picture)[170:210, 150:190], grey(picture)[430:460, 100:220]
    assert crater.mean() < plain.mean() - 60.0, (crater.mean(), plain.mean())


def check_sun_over_a_day(picture, said):
    lit = [float(number) for number in re.findall(r"lit (\S+)", said)]
    assert len(lit) == 8 and np.argmax(lit) == 4, lit
    assert lit == sorted(lit[:5]) + sorted(lit[5:], reverse=True), "it rises, and it sets"
    rows, columns = picture.shape[0] // 2, picture.shape[1] // 4
    frames = [grey(picture)[rows * (k // 4):rows * (k // 4 + 1), columns * (k % 4):columns * (k % 4 + 1)]
              for k in range(8)]
    # The shadow lies beside the summit: in the west in the morning, in the east in the evening.
    west, east = (slice(85, 125), slice(20, 60)), (slice(85, 125), slice(105, 135))
    for morning, evening in [(1, 7), (2, 6)]:
        assert frames[morning][west].mean() < frames[morning][east].mean() - 10.0
        assert frames[evening][east].mean() < frames[evening][west].mean() - 10.0
    assert frames[0].mean() < frames[2].mean() < frames[4].mean()
    folder = os.path.join(OUTPUT, line.split()[-1])
    assert len(os.listdir(folder)) == 8
    assert np.ptp(read(os.path.join(folder, "04.png"))) > 100.0


def check_hdr_environment(picture, said):
    run(line.replace(f"{written} 240", "turned.png 60"))
    turned = read(os.path.join(OUTPUT, "turned.png"))
    west, east = (slice(145, 185), slice(270, 330)), (slice(145, 185), slice(465, 525))
    slopes = [grey(p)[side].mean() for p in (picture, turned) for side in (west, east)]
    assert slopes[0] > slopes[1] + 8.0 and slopes[3] > slopes[2] + 8.0, slopes


def check_lamps_at_night(picture, said):
    least, most = (float(number) for number in re.search(r"(\S+) to (\S+)", said).groups())
    assert 0.0 < least < 0.2 and most > 10.0, said
    red, blue = picture[..., 0], picture[..., 2]
    assert np.median(grey(picture)) < 70.0, "it is night"
    assert np.sum((red > 150.0) & (red > 1.4 * blue)) > 200, "orange light"
    assert np.sum((blue > 120.0) & (blue > 1.15 * red)) > 50, "bluish light"


def check_building_shadows(picture, said):
    assert "0 to 1 of the sun" in said, said
    light = grey(picture)
    open_ground, own_shadow, behind_hill = light[400, 700], light[237, 545], light[300, 280]
    assert own_shadow < 0.75 * open_ground and behind_hill < 0.75 * open_ground
    upper, lower = light[200, 418], light[274, 418]
    assert lower < 0.6 * upper, "the hill's shadow climbs the wall"


def check_draped_texture(picture, said):
    snow, forest = picture[225, 390], picture[420, 250]
    assert snow.min() > 140.0, snow
    assert forest[1] > forest[0] and forest[1] > 1.5 * forest[2], forest


def check_dynamic_terrain(picture, said):
    assert "4 frames" in said, said
    assert picture.shape[:2] == (240, 4 * 320)
    frames = [picture[:, 320 * k:320 * (k + 1)] for k in range(4)]
    ground = frames[0][195, 160]
    dark = [np.sum(grey(frame) < 0.6 * ground.mean()) for frame in frames]
    assert 200 < dark[0] < dark[1] < dark[2], dark


IDEA, SOURCE, BIN, OUTPUT, *PROGRAMS = sys.argv[1:]
os.makedirs(OUTPUT, exist_ok=True)
shown, pictures = None, []
for program in PROGRAMS:
    line = command_of(program)
    written = re.search(r"\S+\.png", line).group(0)
    said = run(line)
    picture = read(os.path.join(OUTPUT, written))
    globals()["check_" + IDEA](picture, said)
    if shown is None:
        page = os.path.join(SOURCE, "Documentation", "images", "examples")
        shown = read(os.path.join(page, IDEA.replace("_", "-") + ".png"))
    assert shown.shape == picture.shape, (shown.shape, picture.shape)
    drift = np.abs(shown - picture).mean()
    assert drift < DRIFT, f"{written} is {drift:.1f} codes from the picture of the page: make a new one"
    pictures.append(picture)

for other in pictures[1:]:
    apart = np.abs(pictures[0] - other).max(axis=-1)
    others = (apart > ROUNDED).mean()
    print(f"{apart.mean():.5f} codes apart in the mean, {others:.1e} of the pixels by more than one")
    assert others < OTHER_PIXELS, "C++ and Python show two pictures"
