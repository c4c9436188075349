# SPDX-License-Identifier: BSD-3-Clause
"""All filters of the plugin on a real DEM, compared with the program skyline and with closed forms."""
import os

import numpy as np
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from PluginTesting import (
    DATA, DEM, OUTPUT, TIME, expect, expect_close, fetch, filters, main, points, program, read_dem)

# The same code, compiled with another VTK. The values of the program are stored as float32.
SAME_CODE = 2e-5

Y00 = 0.28209479177387814
LAMP = [562800.0, 5116400.0, 3000.0, 200.0, 4.0, 3.0, 2.0]
SERIAL = {}  # results that a parallel run must reproduce


def lamp_arguments(image):
    """The position of the lamp in the coordinates of the CRS, which are those of the image, as the program
    expects it."""
    return "--lamp", ",".join(str(number) for number in LAMP)


def posts_under(surface, dem):
    """The numbers of the posts at which the points of a surface are."""
    image = fetch(dem)
    places = vtk_to_numpy(fetch(surface).GetPoints().GetData())[:, :2]
    steps = (places - np.array(image.GetOrigin()[:2])) / np.array(image.GetSpacing()[:2])
    return np.rint(steps[:, 1]).astype(int) * image.GetDimensions()[0] + np.rint(
        steps[:, 0]).astype(int)


def test_horizon():
    """Horizon"""
    # In a script the reader may not have been updated yet.
    horizon = filters["Horizon"](Input=filters["HeightFieldReader"](FileName=DEM), Azimuths=8)
    SERIAL["Horizon"] = points(horizon, "HorizonElevation")
    expect_close(SERIAL["Horizon"], program("horizon", "--azimuths", "8"), SAME_CODE, "horizon")


def test_sky_view():
    """Sky View"""
    view = filters["SkyView"](Input=read_dem(), Azimuths=16)
    wanted = program("sky-view", "--azimuths", "16")
    names = ("SkyViewFactor", "SkyViewFactorHorizontal", "VisibleSkyFraction", "PositiveOpenness")
    for band, name in enumerate(names):
        expect_close(points(view, name), wanted[:, band], SAME_CODE, name)
    SERIAL["SkyView"] = points(view, "SkyViewFactor")


def test_sky_light():
    """Sky Light: under the uniform sky it is the sky view factor"""
    light = filters["SkyLight"](Input=read_dem(), Azimuths=16, Sky="CIE 5, uniform")
    expect_close(points(light, "SkyLight"), SERIAL["SkyView"], 1e-4, "uniform sky light")


def test_sun_shadow():
    """Sun Shadow, by direction and by time, two hours later"""
    dem = read_dem()
    shadow = filters["SunShadow"](Input=dem, SunAzimuth=100.0, SunElevation=12.0)
    expect_close(points(shadow, "SunVisibility"), program("sun", "--sun", "100,12")[:, 0],
        SAME_CODE, "sun by direction")
    shadow = filters["SunShadow"](Input=dem, UseTime=1, Time="2026-06-21T12:00Z", HoursLater=2.0)
    SERIAL["SunShadow"] = points(shadow, "SunVisibility")
    expect_close(SERIAL["SunShadow"], program("sun", "--time", TIME)[:, 0], SAME_CODE,
        "sun by time")
    height = filters["ShadowHeight"](Input=dem, UseTime=1, Time="2026-06-21T12:00Z", HoursLater=2.0)
    later = filters["ShadowHeight"](Input=dem, UseTime=1, Time=TIME)
    expect_close(points(height, "ShadowHeight"), points(later, "ShadowHeight"), 1e-3,
        "shadow height by time")
    lit = np.nanmean(SERIAL["SunShadow"])
    expect(0.5 < lit < 1.0, f"a morning sun lights {lit} of the posts")


def test_irradiance():
    """Irradiance: sun by time, skies, an HDR file, lamps"""
    dem = read_dem()
    make = filters["Irradiance"]
    scale = 1000.0  # W/m2: float32 values of some hundreds
    perez = make(Input=dem, Sun="Time", SunTime=TIME, Sky="Perez", DirectIrradiance=700.0,
        DiffuseIrradiance=120.0, SkyRadiance=[1, 1, 1], SunIrradiance=[700, 700, 700])
    expect_close(points(perez, "Irradiance"),
        program("irradiance", "--environment", "perez:700,120", "--time", TIME), scale * SAME_CODE,
        "Perez sky and its sun")

    hdr = DATA + "/light-maps/sky_128.hdr"
    lit = make(Input=dem, Sun="None", Sky="Light map (file)", EnvironmentFile=hdr, Rotation=40.0,
        SkyRadiance=[1, 1, 1], LightMethod="Harmonics (preview)")
    wanted = program("irradiance", "--environment", hdr, "--rotation", "40", "--method", "sh")
    most = np.nanmax(wanted)
    expect_close(points(lit, "Irradiance") / most, wanted / most, SAME_CODE, "light map")

    night = make(Input=dem, Sun="None", Sky="None", Lamps=LAMP)
    SERIAL["Irradiance"] = points(night, "Irradiance")
    expect_close(SERIAL["Irradiance"], program("irradiance", *lamp_arguments(dem)), SAME_CODE,
        "a lamp")
    expect(np.nanmax(SERIAL["Irradiance"]) > 0.0, "the lamp lights nothing")
    night.Lamps = LAMP + LAMP
    expect_close(points(night, "Irradiance"), 2.0 * SERIAL["Irradiance"], 10 * SAME_CODE,
        "two lamps")


