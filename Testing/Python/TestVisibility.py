#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Visibility and transfer from Python: the irradiance is a dot product."""

import math
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

import skyline


def eggtray(size=48):
    """Hills of 60 m, 320 m apart, with posts 10 m apart."""
    x = numpy.arange(size) * 2.0 * math.pi / 32.0
    image = vtkImageData()
    image.SetDimensions(size, size, 1)
    image.SetSpacing(10.0, 10.0, 1.0)
    heights = 60.0 * numpy.outer(numpy.sin(x), numpy.sin(x))
    image.GetPointData().SetScalars(numpy_to_vtk(heights.ravel().astype("f4"), deep=1))
    return image


def coefficients(filter_, name):
    filter_.SetInputData(eggtray())
    filter_.SetNumberOfAzimuths(16)
    filter_.Update()
    return vtk_to_numpy(filter_.GetOutput().GetPointData().GetArray(name))


class TestVisibility(unittest.TestCase):
    def test_transfer_times_uniform_light_is_pi_times_the_sky_view_factor(self):
        transfer = coefficients(skyline.vtkHeightFieldTransfer(), "TransferSH")
        self.assertEqual(transfer.shape, (48 * 48, 16))
        light = numpy.zeros(16)
        light[0] = math.sqrt(4.0 * math.pi)  # radiance 1
        factor = coefficients(skyline.vtkHeightFieldSkyView(), "SkyViewFactor")
        numpy.testing.assert_allclose(transfer @ light, math.pi * factor, atol=1e-5)

    def test_order_and_swath(self):
        visibility = skyline.vtkHeightFieldVisibility()
        visibility.SetNumberOfBands(6)
        visibility.SetSwathAzimuth(135.0)
        visibility.SetSwathWidth(20.0)
        values = coefficients(visibility, "VisibilitySH")
        self.assertEqual(values.shape, (48 * 48, 36))
        # At most the swath's share of sqrt(pi), the norm of the hemisphere.
        self.assertLessEqual(values[:, 0].max(), math.sqrt(math.pi) * 20.0 / 360.0 + 1e-6)

    def test_pyramid(self):
        visibility = skyline.vtkHeightFieldVisibility()
        visibility.SetMethodToPyramid()
        visibility.SetLevelStep(2.0)
        self.assertTrue(numpy.isfinite(coefficients(visibility, "VisibilitySH")).all())


if __name__ == "__main__":
    unittest.main()
