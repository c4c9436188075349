# SPDX-License-Identifier: BSD-3-Clause
"""Input that cannot be computed is refused with a message that gives the reason, without a crash."""
import numpy as np
from paraview import simple
from paraview.vtk import vtkStringOutputWindow, vtkOutputWindow
from PluginTesting import DATA, expect, fetch, filters, main, points, read_dem

IMAGE = """
from paraview.vtk import vtkFloatArray
output.SetDimensions({dimensions})
output.SetSpacing({spacing})
heights = vtkFloatArray()
heights.SetName("Elevation")
heights.SetNumberOfTuples(output.GetNumberOfPoints())
for post in range(output.GetNumberOfPoints()):
    heights.SetValue(post, {value})
output.GetPointData().SetScalars(heights)
"""


def image(dimensions="6, 5, 1", spacing="10, 10, 10", value="post % 7"):
    """A height field without a georeference."""
    whole = [int(number) - 1 for number in dimensions.split(",")]
    source = simple.ProgrammableSource(OutputDataSetType="vtkImageData")
    source.ScriptRequestInformation = (
        "from paraview.util import SetOutputWholeExtent\n"
        f"SetOutputWholeExtent(self, [0, {whole[0]}, 0, {whole[1]}, 0, {whole[2]}])\n")
    source.Script = IMAGE.format(dimensions=dimensions, spacing=spacing, value=value)
    return source


def message_of(proxy):
    """The text of the output window when the proxy runs. The output of the proxy must be empty."""
    window, usual = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    try:
        result = fetch(proxy)
    finally:
        vtkOutputWindow.SetInstance(usual)
    label = proxy.GetXMLLabel()
    expect(result is None or result.GetNumberOfPoints() == 0, f"{label} makes nothing")
    return window.GetOutput()


def expect_error(proxy, *words):
    """The message must contain all of the words."""
    text = message_of(proxy)
    for word in words:
        expect(word in text, f"{proxy.GetXMLLabel()}: no '{word}' in: {text or '(nothing)'}")


def test_data_types():
    """Other data are not offered a filter, and are refused in a script"""
    grid = simple.AppendDatasets(Input=simple.Sphere())  # an unstructured grid
    grid.UpdatePipeline()
    dem = read_dem()
    for name in ("Horizon", "SkyView", "SunShadow", "Irradiance", "ShadedMap"):
        proxy = filters[name](Input=dem)
        wanted = proxy.SMProxy.GetProperty("Input")
        expect(wanted.IsInDomains() == 1, f"{name} takes a height field")
        wanted.RemoveAllProxies()
        wanted.AddInputConnection(grid.SMProxy, 0)
        expect(wanted.IsInDomains() == 0, f"{name} is not for unstructured grids")
    expect_error(filters["Horizon"](Input=grid), "vtkImageData", "vtkUnstructuredGrid")


def test_shapes():
    """A volume, a row, no spacing"""
    expect_error(filters["Horizon"](Input=image(dimensions="4, 4, 3")), "3 slices")
    expect_error(filters["SkyView"](Input=image(dimensions="5, 1, 1")), "5 x 1")
    expect_error(filters["Horizon"](Input=image(spacing="0, 10, 10")), "spacing", "0")
    expect_error(filters["Horizon"](Input=image(spacing="float('nan'), 10, 10")), "spacing", "nan")


def test_heights():
    """Missing posts stay missing; no array of that name"""
    holes = filters["Horizon"](
        Input=image(value="float('nan') if post in (7, 8) else post % 7"), Azimuths=4)
    missing = np.isnan(points(holes, "HorizonElevation")).all(axis=1)
    expect(list(np.flatnonzero(missing)) == [7, 8], "two posts are missing")
    expect_error(filters["SkyView"](Input=image(value="float('nan')")), "every post is missing")
    other = filters["SunShadow"](Input=image())
    other.Heights = ["POINTS", "nothing"]
    expect_error(other, "no heights")


def test_times():
    """A text that is no time, a time out of range, no place on the Earth"""
    dem = read_dem()
    expect_error(filters["SunShadow"](Input=dem, UseTime=1, Time="21 June"), "21 June", "2026-06-21T")
    expect_error(filters["Irradiance"](Input=dem, Sun="Time", SunTime="2026-02-30"), "2026-02-30")
    expect_error(filters["Irradiance"](Input=dem, Sun="Time", SunTime=""), "no time", "2026-06-21T")
    expect_error(filters["SunShadow"](Input=dem, UseTime=1, Time="2026-06-21T14:00Z",
        HoursLater=1e9), "hours")
    expect_error(filters["ShadedMap"](Input=dem, UseTime=1, Time="3026-06-21T14:00Z"), "3026")
    expect_error(filters["SunShadow"](Input=image(), UseTime=1), "coordinate reference system")


def test_lights():
    """Light maps that are not there, lamps that cannot be"""
    dem = read_dem()
    make = filters["Irradiance"]
    expect_error(make(Input=dem, Sky="Light map (file)"), "Environment File")
    expect_error(make(Input=dem, Sky="Light map (file)", EnvironmentFile="/none/sky.hdr"),
        "/none/sky.hdr")
    expect_error(make(Input=dem, Sky="Light map (file)",
        EnvironmentFile=DATA + "/dem/SainteHelens.tif"), "SainteHelens.tif")
    expect_error(make(Input=dem, Lamps=[0, 0, 0, -1, 1, 1, 1]), "radius", "-1")
    expect_error(make(Input=dem, Lamps=[0, 0, 0, 1, -2, 1, 1]), "-2")
    expect_error(make(Input=dem, Sun="None", Sky="None"), "light")


def test_files():
    """Files that are not there or no rasters; a band too many"""
    expect_error(filters["HeightFieldReader"](FileName="/none/dem.tif"), "/none/dem.tif")
    expect_error(filters["HeightFieldReader"](FileName=__file__), "TestBadInput.py")
    expect_error(filters["HeightFieldReader"](
        FileName=DATA + "/dem/SainteHelens.tif", Band=7), "7", "SainteHelens.tif")
    expect_error(filters["LightMapReader"](FileName="/none/sky.exr"), "/none/sky.exr")


main(test_data_types, test_shapes, test_heights, test_times, test_lights, test_files)