def test_harmonics():
    """Visibility and Transfer: their first coefficients are the sky's solid angle and its view factor"""
    dem = read_dem()
    view = filters["SkyView"](Input=dem, Azimuths=32)
    visibility = points(filters["VisibilityHarmonics"](Input=dem), "VisibilitySH")
    transfer = points(filters["TransferHarmonics"](Input=dem), "TransferSH")
    expect(visibility.shape[1] == 16 and transfer.shape[1] == 16, "4 bands are 16 coefficients")
    expect_close(visibility[:, 0] / (2.0 * np.pi * Y00), points(view, "VisibleSkyFraction"), 1e-4,
        "visibility")
    # The sky view factor is integrated relative to the tilted plane; the transfer has its own
    # quadrature.
    expect_close(transfer[:, 0] / (np.pi * Y00), points(view, "SkyViewFactor"), 2e-3, "transfer")
    SERIAL["TransferHarmonics"] = transfer


def test_shadow_height():
    """Shadow Height, and Shadow Receiver on points in and over the shadow"""
    dem = read_dem()
    heights = filters["ShadowHeight"](Input=dem, SunAzimuth=100.0, SunElevation=12.0, Soft=1)
    wanted = program("shadow-height", "--sun", "100,12", "--soft")
    for band, name in enumerate(("ShadowHeight", "ShadowHeightUpper", "ShadowHeightLower")):
        expect_close(points(heights, name), wanted[:, band], 1e-2, name)  # metres
    SERIAL["ShadowHeight"] = points(heights, "ShadowHeight")

    surface = filters["HeightFieldSurface"](Input=dem)
    receiver = filters["ShadowReceiver"](Input=surface, ShadowHeights=heights)
    found = points(receiver, "SunVisibility")
    sun = points(filters["SunShadow"](Input=dem, SunAzimuth=100.0, SunElevation=12.0),
        "SunVisibility")
    posts = posts_under(surface, dem)
    deep = SERIAL["ShadowHeight"][posts] > points(dem, "Elevation")[posts] + 30.0
    expect(deep.any() and found[deep].max() < 0.05, "posts deep in shadow are dark")
    mean = np.abs(found - sun[posts]).mean()
    expect(mean < 0.02, f"on the ground the receiver differs from the sun shadow by {mean}")


def test_cap_and_surface():
    """Cap Height Field and Height Field Surface"""
    dem = read_dem()
    image = fetch(dem)
    columns, rows, _ = image.GetDimensions()
    x0, x1, y0, y1, _, _ = image.GetBounds()
    house = simple.Box(Center=[0.5 * (x0 + x1), 0.5 * (y0 + y1), 1000.0], XLength=500.0,
        YLength=700.0, ZLength=6000.0)
    capped = points(filters["CapHeightField"](Input=dem, Objects=house), "Elevation")
    ground = points(dem, "Elevation")
    raised = capped > ground + 1.0
    step = image.GetSpacing()
    wanted = (500.0 / step[0]) * (700.0 / step[1])
    expect(abs(raised.sum() - wanted) < 0.2 * wanted, f"{raised.sum()} posts of a house, not {wanted}")
    expect_close(capped[raised], np.full(raised.sum(), 4000.0), 0.01, "the roof")
    SERIAL["CapHeightField"] = capped

    surface = fetch(filters["HeightFieldSurface"](Input=dem))
    known = np.isfinite(ground).reshape(rows, columns)
    cells = (known[1:, 1:] & known[1:, :-1] & known[:-1, 1:] & known[:-1, :-1]).sum()
    expect(surface.GetNumberOfCells() == 2 * cells, "two triangles a cell without missing posts")
    SERIAL["Triangles"] = 2 * cells


def test_shading():
    """Shaded Map"""
    picture = filters["ShadedMap"](Input=read_dem(), ColorMap="viridis", SunElevation=30.0)
    pixels = points(picture, "Picture")
    expect(pixels.shape[1] == 4 and 20.0 < pixels[:, :3].mean() < 235.0, "a picture of some light")
    SERIAL["ShadedMap"] = pixels


def test_state():
    """A state file brings back the same numbers"""
    dem = read_dem()
    light = filters["Irradiance"](Input=dem, Sun="Time", SunTime=TIME, HoursLater=1.0, Sky="CIE",
        CIESky=3, Lamps=LAMP + [562000.0, 5117000.0, 2500.0, 50.0, 1.0, 2.0, 3.0], Azimuths=8)
    simple.RenameSource("light", light)
    wanted = points(light, "Irradiance").copy()
    path = OUTPUT + "/light.pvsm"
    servermanager.SaveState(path)
    for source in list(simple.GetSources().values()):
        simple.Delete(source)
    expect(not simple.GetSources(), "no source is left")
    servermanager.LoadState(path)
    found = simple.FindSource("light")
    expect(found is not None and list(found.Lamps)[:7] == LAMP, "the lamps are as they were")
    expect_close(points(found, "Irradiance"), wanted, 0.0, "irradiance from the state")


def keep_serial():
    """Results for the parallel test"""
    np.savez(OUTPUT + "/serial.npz", **SERIAL)
    expect(os.path.getsize(OUTPUT + "/serial.npz") > 0, "results are kept")


main(test_horizon, test_sky_view, test_sky_light, test_sun_shadow, test_irradiance, test_harmonics,
     test_shadow_height, test_cap_and_surface, test_shading, keep_serial, test_state)
