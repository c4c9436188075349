# SPDX-License-Identifier: BSD-3-Clause
"""Wrong input: one clear exception that names the value and what to do, no output, no crash."""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import warnings

import numpy as np
import skyline

Z = np.arange(12.0).reshape(3, 4)
NORTH_UP = (500000.0, 30.0, 0.0, 4649776.0, 0.0, -30.0)
NAN, INF = float("nan"), float("inf")
PROMPT = 5.0  # seconds from Ctrl-C to the exception on a busy machine


class BadInput(unittest.TestCase):
    def refused(self, kind, says, call, *arguments, **options):
        with self.assertRaisesRegex(kind, says) as caught:
            call(*arguments, **options)
        self.assertNotIn("\n", str(caught.exception))
        self.assertIs(type(caught.exception), kind)

    def test_types_of_heights(self):
        for z, named in [(Z > 3, "bool"), (Z.astype(complex), "complex128"),
                         (Z.astype(object), "object"), (Z.astype(str), "<U"), (None, "object"),
                         (Z.astype("M8[s]"), "datetime64")]:
            self.refused(TypeError, f"z has the type {named}.*astype", skyline.horizon, z, 10.0)
        self.refused(ValueError, "rows of different lengths", skyline.horizon, [[1, 2], [3]], 10.0)

    def test_shapes_of_heights(self):
        for shape in [(), (0,), (5,), (0, 0), (1, 5), (5, 1), (2, 3, 4)]:
            self.refused(ValueError, r"z has the shape .*at least 2 x 2",
                         skyline.sky_view, np.zeros(shape), 10.0)

    def test_spacing(self):
        for call in [skyline.horizon, skyline.sky_view]:
            for spacing in [0, 0.0, -1.0, NAN, INF, (10.0, 0.0), (NAN, 1.0), np.array([5.0, -5.0])]:
                self.refused(ValueError, "spacing is .*metres between posts above 0", call, Z, spacing)
            for spacing in [(1.0, 2.0, 3.0), (), "ab"]:
                self.refused((TypeError if spacing == "ab" else ValueError), "spacing is .*metres",
                             call, Z, spacing)
            self.refused(TypeError, "spacing is missing", call, Z)
            self.refused(TypeError, "spacing is True", call, Z, True)
            for spacing in [{"dx": 3}.values, np.ones((2, 50))]:
                self.refused(TypeError, r"spacing is .*metres", call, Z, spacing)

    def test_more_than_memory_holds(self):
        z = np.zeros((6000, 6000), np.float32)
        self.refused(skyline.Error, "horizons of 6000 x 6000 posts take 518.* GB", skyline.horizon, z, 30.0, 3600)

    def test_every_post_missing(self):
        for call, options in [(skyline.horizon, {}), (skyline.sky_view, {}),
                              (skyline.sun_visibility, {"sun": (1, 2)}),
                              (skyline.shadow_height, {"sun": (1, 2)}), (skyline.irradiance, {})]:
            self.refused(skyline.Error, "every post is missing", call, Z * NAN, 10.0, **options)

    def test_options(self):
        self.refused(ValueError, "row0 is 'top'; give 'north' or 'south'",
                     skyline.horizon, Z, 10.0, row0="top")
        self.refused(ValueError, "method is 'best'", skyline.horizon, Z, 10.0, method="best")
        self.refused(ValueError, "surface is 'smooth'", skyline.horizon, Z, 10.0, surface="smooth")
        self.refused(TypeError, "unexpected keyword argument 'azimuth'",
                     skyline.horizon, Z, 10.0, azimuth=3)
        for azimuths in [0, -3, 3601]:
            self.refused(ValueError, "azimuths is .*1 to 3600", skyline.horizon, Z, 10.0, azimuths)
        for azimuths in [8.0, "8", None, True]:
            self.refused(TypeError, "azimuths is .*whole number", skyline.sky_view, Z, 10.0, azimuths)
        self.refused(ValueError, "quantity is 'SVF'.*'SkyViewFactor'",
                     skyline.sky_view, Z, 10.0, quantity="SVF")
        self.refused(TypeError, "nodata is", skyline.horizon, Z, 10.0, nodata="none")
        for quantity in [5, None, {"SkyViewFactor"}]:
            self.refused(TypeError, "quantity is .*give a name", skyline.sky_view, Z, 10.0, quantity=quantity)
        for call, name in [(skyline.sun_visibility, "limb_darkening"), (skyline.irradiance, "horizontal"),
                           (skyline.shadow_height, "below_terrain"), (skyline.shadow_height, "flat")]:
            self.refused(TypeError, f"{name} is 'no'; give True or False",
                         call, Z, 10.0, sun=(1, 2), **{name: "no"})

    def test_suns(self):
        sun = skyline.sun_visibility
        self.refused(TypeError, "give sun=", sun, Z, 10.0)
        self.refused(TypeError, "not both", sun, Z, 10.0, (1, 2), time="2026-06-21")
        self.refused(TypeError, "give sun=", skyline.shadow_height, Z, 10.0)
        for direction in [(1.0, 91.0), (NAN, 1.0), (1.0, INF), (1.0,), (1.0, 2.0, 3.0)]:
            self.refused(ValueError, "sun.*degrees", sun, Z, 10.0, direction)
        self.refused(TypeError, "sun is 5", sun, Z, 10.0, 5)
        for radius in [-1.0, 90.0, NAN]:
            self.refused(ValueError, "radius is .*below 90", sun, Z, 10.0, (1, 2), radius=radius)
        self.refused(skyline.Error, "place|georeference|CRS", sun, Z, 10.0, time="2026-06-21T06:00Z")
        place = {"crs": "EPSG:32631", "transform": NORTH_UP}
        self.refused(ValueError, "yesterday.*is not a time", sun, Z, time="yesterday", **place)
        self.refused(ValueError, "1800.*1900 to 2100", sun, Z, time="1800-01-01", **place)
        self.refused(TypeError, "time is 5", sun, Z, time=5, **place)

        for time in ["2026-02-30T06:00Z", "2026-06-21T06:00+99:00", "2026-06-21T25:00Z", "", "2026"]:
            self.refused(ValueError, "is not a time", sun, Z, time=time, **place)
        with self.assertWarnsRegex(UserWarning, "06:00 has no time zone; assuming UTC; use time='2026.*Z'"):
            sun(Z, time="2026-06-21 06:00", **place)

    def test_times_as_python_prints_them(self):
        place = {"crs": "EPSG:32631", "transform": NORTH_UP}
        wanted = skyline.sun_visibility(Z, time="2026-06-21T04:30Z", **place)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for time in ["2026-06-21 04:30:00+00:00", "2026-06-21 06:30:00.000000000+0200",
                         "2026-06-21 04:30:00 UTC", "2026-06-21T06:30+02"]:
                np.testing.assert_array_equal(skyline.sun_visibility(Z, time=time, **place), wanted)

    def test_what_cannot_act(self):
        light, sun = skyline.irradiance, {"sun": (1.0, 20.0)}
        self.refused(ValueError, "radius is 0.*limb", skyline.sun_visibility, Z, 10.0, (1, 2), radius=0,
                     limb_darkening=True)
        self.refused(ValueError, "perez.*give sun=", light, Z, 10.0, "perez:800,100")
        for sky in ["uniform", "cie:1"]:
            self.refused(ValueError, "same all around", light, Z, 10.0, sky, rotation=9.0, **sun)
        with self.assertWarnsRegex(UserWarning, "rotation turns the sky cie:12.*away from the sun"):
            light(Z, 10.0, "cie:12", rotation=9.0, **sun)
        self.refused(ValueError, "no light map is given", light, Z, 10.0, rotation=9.0, **sun)
        for name in ["sun_irradiance", "radius"]:
            self.refused(ValueError, f"{name} is given, but no sun", light, Z, 10.0, **{name: 1.0})
        self.refused(ValueError, "which lamps do not use", light, Z, 10.0, lamps=[(1, 2, 3, 4)],
                     light_method="sh")
        for method in ["sweep", "pyramid"]:
            self.refused(ValueError, "surface is 'bilinear'", skyline.horizon, Z, 10.0, method=method,
                         surface="bilinear")
        self.refused(ValueError, "method is 'pyramid'", skyline.shadow_height, Z, 10.0, method="pyramid",
                     **sun)
        self.refused(ValueError, "surface is 'bilinear'", skyline.shadow_height, Z, 10.0,
                     surface="bilinear", **sun)
        with self.assertWarnsRegex(UserWarning, "cie:12 is brighter around the sun.*assuming its sun"):
            light(Z, 10.0, "cie:12")
        with self.assertWarnsRegex(UserWarning, "lamp 1 stands 5000 km outside"):
            light(Z, 10.0, lamps=[(5e6, 0.0, 3.0, 1.0)])

    def test_places(self):
        to_image = skyline.to_image
        self.refused(ValueError, "without a transform", to_image, Z, 10.0, crs="EPSG:32631")
        self.refused(ValueError, "leave spacing out", to_image, Z, 10.0, transform=NORTH_UP)
        self.refused(ValueError, "crs is 'EPSG:1'", to_image, Z, crs="EPSG:1", transform=NORTH_UP)
        self.refused(ValueError, "crs is 'there'", to_image, Z, crs="there", transform=NORTH_UP)
        for crs in [5.5, "EPSG:\0", b"EPSG:32631", " "]:
            self.refused(TypeError, "crs is ", to_image, Z, crs=crs, transform=NORTH_UP)
        # The order of rasterio, a rotated raster, columns that run west, no step, no number.
        for six in [(30.0, 0.0, 5e5, 0.0, -30.0, 4.6e6), (5e5, 30.0, 1.0, 4.6e6, 1.0, -30.0),
                    (5e5, -30.0, 0.0, 4.6e6, 0.0, -30.0), (5e5, 30.0, 0.0, 4.6e6, 0.0, 0.0)]:
            self.refused(ValueError, "transform is .*GDAL's order", to_image, Z, transform=six)
        for six in [(1.0, 2.0), "abcdef", (5e5, NAN, 0.0, 4.6e6, 0.0, -30.0)]:
            with self.assertRaisesRegex((TypeError, ValueError), "transform"):
                to_image(Z, transform=six)
        self.refused(skyline.Error, "array.*crs 'EPSG:32631'", to_image, Z, crs="EPSG:32631",
                     transform=(1e12, 30.0, 0.0, 1e12, 0.0, -30.0))

    def test_lights(self):
        light = skyline.irradiance
        for sky in ["cie:17", "cie:x", "perez:100", "perez:-1,5", "perez:1,0"]:
            self.refused(ValueError, "environment is .*'cie:1'", light, Z, 10.0, sky)
        self.refused(skyline.Error, "nosuch.hdr", light, Z, 10.0, "nosuch.hdr")
        self.refused(ValueError, "environment is 'unifrom'; give 'uniform'", light, Z, 10.0, "unifrom")
        for shape in [(4, 4, 3), (4, 8), (4, 8, 4), (0, 0, 3)]:
            self.refused(ValueError, "environment has the shape", light, Z, 10.0, np.zeros(shape))
        for radiance in [NAN, INF, -1.0]:
            self.refused(ValueError, "environment holds .*finite and 0 or more",
                         light, Z, 10.0, np.full((4, 8, 3), radiance))
        for strength in [-1.0, NAN, (1.0, 2.0), (1.0, -1.0, 1.0)]:
            self.refused(ValueError, "sun_irradiance", light, Z, 10.0, sun=(1, 2),
                         sun_irradiance=strength)
        for lamp in [(1, 2, 3, 0), (1, 2, 3), (1, 2, 3, -1.0), (1, 2, NAN, 4), (1, 2, 3, 4, 5, 6, -7)]:
            self.refused(ValueError, r"lamps\[0\]", light, Z, 10.0, lamps=[lamp])
        self.refused(TypeError, r"lamps\[0\]", light, Z, 10.0, lamps=[4])
        self.refused(TypeError, "lamps is 4", light, Z, 10.0, lamps=4)
        self.refused(TypeError, r"lights\[0\] is 'sun'", light, Z, 10.0, lights=["sun"])
        self.refused(ValueError, "light_method is 'ray'", light, Z, 10.0, light_method="ray")

    def test_images_and_files(self):
        image = skyline.to_image(Z, 10.0)
        self.refused(TypeError, "spacing is given", skyline.horizon, image, 10.0)
        self.refused(TypeError, "crs is given", skyline.horizon, "dem.tif", crs=4326)
        self.refused(ValueError, "no point array 'Height'.*'Elevation'",
                     skyline.horizon, image, scalars="Height")
        self.refused(ValueError, "no point array 'Sun'", skyline.to_array, image, "Sun")
        self.refused(TypeError, "give a vtkImageData", skyline.to_array, Z)
        self.refused(skyline.Error, "nosuch.tif.*check the path", skyline.read, "nosuch.tif")
        self.refused(skyline.Error, "nosuch.tif", skyline.sky_view, "nosuch.tif")
        self.refused(ValueError, "band is 0", skyline.read, "nosuch.tif", 0)
        for name in ["", "dem\0.tif", "\udcff.tif"]:
            self.refused(ValueError, "file is .*", skyline.read, name)
            self.refused(ValueError, "file is .*", skyline.write, name, Z, image)
            self.refused(ValueError, "environment is .*", skyline.irradiance, Z, 10.0, name)
        for name in [None, 5, Z]:
            self.refused(TypeError, "file is .*give a file's name", skyline.read, name)
        image.SetDimensions(3, 2, 2)
        self.refused(skyline.Error, "2 slices", skyline.horizon, image)

    def test_writing(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "out.tif")
            image = skyline.to_image(Z, 10.0)
            self.refused(ValueError, "same posts", skyline.write, file, Z.T, image)
            self.refused(TypeError, "values has the type bool", skyline.write, file, Z > 1, image)
            self.refused(ValueError, "values has the shape", skyline.write, file, Z[0], image)
            self.refused(TypeError, "spacing is missing", skyline.write, file, Z)
            self.refused(ValueError, "leave out", skyline.write, file, Z, image, spacing=10.0)
            self.refused(ValueError, "names has 2", skyline.write, file, Z, image, names=["a", "b"])
            self.refused(skyline.Error, "Nothing", skyline.write, file, image, names="Nothing")
            self.refused(skyline.Error, "no/such", skyline.write, folder + "/no/such/out.tif", image)
            self.assertEqual(os.listdir(folder), [])


