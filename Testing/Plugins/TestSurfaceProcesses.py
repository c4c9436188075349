# SPDX-License-Identifier: BSD-3-Clause
"""Soft Shadow Surface with two processes gives the picture of one process: no seam, and no part drawn
twice."""
import numpy as np
from paraview import simple
from PluginTesting import OUTPUT, expect, filters, main, read_dem
from SurfaceTesting import make_view, morning, picture, show_plainly, show_transfer

SERIAL = {name: np.load(f"{OUTPUT}/{name}.npz")["codes"] for name in ("above", "transfer")}


def expect_serial(view, name):
    """The picture must be the serial one, whether the pictures of the processes or their triangles are
    combined."""
    for threshold, way in ((0.0, "composited"), (1e9, "collected")):
        view.RemoteRenderThreshold = threshold
        worst = np.abs(picture(view, f"{name}-{way}").astype(int) - SERIAL[name]).max()
        print(f"{name} {way}: greatest difference {worst} codes", flush=True)
        expect(worst <= 1, f"{name} {way}: another picture")


def new_view():
    rows, columns, _ = SERIAL["above"].shape
    return make_view([columns, rows])


def test_irradiance():
    """Irradiance from above is the serial picture"""
    view = new_view()
    show_plainly(morning(filters, read_dem()), view)
    expect_serial(view, "above")
    simple.Delete(view)


def test_harmonics():
    """Transfer from above is the serial picture"""
    view = new_view()
    show_transfer(filters["TransferHarmonics"](Input=read_dem()), view)
    expect_serial(view, "transfer")
    simple.Delete(view)


main(test_irradiance, test_harmonics)
