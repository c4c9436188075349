# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's objects as input, and pyvista.wrap of the results. Skipped if PyVista is not installed."""

import sys
import unittest

import numpy as np
import skyline

try:
    import pyvista
except ImportError as reason:
    print(f"skipped: {reason}")
    sys.exit(77)


def hills(rows=40, columns=50):
    y, x = np.mgrid[0:rows, 0:columns]
    return 200.0 + 80.0 * np.sin(0.21 * x + 0.13 * y) + 50.0 * np.cos(0.17 * y - 0.05 * x)


def grid_of(z, spacing):
    """An image as users of PyVista make it, with the northern edge of z in row 0."""
    grid = pyvista.ImageData(dimensions=(z.shape[1], z.shape[0], 1), spacing=(spacing, spacing, 1.0))
    grid["height"] = z[::-1].ravel()
    return grid


class PyVista(unittest.TestCase):
    def setUp(self):
        self.z = hills()
        self.grid = grid_of(self.z, 10.0)

    def test_in_and_out(self):
        wanted = skyline.horizon(self.z, 10.0, 8)
        result = skyline.horizon(self.grid, azimuths=8)
        self.assertTrue(np.array_equal(skyline.to_array(result, "HorizonElevation"), wanted))
        wrapped = pyvista.wrap(result)
        self.assertIsInstance(wrapped, pyvista.ImageData)
        self.assertEqual(wrapped.array_names, ["height", "HorizonElevation"])
        self.assertTrue(np.array_equal(wrapped["HorizonElevation"], wanted[::-1].reshape(-1, 8)))
        self.assertTrue(np.array_equal(wrapped["height"], self.grid["height"]))
        self.assertEqual(self.grid.array_names, ["height"], "the input stays as it was")

    def test_every_function_and_one_after_the_other(self):
        sun = (30.0, 12.0)
        lit = pyvista.wrap(skyline.sun_visibility(self.grid, sun=sun))
        sky = pyvista.wrap(skyline.sky_view(lit, azimuths=8, scalars="height"))
        light = pyvista.wrap(skyline.irradiance(sky, sun=sun, azimuths=8, scalars="height"))
        shade = pyvista.wrap(skyline.shadow_height(light, sun=sun, scalars="height"))
        for name, wanted in [("SunVisibility", skyline.sun_visibility(self.z, 10.0, sun)),
                             ("SkyViewFactor", skyline.sky_view(self.z, 10.0, 8)),
                             ("Irradiance", skyline.irradiance(self.z, 10.0, sun=sun, azimuths=8)),
                             ("ShadowHeight", skyline.shadow_height(self.z, 10.0, sun=sun))]:
            self.assertTrue(np.array_equal(skyline.to_array(shade, name), wanted), name)

    def test_memory_is_shared(self):
        image = skyline.to_image(self.z, 10.0)
        wrapped = pyvista.wrap(image)
        self.assertTrue(np.shares_memory(np.asarray(wrapped["Elevation"]), skyline.to_array(image)))
        self.assertTrue(np.shares_memory(skyline.to_array(wrapped), np.asarray(wrapped["Elevation"])))
        sky = skyline.sky_view(self.grid, azimuths=8)
        self.assertTrue(np.shares_memory(
            np.asarray(pyvista.wrap(sky)["SkyViewFactor"]), skyline.to_array(sky, "SkyViewFactor")))

    def test_the_classes(self):
        surface = skyline.vtkHeightFieldSurface()
        surface.SetInputData(self.grid)
        skyline.update(surface)
        mesh = pyvista.wrap(surface.GetOutput())
        self.assertEqual((mesh.n_points, mesh.n_cells), (2000, 2 * 39 * 49))
        self.assertAlmostEqual(mesh.bounds[5], self.z.max(), places=3)

    def test_errors(self):
        with self.assertRaisesRegex(TypeError, "spacing is given"):
            skyline.sky_view(self.grid, 10.0)
        with self.assertRaisesRegex(ValueError, "no point array 'depth'; .*'height'"):
            skyline.sky_view(self.grid, scalars="depth")
        block = pyvista.ImageData(dimensions=(5, 5, 5))
        block["height"] = np.zeros(125)
        with self.assertRaisesRegex(skyline.Error, "5 slices"):
            skyline.sky_view(block)
        with self.assertRaisesRegex(ValueError, "no active point scalars"):
            skyline.sky_view(pyvista.ImageData(dimensions=(5, 5, 1)))


if __name__ == "__main__":
    unittest.main()
