# SPDX-License-Identifier: BSD-3-Clause
"""A tower beside a hill.

The shadow of the hill falls on the walls of the tower, and the shadow of the tower falls on the ground.

Usage: building_shadows.py OUT.png
"""

import sys

import numpy as np
import skyline
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersSources import vtkTessellatedBoxSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkWindowToImageFilter,
)

POSTS = 401  # posts per side: a square of 400 m with one post per metre
SUN_AZIMUTH, SUN_ELEVATION, SUN_RADIUS = 250.0, 18.0, 0.5

if len(sys.argv) != 2:
    sys.exit("usage: building_shadows.py OUT.png")
if not skyline.vtkSkylineEGLWindow.IsSupported():
    print("skipped: no OpenGL without a window system")
    sys.exit(77)

row, column = np.mgrid[0:POSTS, 0:POSTS]  # rows from the south, like y of the building
distance = np.hypot((column - 110.0) / 50.0, (row - 170.0) / 80.0)
hill = skyline.to_image((60.0 * np.exp(-distance ** 2)).astype(np.float32), 1.0, row0="south")

# The building: any polygons in the coordinates of the image. They are small, so that the edges of shadows
# are visible on them.
model = vtkTessellatedBoxSource()
# The walls reach nearly to the next posts, so that the light of the roof is not interpolated onto the
# ground beside it.
model.SetBounds(224.05, 250.95, 194.05, 220.95, 0.0, 80.0)
model.SetLevel(60)

# The shadow that the building casts: on the ground, raised to the building.
cap = skyline.vtkHeightFieldCap()
cap.SetInputData(hill)
cap.SetObjectsConnection(model.GetOutputPort())
sun = skyline.vtkSkylineSunLight()
sun.SetAzimuth(SUN_AZIMUTH)
sun.SetElevation(SUN_ELEVATION)
sun.SetAngularRadius(SUN_RADIUS)
sun.SetIrradiance(4.0, 3.6, 3.0)
sky = skyline.vtkSkylineEnvironmentLight()
sky.SetRadiance(0.25, 0.32, 0.45)
light = skyline.vtkHeightFieldIrradiance()
light.SetInputConnection(cap.GetOutputPort())
light.AddLight(sun)
light.AddLight(sky)
light.SetNumberOfAzimuths(32)

# The shadow that the hill casts on the building: SunVisibility at the points of the building.
shadow = skyline.vtkShadowHeightMap()
shadow.SetInputData(hill)
shadow.SetSunAzimuth(SUN_AZIMUTH)
shadow.SetSunElevation(SUN_ELEVATION)
shadow.SetSunAngularRadius(SUN_RADIUS)
shadow.SoftOn()
receiver = skyline.vtkShadowReceiver()
receiver.SetInputConnection(model.GetOutputPort())
receiver.SetShadowConnection(shadow.GetOutputPort())
skyline.update(receiver)
lit = vtk_to_numpy(receiver.GetOutput().GetPointData().GetArray("SunVisibility"))
print(f"the tower's points see {lit.min():g} to {lit.max():g} of the sun")

surface = skyline.vtkHeightFieldSurface()
surface.SetInputData(hill)
ground_mapper = skyline.vtkSoftShadowPolyDataMapper()
ground_mapper.SetInputConnection(surface.GetOutputPort())
ground_mapper.ScalarVisibilityOff()
ground_mapper.GetShader().SetHeightFieldConnection(light.GetOutputPort())
ground = vtkActor()
ground.SetMapper(ground_mapper)
ground.GetProperty().SetColor(0.62, 0.68, 0.52)

colors = vtkLookupTable()  # colours of the walls, from full shadow to full sun
colors.SetNumberOfTableValues(256)
for i in range(256):
    part = i / 255.0
    colors.SetTableValue(i, 0.36 + 0.62 * part, 0.38 + 0.53 * part, 0.46 + 0.32 * part)
tower_mapper = vtkPolyDataMapper()
tower_mapper.SetInputConnection(receiver.GetOutputPort())
tower_mapper.SetScalarModeToUsePointFieldData()
tower_mapper.SelectColorArray("SunVisibility")
tower_mapper.SetLookupTable(colors)
tower_mapper.SetScalarRange(0.0, 1.0)
building = vtkActor()
building.SetMapper(tower_mapper)
building.GetProperty().SetAmbient(0.4)
building.GetProperty().SetDiffuse(0.6)
sunlight = vtkLight()  # lights only the walls; the ground has Skyline's light
sunlight.SetLightTypeToSceneLight()
azimuth, elevation = np.radians([SUN_AZIMUTH, SUN_ELEVATION])
sunlight.SetPosition(np.sin(azimuth), np.cos(azimuth), np.tan(elevation))

renderer = vtkRenderer()
renderer.AddActor(ground)
renderer.AddActor(building)
renderer.AddLight(sunlight)
renderer.SetBackground(0.70, 0.79, 0.90)
camera = renderer.GetActiveCamera()
camera.SetFocalPoint(225.0, 190.0, 25.0)
camera.SetPosition(150.0, -300.0, 260.0)
camera.SetViewUp(0.0, 0.0, 1.0)
renderer.ResetCameraClippingRange()

window = skyline.vtkSkylineEGLWindow()
window.SetMultiSamples(4)
window.SetSize(800, 500)
window.AddRenderer(renderer)
pixels = vtkWindowToImageFilter()
pixels.SetInput(window)
pixels.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(pixels.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
