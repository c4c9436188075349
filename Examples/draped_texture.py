# SPDX-License-Identifier: BSD-3-Clause
"""A picture draped over a DEM, in the light of sun and sky.

Usage: draped_texture.py DEM OUT.png

Here, the picture is computed from the heights. You can use any RGB array whose row 0 is the northern edge.
"""

import sys

import numpy as np
import skyline
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersTexture import vtkTextureMapToPlane
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkTexture, vtkWindowToImageFilter


def paint(heights):
    """The sRGB colours: snow above forest, rock where it is steep, a contour line every 100 metres."""
    down, right = np.gradient(heights, 30.0)
    steep = np.hypot(right, down)[..., None]
    height = heights[..., None]
    forest, meadow, rock, snow = np.array([[60, 84, 48], [134, 140, 84], [128, 118, 108], [240, 243, 248]])
    color = forest + (meadow - forest) * np.clip((height - 900.0) / 400.0, 0.0, 1.0)
    color = color + (rock - color) * np.clip((steep - 0.35) / 0.2, 0.0, 1.0)
    color = color + (snow - color) * np.clip((height - 1700.0) / 150.0, 0.0, 1.0) * (steep < 0.9)
    beside = heights // 100.0
    line = (beside != np.roll(beside, 1, axis=0)) | (beside != np.roll(beside, 1, axis=1))
    color[line] *= 0.75
    return np.nan_to_num(color, nan=128.0).clip(0, 255).astype(np.uint8)


def to_texture(picture):
    flat = np.ascontiguousarray(picture[::-1]).reshape(-1, 3)  # row 0 of VTK is the southern edge
    image = vtkImageData()
    image.SetDimensions(picture.shape[1], picture.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOn()
    texture.MipmapOn()
    return texture


if len(sys.argv) != 3:
    sys.exit("usage: draped_texture.py DEM OUT.png")
if not skyline.vtkSkylineEGLWindow.IsSupported():
    print("skipped: no OpenGL without a window system")
    sys.exit(77)

terrain = skyline.read(sys.argv[1])
sky = skyline.vtkSkylineEnvironmentLight()
sky.SetRadiance(0.22, 0.28, 0.40)
lit = skyline.irradiance(terrain, lights=[sky], sun=(285.0, 20.0), sun_irradiance=(4.2, 3.7, 3.0),
                         azimuths=64)

surface = skyline.vtkHeightFieldSurface()
surface.SetInputData(terrain)
surface.Update()
west, east, south, north, *_ = terrain.GetBounds()
drape = vtkTextureMapToPlane()  # texture coordinates: 0 to 1, towards east and north
drape.SetInputConnection(surface.GetOutputPort())
drape.SetOrigin(west, south, 0.0)
drape.SetPoint1(east, south, 0.0)
drape.SetPoint2(west, north, 0.0)

mapper = skyline.vtkSoftShadowPolyDataMapper()
mapper.SetInputConnection(drape.GetOutputPort())
mapper.ScalarVisibilityOff()
mapper.GetShader().SetHeightField(lit)
ground = vtkActor()
ground.SetMapper(mapper)
ground.SetTexture(to_texture(paint(skyline.to_array(terrain).astype(float))))
renderer = vtkRenderer()
renderer.AddActor(ground)
renderer.GradientBackgroundOn()
renderer.SetBackground(0.80, 0.86, 0.93)
renderer.SetBackground2(0.45, 0.62, 0.85)

camera = renderer.GetActiveCamera()
camera.SetFocalPoint(0.5 * (west + east), 0.52 * south + 0.48 * north, 1400.0)
camera.SetPosition(0.5 * (west + east) - 4000.0, south - 13500.0, 11000.0)
camera.SetViewUp(0.0, 0.0, 1.0)
camera.Zoom(1.25)
window = skyline.vtkSkylineEGLWindow()
window.SetMultiSamples(4)
window.SetSize(800, 500)
window.AddRenderer(renderer)
renderer.ResetCameraClippingRange()

pixels = vtkWindowToImageFilter()
pixels.SetInput(window)
pixels.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(pixels.GetOutputPort())
writer.SetFileName(sys.argv[2])
writer.Write()
