# SPDX-License-Identifier: BSD-3-Clause
"""The functions that take and return arrays: orientation, georeference, missing posts, memory, images.

Run as `python3 TestFunctions.py DATA PROGRAM`: Testing/Data, and the program skyline.
"""

import datetime
import math
import os
import subprocess
import sys
import tempfile
import unittest
import warnings

import numpy as np
import skyline
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

FLOAT = 1e-4  # degrees or fractions: closed forms in floats
SUN = 0.006  # degrees: refraction at the height of the middle post, and at the middle of all heights
UTM = "EPSG:26710"


def hills(rows=40, columns=50):
    y, x = np.mgrid[0:rows, 0:columns]
    return 200.0 + 80.0 * np.sin(0.21 * x + 0.13 * y) + 50.0 * np.cos(0.17 * y - 0.05 * x)


class Wrapped(vtkImageData):
    """An image of a Python class with attributes of its own, like the result of pyvista.wrap."""

    def __init__(self):
        self.note = "mine"


class Orientation(unittest.TestCase):
    def test_north_is_row_0(self):
        z = np.zeros((5, 7))
        z[0] = 10.0  # the wall at the top of the printed array
        seen = skyline.horizon(z, 10.0, azimuths=4)
        self.assertEqual(seen.shape, (5, 7, 4))
        self.assertEqual(seen.dtype, np.float32)
        self.assertAlmostEqual(seen[1, 3, 0], 45.0, delta=FLOAT)
        self.assertAlmostEqual(seen[4, 3, 0], math.degrees(math.atan(10 / 40)), delta=FLOAT)
        self.assertEqual(seen[2, 3, 2], 0.0)
        self.assertEqual(seen[4, 3, 2], -90.0)

    def test_row0_south_is_the_mirror_image(self):
        z = hills()
        north = skyline.horizon(z, (10.0, 20.0), azimuths=12)
        south = skyline.horizon(z[::-1], (10.0, 20.0), azimuths=12, row0="south")
        self.assertTrue(np.array_equal(north, south[::-1]))

    def test_every_function_keeps_the_order_of_rows(self):
        z = hills()
        sun = (30.0, 12.0)
        for compute in [
            lambda z, **o: skyline.sky_view(z, 10.0, 16, **o),
            lambda z, **o: skyline.sun_visibility(z, 10.0, sun, **o),
            lambda z, **o: skyline.shadow_height(z, 10.0, sun=sun, **o),
            lambda z, **o: skyline.irradiance(z, 10.0, sun=sun, **o),
        ]:
            north = compute(z)
            south = compute(z[::-1], row0="south")
            self.assertEqual(north.shape[:2], z.shape)
            self.assertTrue(np.array_equal(north, south[::-1]))
            self.assertGreater(np.ptp(north), 0.0)

    def test_dx_counts_between_columns(self):
        z = np.zeros((6, 6))
        z[:, 0] = 10.0
        seen = skyline.horizon(z, (20.0, 1.0), azimuths=4)
        self.assertAlmostEqual(seen[3, 1, 3], math.degrees(math.atan(0.5)), delta=FLOAT)

    def test_azimuths_go_round(self):
        z = hills()
        once = skyline.sun_visibility(z, 10.0, sun=(30.0, 12.0))
        for azimuth in [390.0, -330.0, 30.0 + 360.0 * 2**40]:
            self.assertTrue(np.array_equal(skyline.sun_visibility(z, 10.0, sun=(azimuth, 12.0)), once))

    def test_shadow_falls_away_from_the_sun(self):
        z = np.zeros((30, 5))
        z[15] = 100.0
        lit = skyline.sun_visibility(z, 10.0, sun=(180.0, 45.0), radius=0.0)
        self.assertTrue(np.all(lit[16:] == 1.0), "south of the wall the sun shines")
        self.assertTrue(np.all(lit[6:15] == 0.0), "north of it lies its shadow")


