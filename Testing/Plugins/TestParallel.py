# SPDX-License-Identifier: BSD-3-Clause
"""Two processes compute the parts of the result of one process, or refuse. There are no seams."""
import numpy as np
from paraview import servermanager, simple
from PluginTesting import OUTPUT, TIME, expect, fetch, filters, main, read_dem
from paraview.vtk.util.numpy_support import vtk_to_numpy

LAMP = [562800.0, 5116400.0, 3000.0, 200.0, 4.0, 3.0, 2.0]
module = servermanager.vtkProcessModule.GetProcessModule()
RANK = module.GetPartitionId()
SERIAL = np.load(OUTPUT + "/serial.npz")


def expect_piece(proxy, name, serial):
    """The part of the array on this process must equal that of the serial run to the bit."""
    image = fetch(proxy)
    c0, c1, r0, r1, _, _ = image.GetExtent()
    label = f"{proxy.GetXMLLabel()} on process {RANK}"
    array = image.GetPointData().GetArray(name)
    expect(array is not None, f"{label} has {name}")
    if array is None:
        return
    columns, rows = 327, 468
    expect(0 < image.GetNumberOfPoints() < columns * rows, f"{label} has a piece")
    wanted = serial.reshape(rows, columns, -1)[r0 : r1 + 1, c0 : c1 + 1]
    found = vtk_to_numpy(array).reshape(r1 - r0 + 1, c1 - c0 + 1, -1)
    expect(np.array_equal(found, wanted, equal_nan=True), f"{label}: {name} is not the serial one")


def test_pieces():
    """Each process has its piece of the serial result"""
    dem = read_dem()
    expect_piece(filters["Horizon"](Input=dem, Azimuths=8), "HorizonElevation", SERIAL["Horizon"])
    expect_piece(filters["SkyView"](Input=dem, Azimuths=16), "SkyViewFactor", SERIAL["SkyView"])
    expect_piece(
        filters["SunShadow"](Input=dem, UseTime=1, Time="2026-06-21T12:00Z", HoursLater=2.0),
        "SunVisibility", SERIAL["SunShadow"])
    expect_piece(filters["Irradiance"](Input=dem, Sun="None", Sky="None", Lamps=LAMP), "Irradiance",
        SERIAL["Irradiance"])
    expect_piece(filters["TransferHarmonics"](Input=dem), "TransferSH", SERIAL["TransferHarmonics"])
    expect_piece(filters["ShadowHeight"](Input=dem, SunAzimuth=100.0, SunElevation=12.0, Soft=1),
        "ShadowHeight", SERIAL["ShadowHeight"])
    expect_piece(filters["ShadedMap"](Input=dem, ColorMap="viridis", SunElevation=30.0), "Picture",
        SERIAL["ShadedMap"])


def test_surface():
    """The surface is made once"""
    surface = filters["HeightFieldSurface"](Input=read_dem(), Skirt=0)
    cells = fetch(surface).GetNumberOfCells()
    wanted = SERIAL["Triangles"] if RANK == 0 else 0
    expect(cells == wanted, f"{cells} triangles on process {RANK}, not {wanted}")


def test_refusal():
    """An image that no process can have whole is refused"""
    # Each process only makes its own part of this image, whatever part is requested.
    source = simple.ProgrammableSource(OutputDataSetType="vtkImageData")
    source.ScriptRequestInformation = """
from paraview.util import SetOutputWholeExtent
SetOutputWholeExtent(self, [0, 9, 0, 9, 0, 0])
"""
    source.Script = """
from paraview import servermanager
from paraview.vtk import vtkFloatArray
rank = servermanager.vtkProcessModule.GetProcessModule().GetPartitionId()
output.SetExtent(0, 9, 5 * rank, 5 + 4 * rank, 0, 0)
heights = vtkFloatArray()
heights.SetName("Elevation")
heights.SetNumberOfTuples(output.GetNumberOfPoints())
heights.Fill(1.0)
output.PointData.SetScalars(heights)
"""
    horizon = filters["Horizon"](Input=source, Azimuths=4)
    image = fetch(horizon)
    expect(image.GetNumberOfPoints() == 0, f"refused, not {image.GetNumberOfPoints()} posts")


main(test_pieces, test_surface, test_refusal)
