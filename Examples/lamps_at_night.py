# SPDX-License-Identifier: BSD-3-Clause
"""Glowing balls above a crater at night, under a faint sky.

Usage: lamps_at_night.py DEM OUT.png
"""

import sys

import numpy as np
import skyline
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkWindowToImageFilter

LAMPS = [  # column and row of the DEM (from the north-west), metres above ground, radius, colour
    (165, 222, 150.0, 60.0, (1.0, 0.55, 0.2)),
    (135, 200, 120.0, 40.0, (1.0, 0.8, 0.5)),
    (196, 196, 120.0, 40.0, (0.5, 0.75, 1.0)),
    (160, 150, 200.0, 60.0, (0.9, 1.0, 0.6)),
]
RADIANCE = 40.0

if len(sys.argv) != 3:
    sys.exit("usage: lamps_at_night.py DEM OUT.png")
if not skyline.vtkSkylineEGLWindow.IsSupported():
    print("skipped: no OpenGL without a window system")
    sys.exit(77)

terrain = skyline.read(sys.argv[1])
heights = skyline.to_array(terrain)
west, south, _ = terrain.GetOrigin()
dx, dy, _ = terrain.GetSpacing()

renderer = vtkRenderer()
lights = [skyline.vtkSkylineEnvironmentLight()]
lights[0].SetRadiance(0.06, 0.08, 0.14)
for column, row, above, radius, color in LAMPS:
    place = (west + column * dx, south + (heights.shape[0] - 1 - row) * dy, heights[row, column] + above)
    lamp = skyline.vtkSkylineLampLight()
    lamp.SetPosition(place)
    lamp.SetRadius(radius)
    lamp.SetRadiance(*(RADIANCE * part for part in color))
    lights.append(lamp)

    ball = vtkSphereSource()  # the ball that shows the lamp itself in the picture
    ball.SetCenter(place)
    ball.SetRadius(radius)
    ball.SetThetaResolution(32)
    ball.SetPhiResolution(32)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(ball.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(*(0.5 + 0.5 * part for part in color))
    renderer.AddActor(actor)

lit = skyline.irradiance(terrain, lights=lights, azimuths=64)
green = skyline.to_array(lit, "Irradiance")[..., 1]
print(f"green irradiance {np.nanmin(green):.3f} to {np.nanmax(green):.1f}")

surface = skyline.vtkHeightFieldSurface()
surface.SetInputData(terrain)
mapper = skyline.vtkSoftShadowPolyDataMapper()
mapper.SetInputConnection(surface.GetOutputPort())
mapper.ScalarVisibilityOff()
mapper.GetShader().SetHeightField(lit)
ground = vtkActor()
ground.SetMapper(mapper)
ground.GetProperty().SetColor(0.75, 0.72, 0.68)
renderer.AddActor(ground)
renderer.SetBackground(0.02, 0.025, 0.05)

camera = renderer.GetActiveCamera()
camera.SetFocalPoint(west + 165 * dx, south + 265 * dy, 1900.0)
camera.SetPosition(west + 140 * dx, south + 460 * dy, 5200.0)  # from the north, looking into the crater
camera.SetViewUp(0.0, 0.0, 1.0)
window = skyline.vtkSkylineEGLWindow()
window.SetMultiSamples(4)
window.SetSize(800, 500)
window.AddRenderer(renderer)
camera.Zoom(1.15)
renderer.ResetCameraClippingRange()

pixels = vtkWindowToImageFilter()
pixels.SetInput(window)
pixels.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(pixels.GetOutputPort())
writer.SetFileName(sys.argv[2])
writer.Write()
