# SPDX-License-Identifier: BSD-3-Clause
"""Code that the tests of the ParaView plugin share. pvbatch runs each of them as
`pvbatch TestX.py PLUGIN DATA OUTPUT PROGRAM`: the plugin, Testing/Data, a folder for output, and
the program skyline, with whose results the filters are compared.
"""
import os
import subprocess
import sys
import traceback

import numpy as np
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

PLUGIN, DATA, OUTPUT, PROGRAM = sys.argv[1:5]
DEM = DATA + "/dem/SainteHelens.tif"
TIME = "2026-06-21T14:00Z"

filters = {"": None}  # LoadPlugin does not fill an empty dictionary
simple.LoadPlugin(PLUGIN, remote=False, ns=filters)

checks = {"failed": 0, "done": 0}


def expect(fine, what):
    """Counts a check, and prints its text if it failed."""
    checks["done"] += 1
    if not fine:
        checks["failed"] += 1
        print("FAILED:", what, flush=True)


def expect_close(found, wanted, tolerance, what):
    """Both must have the same shape and missing posts, and differ by at most the tolerance."""
    found, wanted = np.asarray(found, dtype=float), np.asarray(wanted, dtype=float)
    if found.shape != wanted.shape:
        expect(False, f"{what}: {found.shape} values, not {wanted.shape}")
        return
    known = np.isfinite(wanted)
    expect(np.array_equal(np.isfinite(found), known), f"{what}: other posts are missing")
    worst = np.abs(np.where(known, found - wanted, 0.0)).max()
    print(f"{what}: greatest difference {worst:.3g}", flush=True)
    expect(worst <= tolerance, f"{what}: off by {worst}, more than {tolerance}")


def read_dem():
    """The reader of the included DEM, updated."""
    reader = filters["HeightFieldReader"](FileName=DEM)
    reader.UpdatePipeline()
    return reader


def fetch(proxy):
    """The output of a proxy on this process. (After servermanager.Fetch no window would open.)"""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def points(proxy, name):
    """A point array of a proxy's output, one row per point."""
    array = fetch(proxy).GetPointData().GetArray(name)
    if array is None:
        raise AssertionError(f"{proxy.GetXMLLabel()} made no {name}")
    return vtk_to_numpy(array)


def program(*arguments):
    """The bands of the raster that the program writes: posts in VTK's order x bands."""
    from osgeo import gdal

    gdal.UseExceptions()
    path = f"{OUTPUT}/program.tif"
    subprocess.run([PROGRAM, arguments[0], DEM, "-o", path, "--quiet", *arguments[1:]], check=True)
    raster = gdal.Open(path)
    bands = np.atleast_3d(raster.ReadAsArray().reshape(-1, raster.RasterYSize, raster.RasterXSize))
    values = bands[:, ::-1].reshape(len(bands), -1).T.astype(float)
    nodata = raster.GetRasterBand(1).GetNoDataValue()
    if nodata is not None:
        values[values == nodata] = np.nan
    return values


def main(*tests):
    """Runs all tests. The process fails if a check failed."""
    for test in tests:
        print("--", test.__doc__, flush=True)
        try:
            test()
        except Exception:
            checks["failed"] += 1
            traceback.print_exc()
    print(f"{checks['done']} checks, {checks['failed']} failed", flush=True)
    sys.stdout.flush()
    if checks["failed"]:
        os._exit(1)  # sys.exit would close ParaView's windows and processes in the wrong order
