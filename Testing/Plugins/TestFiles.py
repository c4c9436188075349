# SPDX-License-Identifier: BSD-3-Clause
"""Files that ParaView saves and opens: GeoTIFF and OpenEXR by Save Data, light maps by Open."""
import os

import numpy as np
from paraview import simple
from PluginTesting import DATA, DEM, OUTPUT, expect, expect_close, fetch, filters, main, points, read_dem


def test_raster():
    """Arrays in a GeoTIFF come back, with the place on the Earth"""
    view = filters["SkyView"](Input=read_dem(), Azimuths=8)
    path = OUTPUT + "/saved.tif"
    # ParaView's own TIFF writer has the same extension. In its window the user selects one, here
    # the constructor does.
    writer = filters["HeightFieldWriter"](Input=view, FileName=path)
    writer.Arrays = ["SkyViewFactor", "Elevation"]
    writer.UpdatePipeline()
    again = filters["HeightFieldReader"](FileName=path)
    expect_close(points(again, "Elevation"), points(view, "SkyViewFactor"), 0.0, "band 1")
    again.Band = 2
    expect_close(points(again, "Elevation"), points(view, "Elevation"), 0.0, "band 2")
    expect(fetch(again).GetOrigin() == fetch(view).GetOrigin(), "the origin is the same")
    sun = filters["SunShadow"](Input=again, UseTime=1, Time="2026-06-21T14:00Z")
    expect(np.nanmax(points(sun, "SunVisibility")) == 1.0, "the sun finds the place")


def test_picture():
    """Linear light in an OpenEXR file, which opens as a picture of light"""
    path = OUTPUT + "/saved.exr"
    lit = filters["ShadedMap"](Input=read_dem())
    simple.SaveData(path, proxy=lit)
    expect(os.path.getsize(path) > 100000, "a picture is there")
    writer = filters["MapPictureWriter"](Input=lit, FileName=OUTPUT + "/none/saved.exr")
    writer.UpdatePipeline()
    expect(not os.path.exists(OUTPUT + "/none"), "nothing is written to a folder that is not there")


def test_light_map():
    """A light map to look at"""
    sky = filters["LightMapReader"](FileName=DATA + "/light-maps/sky_128.hdr")
    radiance = points(sky, "Radiance")
    expect(radiance.shape[1] == 3 and (radiance >= 0.0).all(), "light is RGB")
    bounds = fetch(sky).GetBounds()
    expect(bounds[0] > -180.0 and bounds[1] < 180.0 and bounds[3] < 90.0, "the map is all around")


main(test_raster, test_picture, test_light_map)
