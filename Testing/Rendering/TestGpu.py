# SPDX-License-Identifier: BSD-3-Clause
"""The graphics processor from Python: each filter is compared with its counterpart on the host."""

import sys
import unittest

import numpy
import skyline
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

SKIPPED = 77  # the exit code that ctest counts as skipped
ROUNDING = 1.0e-4  # degrees, coefficients, irradiance; the tests in C++ are stricter


def hills(columns=40, rows=30):
    """Hills of 60 m with posts 10 m apart."""
    x, y = numpy.meshgrid(numpy.arange(columns) * 0.3, numpy.arange(rows) * 0.2)
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.SetSpacing(10.0, 10.0, 1.0)
    heights = 60.0 * numpy.sin(x) * numpy.cos(y)
    image.GetPointData().SetScalars(numpy_to_vtk(heights.ravel(), deep=1))
    return image


def values(filter_, name):
    filter_.SetInputData(hills())
    filter_.SetNumberOfAzimuths(5)
    filter_.Update()
    return vtk_to_numpy(filter_.GetOutput().GetPointData().GetArray(name))


class TestGpu(unittest.TestCase):
    def test_arrays_are_those_of_the_host(self):
        for name, array in [("Horizon", "HorizonElevation"), ("Visibility", "VisibilitySH"),
                            ("Transfer", "TransferSH")]:
            gpu = getattr(skyline, "vtkOpenGLHeightField" + name)()
            host = getattr(skyline, "vtkHeightField" + name)()
            gpu.SetDevice(DEVICE)
            self.assertIsInstance(gpu, type(host))
            numpy.testing.assert_allclose(
                values(gpu, array), values(host, array), atol=ROUNDING, err_msg=name)
            self.assertTrue(gpu.IsOnDevice(), name)

    def test_irradiance(self):
        key = skyline.vtkSkylineKeyLight()
        gpu = skyline.vtkOpenGLHeightFieldIrradiance()
        host = skyline.vtkHeightFieldIrradiance()
        host.SetLightMethodToHarmonics()
        gpu.SetDevice(DEVICE)
        for filter_ in (gpu, host):
            filter_.AddLight(key)
        numpy.testing.assert_allclose(
            values(gpu, "Irradiance"), values(host, "Irradiance"), atol=ROUNDING)
        self.assertTrue(gpu.IsOnDevice())
        self.assertEqual(gpu.GetTexture().GetWidth(), 40)
        gpu.MeasurePassesOn()
        seconds = [0.0] * 5
        gpu.Update()
        gpu.GetPassSeconds(seconds)
        self.assertGreater(sum(seconds), 0.0)


if __name__ == "__main__":
    DEVICE = skyline.vtkOpenGLHeightFieldDevice()
    if not DEVICE.IsAvailable():
        print("skipped: no OpenGL context:", DEVICE.GetReason())
        sys.exit(SKIPPED)
    unittest.main()
