# SPDX-License-Identifier: BSD-3-Clause
"""Terrain that changes with every frame, together with its shadows.

Usage: dynamic_terrain.py OUT.png [FRAMES]

The picture shows four of the frames. In your own window, call move and Render for each frame.
"""

import sys
import time

import numpy as np
import skyline
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkWindowToImageFilter

POSTS = 160
SHOWN = 4

frames = int(sys.argv[2]) if len(sys.argv) == 3 else SHOWN
if len(sys.argv) not in (2, 3) or frames < SHOWN:
    sys.exit(f"usage: dynamic_terrain.py OUT.png [FRAMES, at least {SHOWN}]")
if not skyline.vtkSkylineEGLWindow.IsSupported():
    print("skipped: no OpenGL without a window system")
    sys.exit(77)

row, column = np.mgrid[0:POSTS, 0:POSTS]
distance = np.hypot(column - 80.0, row - 80.0)
terrain = skyline.to_image(np.zeros((POSTS, POSTS), np.float32), 1.0)
heights = skyline.to_array(terrain)  # a view: writing to it changes the image


def move(now):
    """A circular wave runs outwards from a drop in the middle; `now` goes from 0 to 1."""
    behind = (distance - 90.0 * now) / 9.0
    heights[::-1] = 14.0 * np.exp(-behind ** 2) * np.cos(0.9 * behind)
    terrain.GetPointData().GetScalars().Modified()  # all that filters and mapper need
    terrain.Modified()


sun = skyline.vtkSkylineSunLight()
sun.SetAzimuth(290.0)
sun.SetElevation(22.0)
sun.SetAngularRadius(1.5)  # larger than the real one, for softer shadows
sun.SetIrradiance(4.2, 3.8, 3.2)
sky = skyline.vtkSkylineEnvironmentLight()
sky.SetRadiance(0.22, 0.28, 0.38)
light = skyline.vtkHeightFieldIrradiance()
light.SetInputData(terrain)
light.SetMethodToFast()
light.SetNumberOfAzimuths(16)
light.AddLight(sun)
light.AddLight(sky)

surface = skyline.vtkHeightFieldSurface()
surface.SetInputData(terrain)
mapper = skyline.vtkSoftShadowPolyDataMapper()
mapper.SetInputConnection(surface.GetOutputPort())
mapper.ScalarVisibilityOff()
mapper.GetShader().SetHeightFieldConnection(light.GetOutputPort())
ground = vtkActor()
ground.SetMapper(mapper)
ground.GetProperty().SetColor(0.80, 0.70, 0.55)

renderer = vtkRenderer()
renderer.AddActor(ground)
renderer.SetBackground(0.72, 0.80, 0.90)
camera = renderer.GetActiveCamera()
camera.SetFocalPoint(80.0, 76.0, 0.0)
camera.SetPosition(80.0, -230.0, 230.0)
camera.SetViewUp(0.0, 0.0, 1.0)
camera.Zoom(1.25)
renderer.ResetCameraClippingRange(0.0, POSTS, 0.0, POSTS, -20.0, 20.0)
window = skyline.vtkSkylineEGLWindow()
window.SetMultiSamples(4)
window.SetSize(320, 240)
window.AddRenderer(renderer)

strip = vtkImageAppend()
start = time.perf_counter()
for frame in range(frames):
    move((frame + 0.6) / frames)
    window.Render()
    if frame * SHOWN // frames != (frame + 1) * SHOWN // frames:
        pixels = vtkWindowToImageFilter()
        pixels.SetInput(window)
        pixels.ReadFrontBufferOff()
        pixels.ShouldRerenderOff()
        pixels.Update()
        shown = vtkImageData()
        shown.DeepCopy(pixels.GetOutput())
        strip.AddInputData(shown)
print(f"{frames} frames, {1000.0 * (time.perf_counter() - start) / frames:.1f} ms each")

writer = vtkPNGWriter()
writer.SetInputConnection(strip.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
