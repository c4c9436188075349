# SPDX-License-Identifier: BSD-3-Clause
"""A scene scripted in Python, compared with a stored picture.

Run as `python3 TestSoftShadowImages.py DATA OUTPUT`: Testing/Data, and a folder for output.
"""

import os
import sys
import unittest

import numpy as np
import skyline
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

SKIPPED = 77  # the exit code that ctest counts as skipped
CODE_THRESHOLD = 2  # as in BaselineTesting.h
RIM_PIXELS = 4.0


def ridges():
    """Ridges with the irradiance of a sun and a sky, computed by the filters."""
    image = vtkImageData()
    image.SetDimensions(90, 70, 1)
    image.SetSpacing(30.0, 30.0, 1.0)
    y, x = np.mgrid[0:70, 0:90]
    heights = 120.0 * np.sin(0.12 * x + 0.05 * y) + 60.0 * np.cos(0.17 * y)
    array = numpy_to_vtk(heights.ravel(), deep=True)
    array.SetName("Elevation")
    image.GetPointData().SetScalars(array)
    return image


def lit(image):
    """The image with Irradiance: a low sun, partly hidden by the ridges, and a uniform sky."""
    sun = skyline.vtkHeightFieldSunShadow()
    sun.SetInputData(image)
    sun.SetSunAzimuth(250.0)
    sun.SetSunElevation(20.0)
    sky = skyline.vtkHeightFieldSkyView()
    sky.SetInputConnection(sun.GetOutputPort())
    sky.SetInputArrayToProcess(0, 0, 0, 0, "Elevation")
    sky.SetNumberOfAzimuths(32)
    sky.Update()
    result = sky.GetOutput()
    heights = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(70, 90)
    north, east = np.gradient(heights, 30.0)
    to_sun = np.array([-0.883, -0.321, 0.342])
    facing = np.clip((-east * to_sun[0] - north * to_sun[1] + to_sun[2])
                     / np.sqrt(1.0 + east**2 + north**2), 0.0, None).ravel()
    seen = vtk_to_numpy(result.GetPointData().GetArray("SunVisibility"))
    open_sky = vtk_to_numpy(result.GetPointData().GetArray("SkyViewFactor"))
    light = np.outer(seen * facing, [4.0, 3.6, 3.0]) + np.outer(open_sky, [0.5, 0.6, 0.8])
    array = numpy_to_vtk(light.astype(np.float32), deep=True)
    array.SetName("Irradiance")
    result.GetPointData().AddArray(array)
    return result


def picture_of(window):
    pixels = vtkUnsignedCharArray()
    width, height = window.GetSize()
    window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
    picture = vtkImageData()
    picture.SetDimensions(width, height, 1)
    picture.GetPointData().SetScalars(pixels)
    return picture


class SoftShadowImages(unittest.TestCase):
    def expect_baseline(self, window, name):
        picture = picture_of(window)
        baseline = os.path.join(DATA, "Baseline", name + ".png")
        error = 1.0e9
        if os.path.exists(baseline):
            reader = vtkPNGReader()
            reader.SetFileName(baseline)
            reader.Update()
            difference = vtkImageDifference()
            difference.SetInputData(picture)
            difference.SetImageData(reader.GetOutput())
            difference.SetThreshold(CODE_THRESHOLD)
            difference.AllowShiftOff()
            difference.AveragingOff()
            difference.Update()
            error = difference.GetThresholdedError()
        seen = os.path.join(OUTPUT, name + ".png")
        if error > RIM_PIXELS:
            writer = vtkPNGWriter()
            writer.SetFileName(seen)
            writer.SetInputData(picture)
            writer.Write()
        self.assertLessEqual(error, RIM_PIXELS, f"compare {seen} with {baseline}")

    def test_ridges(self):
        surface = skyline.vtkHeightFieldSurface()
        surface.SetInputData(ridges())
        mapper = skyline.vtkSkylineSoftShadowPolyDataMapper()
        mapper.SetInputConnection(surface.GetOutputPort())
        mapper.ScalarVisibilityOff()
        mapper.GetShader().SetHeightField(lit(ridges()))
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.85, 0.8, 0.7)
        renderer = vtkRenderer()
        renderer.AddActor(actor)
        renderer.SetBackground(0.6, 0.7, 0.85)
        window = skyline.vtkSkylineEGLWindow()
        window.SetSize(240, 150)
        window.AddRenderer(renderer)
        camera = renderer.GetActiveCamera()
        camera.SetFocalPoint(1335.0, 1035.0, 0.0)
        camera.SetPosition(1335.0, -2600.0, 2600.0)
        camera.SetViewUp(0.0, 0.0, 1.0)
        renderer.ResetCameraClippingRange()
        window.Render()
        self.assertEqual(mapper.GetShader().GetNumberOfTextureUploads(), 1)
        self.expect_baseline(window, "SoftShadowPython")


if __name__ == "__main__":
    DATA, OUTPUT = sys.argv[1:3]
    if not skyline.vtkSkylineEGLWindow.IsSupported():
        print("skipped: no OpenGL context without a window system")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
