# SPDX-License-Identifier: BSD-3-Clause
"""Code that the tests of the representation Soft Shadow Surface share: a view from above, one pixel per
post."""
import numpy as np
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from paraview.vtk.vtkIOImage import vtkPNGReader
from PluginTesting import OUTPUT

# Mean difference in codes of 255: half a code by rounding, more at texels where the light changes
# quickly.
CODES = 2.0


def picture(view, name):
    """The pixels of a view as in its screenshot, with the rows from the bottom. The file is kept."""
    path = f"{OUTPUT}/{name}.png"
    simple.Render(view)
    simple.SaveScreenshot(path, view, ImageResolution=list(view.ViewSize))
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)[:, :, :3]


def encode(light):
    """Codes of linear light, 0 to 255."""
    light = np.clip(light, 0.0, 1.0)
    return 255.0 * np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


def make_view(size):
    """A view without decoration; the background has the code 10."""
    view = simple.CreateView("RenderView")
    view.ViewSize = size
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [10 / 255.0] * 3
    return view


def look_down(view, source):
    """Moves the camera so that one pixel shows one post."""
    shape = source.GetDataInformation()
    x0, x1, y0, y1, _, _ = shape.GetBounds()
    c0, c1, r0, r1, _, _ = shape.GetExtent()
    simple.Render(view)  # the first rendering sets the camera
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = [0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.0]
    view.CameraPosition = [0.5 * (x0 + x1), 0.5 * (y0 + y1), 50000.0]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = 0.5 * (r1 - r0 + 1) * (y1 - y0) / (r1 - r0)


def show(light, view):
    """Shows a source as Soft Shadow Surface, white."""
    display = simple.Show(light, view)
    display.SetRepresentationType("Soft Shadow Surface")
    simple.ColorBy(display, None)
    display.DiffuseColor = [1, 1, 1]
    return display


def show_plainly(light, view):
    """The same from above, twice as bright and without a tone curve."""
    display = show(light, view)
    display.SkylineAutoExposure = 0
    display.SkylineExposure = 1.0
    display.SkylineToneMapping = 0
    look_down(view, light)
    return display


def show_transfer(transfer, view):
    """Shows the light of a uniform sky from above, from the harmonics of a source."""
    display = show(transfer, view)
    display.SkylineSunIrradiance = [0, 0, 0]
    display.SkylineSkyRadiance = [0.8, 0.8, 0.8]
    display.SkylineAutoExposure = 0
    display.SkylineToneMapping = 0
    look_down(view, transfer)
    return display


def morning(filters, dem):
    """The light that the tests of the picture use."""
    return filters["Irradiance"](Input=dem, SunAzimuth=120.0, SunElevation=20.0,
        SkyRadiance=[0.1, 0.13, 0.2], Azimuths=16)