class Numbers(unittest.TestCase):
    def test_types_give_the_same(self):
        z = np.round(hills())
        expected = skyline.sky_view(z, 10.0, 8)
        for kind in "i2 u2 i4 u4 i8 u8 f4 f8 >i2 >f4 >f8 f2".split():
            self.assertTrue(np.array_equal(skyline.sky_view(z.astype(kind), 10.0, 8), expected), kind)
        self.assertTrue(np.array_equal(skyline.sky_view(z.tolist(), 10.0, 8), expected))
        small = (z - 180).clip(0, 100)
        self.assertTrue(np.array_equal(
            skyline.sky_view(small.astype(np.uint8), 10.0, 8), skyline.sky_view(small, 10.0, 8)))

    def test_layouts_give_the_same(self):
        z = hills()
        expected = skyline.sky_view(z, 10.0, 8)
        wide = np.repeat(np.repeat(z, 2, axis=0), 3, axis=1)
        frozen = z.copy()
        frozen.flags.writeable = False
        for other in [wide[::2, ::3], np.asfortranarray(z), z[::-1].copy()[::-1], frozen]:
            self.assertTrue(np.array_equal(skyline.sky_view(other, 10.0, 8), expected))
            self.assertTrue(np.array_equal(
                skyline.sky_view(other[::-1], 10.0, 8, row0="south"), expected[::-1]))

    def test_missing_posts(self):
        z = hills()
        z[10:14, 20:25] = np.nan
        seen = skyline.sky_view(z, 10.0, 8)
        self.assertTrue(np.array_equal(np.isnan(seen), np.isnan(z)))
        filled = np.nan_to_num(z, nan=-9999.0)
        masked = np.ma.masked_equal(filled, -9999.0)
        for other, nodata in [(filled, -9999), (filled.astype("f4"), -9999.0), (masked, None)]:
            found = skyline.sky_view(other, 10.0, 8, nodata=nodata)
            self.assertTrue(np.allclose(found, seen, atol=FLOAT, equal_nan=True))
        whole = np.where(np.isnan(z), -32768, np.nan_to_num(z)).astype(np.int16)
        found = skyline.sky_view(whole, 10.0, 8, nodata=-32768)
        self.assertTrue(np.array_equal(np.isnan(found), np.isnan(z)))
        self.assertEqual(whole[10, 20], -32768, "the caller's array stays")
        lowest = float(np.finfo(np.float32).min)
        found = skyline.sky_view(np.where(np.isnan(z), lowest, z).astype("f4"), 10.0, 8, nodata=-3.4028235e38)
        self.assertTrue(np.array_equal(np.isnan(found), np.isnan(z)))

    def test_a_value_that_looks_like_nodata_warns(self):
        z = hills()
        z[3, 3] = -9999.0
        with self.assertWarnsRegex(UserWarning, "nodata=-9999"):
            skyline.sky_view(z, 10.0, 8)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            skyline.sky_view(z, 10.0, 8, nodata=-9999)
            skyline.sky_view(hills() - 5000.0, 10.0, 8)
        high = hills().astype(np.float32)
        high[3, 3] = np.finfo(np.float32).max
        with self.assertWarnsRegex(UserWarning, r"1 post of the array has the height .*nodata=([^ ]+)") as warned:
            skyline.sky_view(high, 10.0, 8)
        told = float(str(warned.warning).split("nodata=")[1].split()[0])
        self.assertEqual(np.isnan(skyline.sky_view(high, 10.0, 8, nodata=told)).sum(), 1)

    def test_nodata_of_files(self):
        z = hills()
        z[3, 3], z[30, 20] = -9999.0, -32768.0
        with tempfile.TemporaryDirectory() as folder:
            file = folder + "/dem.tif"
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # only making the place checks heights
                skyline.write(file, z, spacing=10.0)
            with self.assertWarnsRegex(UserWarning, "1 post of '.*dem.tif' has the height -9999.*nodata=-9999"):
                skyline.sky_view(file, azimuths=8)
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                seen = skyline.sky_view(file, azimuths=8, nodata=[-9999, -32768.0])
                image = skyline.read(file, nodata=[-9999, -32768.0])
            self.assertEqual(np.isnan(seen).sum(), 2)
            self.assertEqual(np.isnan(skyline.to_array(image)).sum(), 2)
            self.assertTrue(np.array_equal(
                seen, skyline.sky_view(z, 10.0, 8, nodata=[-9999, -32768]), equal_nan=True))
            with self.assertRaisesRegex(TypeError, "nodata is 'x'; give a number, or several"):
                skyline.read(file, nodata="x")
            with self.assertRaisesRegex(TypeError, "nodata is given"):
                skyline.sky_view(image, nodata=-9999)

    def test_degrees_taken_for_metres_warn(self):
        with self.assertWarnsRegex(UserWarning, "looks like degrees.*spacing of 0.000833 metres.*CRS"):
            skyline.sky_view(hills(), 0.000833, 8)
        with self.assertWarnsRegex(UserWarning, "looks like degrees"):
            skyline.to_image(hills(), transform=(7.0, 0.000833, 0.0, 46.0, 0.0, -0.000833))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            skyline.sky_view(hills(), 1.0, 8)
            skyline.sky_view(np.zeros((4, 4)), 1e-6, 8)
            skyline.sky_view(np.array([[9, 250], [3, 4]], np.uint8), 30.0, 8)

    def test_several_quantities_in_one_search(self):
        z = hills()
        views = skyline.sky_view(z, 10.0, 8, ["SkyViewFactor", "PositiveOpenness"])
        self.assertEqual(sorted(views), ["PositiveOpenness", "SkyViewFactor"])
        self.assertTrue(np.array_equal(views["SkyViewFactor"], skyline.sky_view(z, 10.0, 8)))
        self.assertGreater(views["PositiveOpenness"].max(), 45.0)

    def test_methods_surfaces_and_flat(self):
        z = hills()
        exact = skyline.horizon(z, 10.0, 8)
        fast = skyline.horizon(z, 10.0, 8, method="fast")
        self.assertLessEqual(np.abs(exact - fast).max(), 0.25 + FLOAT)
        self.assertFalse(np.array_equal(exact, skyline.horizon(z, 10.0, 8, surface="bilinear")))


