# SPDX-License-Identifier: BSD-3-Clause
"""The sun over a DEM during one day: a picture for each of several hours, and all of them side by side.

Usage: sun_over_a_day.py DEM STRIP.png [FRAMES_FOLDER]

To make a film of the frames: ffmpeg -framerate 4 -i FRAMES_FOLDER/%02d.png day.mp4
"""

import os
import sys

import numpy as np
import skyline

DAY = ["21T12:45", "21T13:15", "21T14:00", "21T16:00", "21T20:00", "22T00:00", "22T02:30", "22T03:30"]
SHRINK = 2  # so many pixels of a frame become one pixel of the strip


def smaller(picture):
    """The picture, reduced to the means of SHRINK x SHRINK pixels."""
    rows, columns = (size // SHRINK for size in picture.shape[:2])
    blocks = picture[:rows * SHRINK, :columns * SHRINK].reshape(rows, SHRINK, columns, SHRINK, -1)
    return blocks.mean(axis=(1, 3)).astype(np.uint8)


if len(sys.argv) not in (3, 4):
    sys.exit("usage: sun_over_a_day.py DEM STRIP.png [FRAMES_FOLDER]")

# The light of the sky does not change during the day, so it is computed once.
terrain = skyline.sky_view(skyline.read(sys.argv[1]), azimuths=36)

sun = skyline.vtkSkylineSunLight()  # both filters use it
sun.UseTimeOn()

shadow = skyline.vtkHeightFieldSunShadow()
shadow.SetInputData(terrain)
shadow.SetSun(sun)

shading = skyline.vtkHeightFieldShading()
shading.SetInputConnection(shadow.GetOutputPort())
shading.SetInputArrayToProcess(0, 0, 0, 0, "Elevation")
shading.SetSun(sun)
shading.AutoExposureOff()  # the same exposure for the whole day

frames = []
for number, moment in enumerate(DAY):
    time = f"2026-06-{moment}Z"
    azimuth, elevation, _ = skyline.sun_position(terrain, time)
    height = min(max(elevation / 25.0, 0.0), 1.0)  # a low sun is weak and red
    sun.SetIrradiance(3.0 * height ** 0.4, 2.8 * height ** 0.7, 2.5 * height)
    sky = 0.05 + 0.15 * height
    shading.SetSkyRadiance(0.8 * sky, 1.0 * sky, 1.35 * sky)
    sun.SetTime(time)
    shading.Update()
    picture = shading.GetOutput()
    lit = np.nanmean(skyline.to_array(picture, "SunVisibility"))
    print(f"{time}  azimuth {azimuth:5.1f}  elevation {elevation:5.1f}  lit {lit:.2f}")
    frames.append(smaller(skyline.to_array(picture, "Picture")))
    if len(sys.argv) == 4:
        os.makedirs(sys.argv[3], exist_ok=True)
        skyline.write(os.path.join(sys.argv[3], f"{number:02d}.png"), picture, names="Picture")

half = len(frames) // 2
skyline.write(sys.argv[2], np.concatenate([np.concatenate(frames[:half], axis=1),
                                           np.concatenate(frames[half:], axis=1)]))
