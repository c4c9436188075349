# SPDX-License-Identifier: BSD-3-Clause
"""skyline horizon, and the properties of all rasters that the program writes."""
import os

import Program
from Program import NODATA, UTM10, ToolTest, gdal, hills, make, np, osr, read

# Heights are floats relative to a base: 1e-4 m over a step of 30 m are 2e-4 degrees.
ANGLE_TOLERANCE = 1e-3


class Horizon(ToolTest):
    def horizon(self, dem, *options, out="out.tif"):
        self.succeed("horizon", dem, "-o", self.path(out), *options)
        return read(self.path(out))

    def test_level_ground_has_horizon_0_and_none_at_the_edge(self):
        dem = make(self.path("dem.tif"), np.full((12, 15), 1234.5))
        north, east, south, west = self.horizon(dem, "--azimuths", "4")
        self.assertTrue(np.all(np.abs(north[:-1]) < ANGLE_TOLERANCE))
        self.assertTrue(np.all(north[-1] == -90.0))
        self.assertTrue(np.all(np.abs(east[:, :-1]) < ANGLE_TOLERANCE))
        self.assertTrue(np.all(east[:, -1] == -90.0))
        self.assertTrue(np.all(south[0] == -90.0))
        self.assertTrue(np.all(west[:, 0] == -90.0))

    def test_inclined_plane(self):
        slope_east, slope_north = 0.25, -0.1
        y, x = np.mgrid[0:20, 0:25] * 30.0
        dem = make(self.path("dem.tif"), slope_east * x + slope_north * y)
        angles = self.horizon(dem, "--azimuths", "16")
        for k in range(16):
            azimuth = 2.0 * np.pi * k / 16
            expected = np.degrees(
                np.arctan(slope_east * np.sin(azimuth) + slope_north * np.cos(azimuth)))
            error = np.abs(angles[k, 1:-1, 1:-1] - expected)
            self.assertLess(error.max(), ANGLE_TOLERANCE, k)

    def test_wall_in_the_east_is_seen_where_the_east_is(self):
        heights = np.zeros((9, 21))
        heights[:, 20] = 100.0
        dem = make(self.path("dem.tif"), heights, step=(10.0, 20.0))
        _, east, _, west = self.horizon(dem, "--azimuths", "4")
        distance = 10.0 * (20 - np.arange(20))
        expected = np.degrees(np.arctan(100.0 / distance))
        self.assertLess(np.abs(east[:, :20] - expected).max(), ANGLE_TOLERANCE)
        self.assertLess(np.abs(west[:, 1:20]).max(), ANGLE_TOLERANCE)

    def test_bands_are_described_with_azimuth_and_unit(self):
        dem = make(self.path("dem.tif"), hills(8, 9), epsg=UTM10)
        self.horizon(dem)
        raster = gdal.Open(self.path("out.tif"))
        self.assertEqual(raster.RasterCount, 36)
        for k in range(36):
            band = raster.GetRasterBand(k + 1)
            self.assertEqual(band.DataType, gdal.GDT_Float32)
            self.assertEqual(band.GetDescription(), "HorizonElevation azimuth %d" % (10 * k))
            self.assertEqual(band.GetUnitType(), "degree")
        self.horizon(dem, "--azimuths", "7")
        raster = gdal.Open(self.path("out.tif"))
        self.assertEqual(raster.RasterCount, 7)
        self.assertEqual(
            raster.GetRasterBand(2).GetDescription(), "HorizonElevation azimuth 51.42857143")

    def test_crs_geotransform_and_nodata_are_kept(self):
        heights = hills(31, 27)
        heights[3:6, 10:14] = np.nan
        for nodata in [-9999.0, -32767.0, 1e30]:
            dem = make(self.path("dem.tif"), heights, epsg=UTM10, nodata=nodata)
            angles = self.horizon(dem, "--azimuths", "5")
            before, after = gdal.Open(dem), gdal.Open(self.path("out.tif"))
            self.assertEqual(before.GetGeoTransform(), after.GetGeoTransform())
            self.assertTrue(before.GetSpatialRef().IsSame(after.GetSpatialRef()))
            for k in range(5):
                self.assertEqual(after.GetRasterBand(k + 1).GetNoDataValue(), np.float32(nodata))
                self.assertTrue(np.array_equal(np.isnan(angles[k]), np.isnan(heights)))

    def test_saint_helens_as_it_is_bundled(self):
        dem = os.path.join(Program.DATA, "dem", "SainteHelens.tif")
        angles = self.horizon(dem, "--azimuths", "8")
        heights = read(dem)[0]
        self.assertTrue(np.array_equal(np.isnan(angles[0]), np.isnan(heights)))
        self.assertGreater(np.nanmax(angles), 30.0)
        self.assertGreaterEqual(np.nanmin(angles), -90.0)
        before, after = gdal.Open(dem), gdal.Open(self.path("out.tif"))
        self.assertEqual(before.GetGeoTransform(), after.GetGeoTransform())
        self.assertTrue(before.GetSpatialRef().IsSame(after.GetSpatialRef()))

    def test_south_up_raster_gives_the_same_map(self):
        heights = hills(23, 19)
        heights[5, 7] = np.nan
        up = make(self.path("up.tif"), heights, epsg=UTM10, nodata=NODATA)
        down = make(self.path("down.tif"), heights, epsg=UTM10, nodata=NODATA, south_up=True)
        a = self.horizon(up, "--azimuths", "12", out="a.tif")
        b = self.horizon(down, "--azimuths", "12", out="b.tif")
        self.assertTrue(np.array_equal(a, b, equal_nan=True))
        # The corners on the map are the same, whatever the order of the rows.
        corners = []
        for name in ["a.tif", "b.tif"]:
            raster = gdal.Open(self.path(name))
            x, dx, _, y, _, dy = raster.GetGeoTransform()
            ends = sorted([y, y + dy * raster.RasterYSize])
            corners.append((x, x + dx * raster.RasterXSize, *ends))
        self.assertEqual(corners[0], corners[1])

    def test_integers_floats_and_doubles_agree(self):
        heights = np.round(hills(21, 22))
        results = []
        for kind in [gdal.GDT_Int16, gdal.GDT_Int32, gdal.GDT_Float32, gdal.GDT_Float64]:
            dem = make(self.path("dem.tif"), heights, kind=kind)
            results.append(self.horizon(dem, "--azimuths", "6"))
            self.assertTrue(np.array_equal(results[0], results[-1]))

    def test_feet_are_converted(self):
        heights = hills(14, 15)
        metres = self.horizon(make(self.path("m.tif"), heights), "--azimuths", "6")
        feet = self.horizon(
            make(self.path("ft.tif"), heights / 0.3048, unit="ft"), "--azimuths", "6")
        self.assertLess(np.abs(metres - feet).max(), ANGLE_TOLERANCE)

    def test_chosen_band(self):
        heights = hills(10, 11)
        raster = gdal.GetDriverByName("GTiff").Create(
            self.path("two.tif"), 11, 10, 2, gdal.GDT_Float64)
        raster.SetGeoTransform((0.0, 30.0, 0.0, 300.0, 0.0, -30.0))
        raster.GetRasterBand(1).WriteArray(np.zeros((10, 11)))
        raster.GetRasterBand(2).WriteArray(heights[::-1])
        raster = None
        second = self.horizon(self.path("two.tif"), "--band", "2", "--azimuths", "6", out="b.tif")
        alone = self.horizon(make(self.path("one.tif"), heights), "--azimuths", "6")
        self.assertTrue(np.array_equal(second, alone))

    def test_curvature_lowers_far_horizons_unless_flat(self):
        # A wall at a distance of 30 km sinks by (1 - k) d^2 / 2R: about 61 m, an eighth of a
        # degree.
        heights = np.zeros((3, 301))
        heights[:, 300] = 1000.0
        dem = make(self.path("dem.tif"), heights, step=(100.0, 100.0), epsg=UTM10)
        distance = 30000.0
        for k in [0.13, 0.0, 0.2]:
            options = ["--azimuths", "4"] + ([] if k == 0.13 else ["--refraction", str(k)])
            curved = self.horizon(dem, *options)[1, 1, 0]
            drop = (1.0 - k) * distance**2 / (2.0 * 6.371e6)
            expected = np.degrees(np.arctan((1000.0 - drop) / distance))
            # The local radius at 46 degrees differs from 6371 km by less than 0.5 %.
            self.assertAlmostEqual(curved, expected, delta=1e-3)
        flat = self.horizon(dem, "--azimuths", "4", "--flat")[1, 1, 0]
        self.assertAlmostEqual(
            flat, np.degrees(np.arctan(1000.0 / distance)), delta=ANGLE_TOLERANCE)
        bare = make(self.path("bare.tif"), heights, step=(100.0, 100.0))
        self.assertEqual(self.horizon(bare, "--azimuths", "4")[1, 1, 0], flat)

    def test_geographic_raster_has_true_distances(self):
        # At 60 degrees north a degree of longitude is half as long as a degree of latitude: 0.5
        # degrees on the ellipsoid are 27.9 km along the row.
        heights = np.zeros((5, 51))
        heights[:, 50] = 3000.0
        dem = make(self.path("dem.tif"), heights, step=(0.01, 0.01), corner=(10.0, 59.975),
                   epsg=4326)
        east = self.horizon(dem, "--azimuths", "4", "--flat")[1, 2, 0]
        distance = 0.5 * 55800.0
        self.assertAlmostEqual(east, np.degrees(np.arctan(3000.0 / distance)), delta=0.01)

    def test_methods_and_surfaces(self):
        dem = make(self.path("dem.tif"), hills(60, 50))
        exact = self.horizon(dem, "--azimuths", "12")
        for options, typical in [(["--method", "fast"], 0.5), (["--method", "sweep"], 3.0),
                                 (["--surface", "bilinear"], 1.0), (["--tolerance", "0.1"], 0.1)]:
            other = self.horizon(dem, "--azimuths", "12", *options)
            inner = (slice(None), slice(2, -2), slice(2, -2))
            difference = np.abs(other - exact)[inner]
            self.assertLess(np.sqrt(np.mean(difference**2)), typical, options)

    def test_threads_change_nothing(self):
        dem = make(self.path("dem.tif"), hills(90, 70))
        one = self.horizon(dem, "--azimuths", "9", "--threads", "1")
        for threads in [2, 3, 8]:
            other = self.horizon(dem, "--azimuths", "9", "--threads", threads)
            self.assertTrue(np.array_equal(one, other))

    def test_cloud_optimized(self):
        dem = make(self.path("dem.tif"), hills(600, 550), epsg=UTM10)
        angles = self.horizon(dem, "--azimuths", "2", "--cloud-optimized")
        plain = self.horizon(dem, "--azimuths", "2", out="plain.tif")
        self.assertTrue(np.array_equal(angles, plain))
        raster = gdal.Open(self.path("out.tif"))
        self.assertEqual(raster.GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE"), "COG")
        self.assertGreater(raster.GetRasterBand(1).GetOverviewCount(), 0)
        self.assertEqual(
            raster.GetRasterBand(2).GetDescription(), "HorizonElevation azimuth 180")

    def test_older_file_is_replaced(self):
        dem = make(self.path("dem.tif"), hills(8, 9))
        with open(self.path("out.tif"), "w") as older:
            older.write("old")
        self.assertEqual(self.horizon(dem, "--azimuths", "3").shape, (3, 8, 9))
        self.assertEqual(self.files(), ["dem.tif", "out.tif"])

    def test_two_by_two_posts_are_a_surface(self):
        dem = make(self.path("dem.tif"), np.array([[0.0, 0.0], [0.0, 30.0]]))
        north, east, _, _ = self.horizon(dem, "--azimuths", "4")
        self.assertAlmostEqual(east[1, 0], 45.0, delta=ANGLE_TOLERANCE)
        self.assertAlmostEqual(north[0, 1], 45.0, delta=ANGLE_TOLERANCE)


if __name__ == "__main__":
    Program.main()
