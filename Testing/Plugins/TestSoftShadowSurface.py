# SPDX-License-Identifier: BSD-3-Clause
"""The representation Soft Shadow Surface: compares its picture from above with the formula; tests pictures
in perspective and a state file."""
import numpy as np
from paraview import servermanager, simple
from PluginTesting import OUTPUT, TIME, expect, fetch, filters, main, points, read_dem
from SurfaceTesting import (
    CODES, encode, make_view, morning, picture, show, show_plainly, show_transfer)


def test_irradiance():
    """Irradiance, from above, is what the array says"""
    light = morning(filters, read_dem())
    irradiance = points(light, "Irradiance")
    image = fetch(light)
    columns, rows, _ = image.GetDimensions()
    view = make_view([columns, rows])
    display = show_plainly(light, view)
    found = picture(view, "irradiance-above")
    wanted = encode(2.0 * irradiance / np.pi).reshape(rows, columns, 3)
    np.savez_compressed(OUTPUT + "/above.npz", codes=found)  # for other tests
    inside = (slice(2, -2), slice(2, -2))
    error = np.nanmean(np.abs(found[inside].astype(float) - wanted[inside]))
    print(f"mean difference {error:.2f} codes")
    expect(error < CODES, f"the picture is off by {error} codes on average")

    display.SkylineAutoExposure = 1
    display.SkylineExposure = 0.0
    display.SkylineToneMapping = 1
    bright = np.percentile(picture(view, "irradiance-exposed")[inside], 98)
    expect(150 < bright < 250, f"the exposed picture's bright parts have code {bright}")
    simple.Delete(view)


def test_harmonics():
    """Transfer from above is the dot product; the sun moves without the filter"""
    transfer = filters["TransferHarmonics"](Input=read_dem())
    image = fetch(transfer)
    columns, rows, _ = image.GetDimensions()
    coefficients = points(transfer, "TransferSH")
    view = make_view([columns, rows])
    display = show_transfer(transfer, view)
    expect(display.SkylineLight == "Automatic", "without a word the light is what there is")
    found = picture(view, "transfer-sky")
    np.savez_compressed(OUTPUT + "/transfer.npz", codes=found)  # for the test of several processes
    found = found[2:-2, 2:-2]
    sky = 0.8 * coefficients[:, 0] * np.sqrt(4.0 * np.pi) / np.pi
    wanted = encode(sky).reshape(rows, columns)[2:-2, 2:-2]
    error = np.nanmean(np.abs(found[:, :, 0].astype(float) - wanted))
    print(f"mean difference {error:.2f} codes")
    expect(error < CODES, f"the sky is off by {error} codes on average")

    display.SkylineSunIrradiance = [3, 3, 3]
    display.SkylineAutoExposure = 1
    time = transfer.GetClientSideObject().GetOutputDataObject(0).GetUpdateTime()
    east = [picture(view, f"transfer-sun-{azimuth}") for azimuth in (90, 270)
            if not setattr(display, "SkylineSunAzimuth", azimuth)]
    expect(np.abs(east[0].astype(float) - east[1]).mean() > 10.0, "the sun moves")
    again = transfer.GetClientSideObject().GetOutputDataObject(0).GetUpdateTime()
    expect(time == again, "a moved sun takes no new transfer")
    visibility = filters["VisibilityHarmonics"](Input=transfer.Input)
    simple.Hide(transfer, view)
    display = show(visibility, view)
    by_itself = picture(view, "visibility-automatic")[2:-2, 2:-2]
    display.SkylineLight = "Visibility (harmonics)"
    seen = picture(view, "visibility")[2:-2, 2:-2]
    expect(seen.std() > 10.0, "visibility is lit")
    expect(np.array_equal(seen, by_itself), "the automatic light is the array's")
    simple.Delete(view)


def test_view():
    """In perspective, with colours of heights; the state brings the same picture back"""
    shadow = filters["Irradiance"](Input=read_dem(), Sun="Time", SunTime=TIME,
        SunIrradiance=[3.0, 2.7, 2.2], SkyRadiance=[0.12, 0.16, 0.24], Azimuths=32)
    simple.RenameSource("light", shadow)
    view = make_view([640, 420])
    display = show(shadow, view)
    display.SkylineExaggeration = 1.5
    simple.ColorBy(display, ("POINTS", "Elevation"))
    simple.ResetCamera(view)
    camera = view.GetActiveCamera()
    camera.Elevation(-55)
    camera.Zoom(1.5)
    first = picture(view, "perspective")
    share = (np.abs(first.astype(int) - 10) > 8).any(axis=2).mean()
    expect(0.2 < share < 0.95, f"the terrain fills {share} of the picture")
    path = OUTPUT + "/view.pvsm"
    servermanager.SaveState(path)
    simple.ResetSession()
    simple.LoadState(path)
    view = simple.GetActiveViewOrCreate("RenderView")
    second = picture(view, "perspective-from-state")
    expect(first.shape == second.shape and
        np.abs(first.astype(float) - second).mean() < 0.5, "the state shows the same picture")


def test_missing_light():
    """Without the array nothing is drawn, and ParaView says why"""
    view = make_view([100, 100])
    dem = read_dem()
    show(dem, view)
    simple.ResetCamera(view)
    expect(np.ptp(picture(view, "no-light")) == 0, "nothing is drawn")
    simple.Delete(view)


main(test_irradiance, test_harmonics, test_missing_light, test_view)
