# SPDX-License-Identifier: BSD-3-Clause
"""A DEM in the light of an HDR environment, drawn without a window.

Usage: hdr_environment.py DEM MAP.hdr OUT.png [DEGREES]

DEGREES is the angle by which the map is turned clockwise.
"""

import sys

import skyline
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkWindowToImageFilter

if len(sys.argv) not in (4, 5):
    sys.exit("usage: hdr_environment.py DEM MAP.hdr OUT.png [DEGREES]")
if not skyline.vtkSkylineEGLWindow.IsSupported():
    print("skipped: no OpenGL without a window system")
    sys.exit(77)

terrain = skyline.read(sys.argv[1])
rotation = float(sys.argv[4]) if len(sys.argv) == 5 else 0.0
lit = skyline.irradiance(terrain, environment=sys.argv[2], rotation=rotation, azimuths=64)

surface = skyline.vtkHeightFieldSurface()
surface.SetInputData(terrain)
mapper = skyline.vtkSoftShadowPolyDataMapper()
mapper.SetInputConnection(surface.GetOutputPort())
mapper.ScalarVisibilityOff()
mapper.GetShader().SetHeightField(lit)
mapper.GetShader().SetExposure(-1.2)  # in stops: a factor of 2^-1.2
ground = vtkActor()
ground.SetMapper(mapper)
ground.GetProperty().SetColor(0.82, 0.78, 0.72)

renderer = vtkRenderer()
renderer.AddActor(ground)
renderer.SetBackground(0.45, 0.58, 0.74)
renderer.ResetCamera()
camera = renderer.GetActiveCamera()
camera.Elevation(-55.0)  # seen from the south
camera.Pitch(-2.0)
camera.Zoom(1.7)
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
writer.SetFileName(sys.argv[3])
writer.Write()
