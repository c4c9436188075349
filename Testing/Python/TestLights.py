# SPDX-License-Identifier: BSD-3-Clause
"""The lights and vtkHeightFieldIrradiance from Python."""
import math

import skyline
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkImageData

ground = vtkImageData()
ground.SetDimensions(9, 9, 1)
ground.SetSpacing(10.0, 10.0, 1.0)
heights = vtkFloatArray()
heights.SetNumberOfTuples(81)
heights.Fill(5.0)
ground.GetPointData().SetScalars(heights)

sky = skyline.vtkSkylineEnvironmentLight()
sun = skyline.vtkSkylineSunLight()
sun.SetElevation(30.0)
sun.SetIrradiance(2.0, 2.0, 2.0)

light = skyline.vtkHeightFieldIrradiance()
light.SetInputData(ground)
light.AddLight(sky)
light.AddLight(sun)


def red():
    light.Update()
    return light.GetOutput().GetPointData().GetArray("Irradiance").GetComponent(40, 0)


assert abs(red() - math.pi - 1.0) < 1e-4, red()
sun.SwitchOff()
assert abs(red() - math.pi) < 1e-4, red()
assert light.GetSunPasses() == 0
sky.SetSourceToCie()
sky.SetCieType(16)
assert abs(red() - 7.0 / 9.0 * math.pi) < 1e-3, red()