class Light(unittest.TestCase):
    LEVEL = np.full((4, 4), 7.0)

    def value(self, *arguments, **options):
        return skyline.irradiance(self.LEVEL, 10.0, *arguments, **options)[2, 2]

    def test_uniform_sky_is_the_default(self):
        self.assertTrue(np.allclose(self.value(), math.pi, rtol=1e-4))
        self.assertTrue(np.array_equal(self.value(), self.value("uniform")))

    def test_sky_of_watts(self):
        # Level ground: the cosine of the sun plus the irradiance of the sky.
        light = self.value("perez:800,100", sun=(180.0, 30.0))
        self.assertTrue(np.allclose(light, 800.0 * 0.5 + 100.0, rtol=1e-3), light)

    def test_sun_and_wide_sun(self):
        for radius in [0.0, 0.26645, 10.0]:
            light = self.value(sun=(20.0, 30.0), sun_irradiance=(2.0, 4.0, 6.0), radius=radius)
            self.assertTrue(np.allclose(light, [1.0, 2.0, 3.0], rtol=4e-3), (radius, light))

    def test_light_map_as_array(self):
        # The upper half of the sky has the radiance 2 in red. Row 0 is the zenith, the centre
        # column is north.
        sky = np.zeros((16, 32, 3))
        sky[:8, :, 0] = 2.0
        self.assertTrue(np.allclose(self.value(sky), [2.0 * math.pi, 0.0, 0.0], rtol=1e-3))
        north = np.zeros((16, 32, 3))
        north[7, 16] = 100.0
        tent = np.abs(np.arange(9.0) - 4.0)[:, None] * np.ones(9) * -5.0  # a ridge from west to east
        light = skyline.irradiance(tent, 10.0, north)[..., 0]
        self.assertGreater(light[2, 4], 10.0 * light[6, 4] + FLOAT, "the north slope is lit")
        turned = skyline.irradiance(tent, 10.0, north, rotation=180.0)[..., 0]
        self.assertGreater(turned[6, 4], 10.0 * turned[2, 4] + FLOAT)

    def test_lamp_counts_from_the_south_west_post(self):
        z = np.zeros((21, 31))
        light = skyline.irradiance(z, 10.0, lamps=[(50.0, 20.0, 30.0, 1.0)])[..., 0]
        row, column = np.unravel_index(np.argmax(light), light.shape)
        self.assertEqual((row, column), (20 - 2, 5))
        # Below a ball: pi sin^2 of its angular radius.
        self.assertAlmostEqual(light[row, column], math.pi / 900.0, delta=1e-5)
        red = skyline.irradiance(z, 10.0, lamps=[(50.0, 20.0, 30.0, 1.0, 2.0, 0.0, 0.0)])
        self.assertAlmostEqual(red[row, column, 0], 2.0 * light[row, column], delta=1e-5)
        self.assertEqual(red[..., 1:].max(), 0.0)

    def test_light_objects(self):
        lamp = skyline.vtkSkylineKeyLight()
        lamp.SetElevation(90.0)
        light = self.value(lights=[lamp])
        self.assertTrue(np.allclose(light, math.pi * math.sin(math.radians(10.0)) ** 2, rtol=4e-3))


