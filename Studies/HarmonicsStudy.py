# SPDX-License-Identifier: BSD-3-Clause
"""Errors of the irradiance by spherical harmonics: the table of Documentation/irradiance.md.

usage: PYTHONPATH=build/python python3 HarmonicsStudy.py DEM [MAP.hdr|MAP.exr]...
Median and 95th percentile over the posts, in percent, relative to the table; 256 azimuths each.
"""

import sys

import numpy as np
import skyline
from vtkmodules.util.numpy_support import vtk_to_numpy


def light_of(name):
    light = skyline.vtkSkylineEnvironmentLight()
    if name.startswith("cie:"):
        light.SetSourceToCie()
        light.SetCieType(int(name[4:]))
    elif name != "uniform":
        reader = skyline.vtkSkylineLightMapReader()
        reader.SetFileName(name)
        reader.Update()
        light.SetSourceToImage()
        light.SetImage(reader.GetOutput())
    return light


def mean_of_colours(irradiance):
    irradiance.Update()
    array = irradiance.GetOutput().GetPointData().GetArray("Irradiance")
    return vtk_to_numpy(array).mean(axis=1)


def main(dem, *maps):
    reader = skyline.vtkHeightFieldReader()
    reader.SetFileName(dem)
    print("| light | 3 bands | 4 | 6 | 8 |\n| --- | --- | --- | --- | --- |")
    for name in ("uniform", "cie:16", "cie:12", *maps):
        irradiance = skyline.vtkHeightFieldIrradiance()
        irradiance.SetInputConnection(reader.GetOutputPort())
        irradiance.SetNumberOfAzimuths(256)
        irradiance.AddLight(light_of(name))
        truth = mean_of_colours(irradiance).copy()
        irradiance.SetLightMethodToHarmonics()
        cells = []
        for bands in (3, 4, 6, 8):
            irradiance.SetHarmonicBands(bands)
            errors = 100.0 * np.abs(mean_of_colours(irradiance) / truth - 1.0)
            errors = errors[np.isfinite(errors)]
            cells.append(f"{np.median(errors):.2f} / {np.percentile(errors, 95):.1f}")
        print("|", name.split("/")[-1], "|", " | ".join(cells), "|", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