class NotThere(unittest.TestCase):
    """The messages for a user with an unsuitable Python or an incomplete build."""

    def said(self, code, path=None):
        environment = dict(os.environ, PYTHONPATH=path or os.environ["PYTHONPATH"])
        done = subprocess.run([sys.executable, "-c", code], env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertNotIn("During handling", done.stdout)
        return done.stdout.splitlines()[-1]

    def test_modules(self):
        for name in ["numpy", "vtkmodules"]:
            said = self.said(f"import sys; sys.modules['{name}'] = None; import skyline")
            self.assertRegex(said, f"ImportError: skyline needs numpy and VTK.*{name}.*python3-vtk9")

    def test_another_build(self):
        package = os.path.dirname(skyline.__file__)
        with tempfile.TemporaryDirectory() as folder:
            copy = os.path.join(folder, "skyline")
            shutil.copytree(package, copy, ignore=shutil.ignore_patterns("*.so", "__pycache__"))
            self.assertRegex(self.said("import skyline", folder),
                             "ImportError: skyline's compiled modules cannot be loaded: .*SkylineFilters.*bootstrap")
            for name, version, says in [("PYTHON_VERSION", "3.7", r"built for Python 3.7, but .*DPython3_EXEC"),
                                        ("VTK_VERSION", "9.99.0", "built with VTK 9.99.0, but .* is VTK 9")]:
                shutil.copy(os.path.join(package, "_built.py"), copy)
                with open(os.path.join(copy, "_built.py"), "a", encoding="utf-8") as file:
                    file.write(f"{name} = {version!r}\n")
                self.assertRegex(self.said("import skyline", folder), f"ImportError: skyline was {says}")


class Quiet(unittest.TestCase):
    def run_code(self, code, **options):
        return subprocess.run([sys.executable, "-c", "import numpy as np, skyline\n" + code],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)

    def test_errors_are_raised_and_not_printed(self):
        done = self.run_code(
            "for call in [lambda: skyline.read('nosuch.tif'),\n"
            "             lambda: skyline.horizon(np.full((3, 3), np.nan), 1.0),\n"
            "             lambda: skyline.write('/nosuch/a.tif', np.ones((3, 3)), spacing=1.0)]:\n"
            "    try:\n"
            "        call()\n"
            "    except skyline.Error:\n"
            "        pass\n")
        self.assertEqual((done.returncode, done.stdout), (0, ""))

    def test_errors_anywhere_in_a_pipeline(self):
        done = self.run_code(
            "source = skyline.vtkHeightFieldReader()\n"
            "source.SetFileName('nosuch.tif')\n"
            "sun = skyline.vtkHeightFieldSunShadow()\n"
            "sun.SetInputConnection(source.GetOutputPort())\n"
            "sky = skyline.vtkHeightFieldSkyView()\n"
            "sky.SetInputConnection(sun.GetOutputPort())\n"
            "try:\n"
            "    skyline.update(sky)\n"
            "except skyline.Error as reason:\n"
            "    print('nosuch.tif' in str(reason))\n"
            "try:\n"
            "    skyline.update(5)\n"
            "except TypeError as reason:\n"
            "    print(reason)\n")
        self.assertEqual(
            (done.returncode, done.stdout), (0, "True\nalgorithm is 5; give a vtkAlgorithm\n"))

    def test_interrupt(self):
        code = ("import numpy as np, signal, sys, skyline\n"
                "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
                "z = np.random.default_rng(1).random((1200, 1200)) * 100.0\n"
                "sun = skyline.vtkHeightFieldSkyView()\n"
                "sun.SetInputData(skyline.to_image(z, 1.0))\n"
                "sun.SetNumberOfAzimuths(3600)\n"
                "sky = skyline.vtkHeightFieldSunShadow()\n"
                "sky.SetInputConnection(sun.GetOutputPort())\n"
                "for call in [lambda: skyline.sky_view(z, 1.0, 3600), lambda: skyline.update(sky)]:\n"
                "    print('ready', flush=True)\n"
                "    try:\n"
                "        call()\n"
                "    except KeyboardInterrupt:\n"
                "        print('stopped', flush=True)\n"
                "print(skyline.sky_view(z[:9, :9], 1.0, 4).shape)\n")
        with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True) as program:
            for _ in range(2):
                self.assertEqual(program.stdout.readline(), "ready\n")
                time.sleep(0.5)
                start = time.monotonic()
                program.send_signal(signal.SIGINT)
                self.assertEqual(program.stdout.readline(), "stopped\n")
                self.assertLess(time.monotonic() - start, PROMPT)
            self.assertEqual(program.stdout.read(), "(9, 9)\n", "and works on")
            self.assertEqual(program.wait(), 0)

    def test_other_threads(self):
        done = self.run_code(
            "from concurrent.futures import ThreadPoolExecutor as Pool\n"
            "z = np.arange(400.0).reshape(20, 20) % 7\n"
            "with Pool(4) as pool:\n"
            "    seen = list(pool.map(lambda k: skyline.sky_view(z, 1.0, 8), range(16)))\n"
            "print(all(np.array_equal(one, seen[0]) for one in seen))\n")
        self.assertEqual((done.returncode, done.stdout), (0, "True\n"))


if __name__ == "__main__":
    unittest.main()