class Place(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.dem = os.path.join(DATA, "dem", "SainteHelens.tif")
        cls.image = skyline.read(cls.dem)
        cls.z = skyline.to_array(cls.image)
        cls.transform = cls.image.GetFieldData().GetArray("GeoTransform").GetTuple(0)
        cls.crs = cls.image.GetFieldData().GetAbstractArray("CRS").GetValue(0)
        cls.time = "2026-06-21T14:00Z"

    def test_file_image_and_array_agree(self):
        file = skyline.sun_visibility(self.dem, time=self.time)
        image = skyline.sun_visibility(self.image, time=self.time)
        array = skyline.sun_visibility(self.z, crs=self.crs, transform=self.transform, time=self.time)
        code = skyline.sun_visibility(self.z, crs=26710, transform=self.transform, time=self.time)
        self.assertEqual(file.shape, (468, 327))
        self.assertTrue(np.array_equal(file, skyline.to_array(image, "SunVisibility"), equal_nan=True))
        self.assertTrue(np.array_equal(file, array, equal_nan=True))
        self.assertTrue(np.array_equal(file, code, equal_nan=True))
        self.assertGreater(np.nanmean(file), 0.1)
        self.assertLess(np.nanmean(file), 0.95)

    def test_the_top_of_the_array_is_the_north_of_the_map(self):
        # The crater of the summit opens to the north and lies in the southern part of this map.
        row, column = np.unravel_index(np.nanargmax(self.z), self.z.shape)
        x0, dx, _, y0, _, dy = self.transform
        self.assertLess(dy, 0.0)
        self.assertAlmostEqual(y0 + (row + 0.5) * dy, 5115000.0, delta=1500.0)
        self.assertAlmostEqual(x0 + (column + 0.5) * dx, 562600.0, delta=1500.0)

    def test_transform_of_rasterio(self):
        class Affine(tuple):  # has the attributes of rasterio's class
            a, b, c, d, e, f = (property(lambda self, i=i: self[i]) for i in range(6))

        x0, dx, _, y0, _, dy = self.transform
        affine = Affine((dx, 0.0, x0, 0.0, dy, y0, 0.0, 0.0, 1.0))
        one = skyline.to_image(self.z, crs=UTM, transform=affine)
        two = skyline.to_image(self.z, crs=UTM, transform=self.transform)
        for image in [one, two]:
            self.assertEqual(image.GetOrigin(), self.image.GetOrigin())
            self.assertEqual(image.GetSpacing(), self.image.GetSpacing())
            self.assertEqual(image.GetFieldData().GetArray("GeoTransform").GetTuple(0), self.transform)

    def test_south_up_transform(self):
        x0, dx, _, y0, _, dy = self.transform
        south_up = (x0, dx, 0.0, y0 + len(self.z) * dy, 0.0, -dy)
        image = skyline.to_image(self.z[::-1], crs=UTM, transform=south_up, row0="south")
        self.assertEqual(image.GetFieldData().GetArray("GeoTransform").GetTuple(0), self.transform)
        self.assertTrue(np.array_equal(skyline.to_array(image), self.z, equal_nan=True))
        with self.assertRaisesRegex(ValueError, "row0='south'"):
            skyline.to_image(self.z, crs=UTM, transform=south_up)
        with self.assertRaisesRegex(ValueError, "row0='north'"):
            skyline.to_image(self.z, crs=UTM, transform=self.transform, row0="south")

    def test_degrees_become_metres(self):
        image = skyline.to_image(np.zeros((50, 60)), crs="EPSG:4326",
                                 transform=(10.0, 0.001, 0.0, 60.0, 0.0, -0.001))
        self.assertAlmostEqual(image.GetSpacing()[0] / image.GetSpacing()[1], 0.5, delta=0.01)
        self.assertAlmostEqual(image.GetSpacing()[1], 111.4, delta=0.3)

    def test_sun_by_zone_and_datetime(self):
        zone = datetime.timezone(datetime.timedelta(hours=-7))
        moments = [self.time, "2026-06-21T07:00-07:00", np.datetime64(self.time[:-1]),
                   datetime.datetime(2026, 6, 21, 7, 0, tzinfo=zone)]
        places = {skyline.sun_position(self.image, moment) for moment in moments}
        self.assertEqual(len(places), 1)
        said = subprocess.run([PROGRAM, "sun", self.dem, "--time", self.time], check=True,
                              stdout=subprocess.PIPE, text=True).stdout
        told = dict(line.split(": ", 1) for line in said.splitlines())
        wanted = [float(told[name].split()[0])
                  for name in ("grid azimuth", "refracted elevation", "angular radius")]
        self.assertTrue(np.allclose(places.pop(), wanted, atol=SUN), (said, wanted))
        with self.assertRaisesRegex(ValueError, "no time zone"):
            skyline.sun_position(self.image, datetime.datetime(2026, 6, 21))

    def test_sky_by_time_has_its_sun(self):
        sun = skyline.sun_position(self.image, self.time)
        crop = skyline.to_image(np.zeros((8, 8)), crs=UTM, transform=self.transform)
        by_time = skyline.irradiance(crop, environment="perez:700,120", time=self.time)
        light = skyline.to_array(by_time, "Irradiance")
        expected = 700.0 * math.sin(math.radians(sun[1])) + 120.0
        self.assertTrue(np.allclose(light, expected, rtol=5e-3), light[0, 0])

    def test_shadow_heights_by_time(self):
        by_time = skyline.shadow_height(self.dem, time=self.time)
        sun = skyline.sun_position(self.image, self.time)
        self.assertTrue(np.array_equal(
            by_time, skyline.shadow_height(self.dem, sun=sun[:2]), equal_nan=True))

    def test_lamp_in_coordinates_of_the_map(self):
        x0, dx, _, y0, _, dy = self.transform
        lamp = (x0 + 10.5 * dx, y0 + 4.5 * dy, 3000.0, 5.0)  # above row 4, column 10
        light = skyline.irradiance(np.zeros((20, 20)), crs=UTM, transform=self.transform, lamps=[lamp])
        self.assertEqual(np.unravel_index(np.argmax(light[..., 0]), (20, 20)), (4, 10))

    def test_write_gives_the_place_back(self):
        sky = skyline.sky_view(self.dem, azimuths=8)
        horizons = skyline.horizon(self.dem, azimuths=3)
        with tempfile.TemporaryDirectory() as folder:
            for place in [{"like": self.dem}, {"like": self.image},
                          {"crs": UTM, "transform": self.transform}]:
                file = os.path.join(folder, "sky.tif")
                skyline.write(file, sky, **place)
                back = skyline.read(file)
                self.assertTrue(np.array_equal(skyline.to_array(back), sky, equal_nan=True))
                self.assertEqual(
                    back.GetFieldData().GetArray("GeoTransform").GetTuple(0), self.transform)
            skyline.write(file, horizons, self.dem, names=["north", "south-east", "south-west"])
            third = skyline.to_array(skyline.read(file, band=3))
            self.assertTrue(np.array_equal(third, horizons[..., 2], equal_nan=True))
            skyline.write(file, skyline.sky_view(self.image, azimuths=8), names="SkyViewFactor")
            self.assertTrue(
                np.array_equal(skyline.to_array(skyline.read(file)), sky, equal_nan=True))


class Memory(unittest.TestCase):
    def test_no_copy_where_the_order_is_vtks(self):
        for kind in ["f4", "f8", "i2"]:
            z = np.zeros((6, 5), kind)
            image = skyline.to_image(z, 10.0, row0="south")
            z[2, 3] = 7
            self.assertEqual(image.GetScalarComponentAsDouble(3, 2, 0, 0), 7.0)
            seen = skyline.to_array(image, row0="south")
            self.assertTrue(np.shares_memory(seen, z))
            self.assertTrue(np.shares_memory(skyline.to_array(image), z))

    def test_a_north_up_array_is_copied_and_stays(self):
        z = np.zeros((6, 5))
        image = skyline.to_image(z, 10.0)
        z[2, 3] = 7
        self.assertEqual(image.GetScalarRange(), (0.0, 0.0))
        self.assertTrue(np.shares_memory(skyline.to_image(z[::-1], 10.0) and z, z))
        turned = skyline.to_image(z[::-1], 10.0)  # row 0 is the south
        self.assertTrue(np.shares_memory(skyline.to_array(turned), z))

    def test_results_outlive_what_made_them(self):
        seen = [skyline.horizon(hills(), 10.0, 8) for _ in range(20)]
        self.assertTrue(all(np.array_equal(one, seen[0]) for one in seen))
        image = skyline.to_image(hills().astype(np.float32), 10.0, row0="south")
        other = [np.full((40, 50), k, np.float32) for k in range(50)]
        self.assertTrue(np.allclose(skyline.to_array(image, row0="south"), hills(), atol=1e-4))
        self.assertEqual(len(other), 50)

    def test_results_are_views(self):
        seen = skyline.sky_view(hills(), 10.0, 8)
        self.assertFalse(seen.flags.owndata)
        self.assertTrue(seen.flags.writeable)


class Images(unittest.TestCase):
    def test_image_in_image_out(self):
        z = hills()
        image = skyline.to_image(z, 10.0)
        expected = skyline.horizon(z, 10.0, 8)
        result = skyline.horizon(image, azimuths=8)
        self.assertIsInstance(result, vtkImageData)
        self.assertEqual(image.GetPointData().GetNumberOfArrays(), 1, "the input stays as it was")
        self.assertTrue(np.array_equal(skyline.to_array(result, "HorizonElevation"), expected))
        self.assertTrue(np.array_equal(skyline.to_array(result, "Elevation"), z))
        twice = skyline.sky_view(skyline.sun_visibility(image, sun=(10.0, 20.0)), azimuths=8)
        names = {twice.GetPointData().GetArrayName(i) for i in range(twice.GetPointData().GetNumberOfArrays())}
        self.assertLessEqual({"Elevation", "SunVisibility", "SkyViewFactor"}, names)

    def test_image_of_a_python_class(self):
        z = hills()
        image = Wrapped()
        image.DeepCopy(skyline.to_image(z, 10.0))
        result = skyline.sky_view(image, azimuths=8)
        self.assertIsInstance(result, vtkImageData)
        self.assertTrue(np.array_equal(
            skyline.to_array(result, "SkyViewFactor"), skyline.sky_view(z, 10.0, 8)))
        self.assertEqual(image.note, "mine")
        into = Wrapped()
        into.ShallowCopy(result)  # as pyvista.wrap does
        self.assertTrue(into.GetPointData().HasArray("SkyViewFactor"))
        filter_ = skyline.vtkHeightFieldSkyView()
        filter_.SetInputData(image)
        filter_.Update()
        self.assertTrue(filter_.GetOutput().GetPointData().HasArray("SkyViewFactor"))

    def test_heights_by_name_and_without(self):
        z = hills()
        image = skyline.to_image(z, 10.0)
        image.GetPointData().GetScalars().SetName("height above sea")
        image.GetPointData().SetActiveScalars(None)
        with self.assertRaisesRegex(ValueError, "height above sea"):
            skyline.sky_view(image)
        seen = skyline.sky_view(image, azimuths=8, scalars="height above sea")
        expected = skyline.sky_view(z, 10.0, 8)
        self.assertTrue(np.array_equal(skyline.to_array(seen, "SkyViewFactor"), expected))
        nameless = skyline.to_image(z, 10.0)
        nameless.GetPointData().GetScalars().SetName(None)
        seen = skyline.sky_view(nameless, azimuths=8)
        self.assertTrue(np.array_equal(skyline.to_array(seen, "SkyViewFactor"), expected))
        self.assertIsNone(nameless.GetPointData().GetScalars().GetName())
        self.assertEqual(vtk_to_numpy(nameless.GetPointData().GetScalars()).shape, (2000,))


if __name__ == "__main__":
    DATA, PROGRAM = sys.argv[1:3]
    del sys.argv[1:3]
    unittest.main()
