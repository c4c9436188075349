# SPDX-License-Identifier: BSD-3-Clause
"""Running pipelines: other threads continue, and exceptions of observers and signal handlers end the
run."""

import os
import signal
import sys
import threading
import time
import unittest
import warnings

import numpy as np
import skyline

AZIMUTHS = 720
RNG = np.random.default_rng(1)
HILLS = RNG.random((700, 700)) * 100.0


def long_run():
    """A filter that takes seconds on any machine."""
    sky = skyline.vtkHeightFieldSkyView()
    sky.SetInputData(skyline.to_image(HILLS, 10.0))
    sky.SetNumberOfAzimuths(AZIMUTHS)
    return sky


class Observers(unittest.TestCase):
    def test_an_exception_ends_the_run_with_it(self):
        sky = long_run()
        calls = []

        def fail(caller, event):
            calls.append(caller.GetProgress())
            if len(calls) == 3:
                raise LookupError("the third look")

        tag = sky.AddObserver("ProgressEvent", fail)
        hook = sys.excepthook
        with self.assertRaisesRegex(LookupError, "the third look"):
            skyline.update(sky)
        self.assertLess(calls[-1], 0.1, "it stopped there")
        self.assertIs(sys.excepthook, hook)
        sky.RemoveObserver(tag)
        sky.SetNumberOfAzimuths(4)
        skyline.update(sky)
        self.assertIsNotNone(sky.GetOutput().GetPointData().GetArray("SkyViewFactor"))

    def test_an_observer_may_run_another_pipeline(self):
        sky = long_run()
        sky.SetNumberOfAzimuths(2)
        seen = []
        sky.AddObserver("StartEvent", lambda caller, event: seen.append(
            skyline.horizon(HILLS[:9, :9], 10.0, 4).shape))
        skyline.update(sky)
        self.assertEqual(seen, [(9, 9, 4)])

    def test_hooks_of_other_threads_stay_theirs(self):
        before, heard = threading.excepthook, []
        threading.excepthook = lambda args: heard.append(args.exc_type)
        try:
            sky = long_run()
            sky.SetNumberOfAzimuths(8)

            def start(caller, event):
                other = threading.Thread(target=lambda: 1 / 0)
                other.start()
                other.join()

            sky.AddObserver("StartEvent", start)
            skyline.update(sky)
        finally:
            threading.excepthook = before
        self.assertEqual(heard, [ZeroDivisionError])


class Threads(unittest.TestCase):
    def test_other_threads_go_on(self):
        # Few azimuths of many posts. If the lock were held, other threads would run only once or
        # twice at each call of an observer, a few times per second.
        sky, ticks, done = long_run(), [0], threading.Event()
        sky.SetInputData(skyline.to_image(np.tile(HILLS, (3, 3)), 10.0))
        sky.SetNumberOfAzimuths(6)

        def tick():
            while not done.is_set():
                ticks[0] += 1
                time.sleep(0.001)

        other = threading.Thread(target=tick)
        other.start()
        try:
            start, before, seconds = time.monotonic(), ticks[0], 0.0
            while seconds < 1.0:
                sky.Modified()
                skyline.update(sky)
                seconds = time.monotonic() - start
            ticked = ticks[0] - before
        finally:
            done.set()
            other.join()
        # On an idle machine, nearly 1000 per second.
        self.assertGreater(ticked, 100 * seconds)

    def test_runs_of_many_threads_are_the_same(self):
        expected = skyline.sky_view(HILLS[:90, :90], 10.0, 24)
        image = skyline.to_image(HILLS[:90, :90], 10.0)
        results = []

        def view():
            for _ in range(3):
                skyline.sky_view(image, azimuths=24)
                results.append(skyline.sky_view(HILLS[:90, :90], 10.0, 24))

        threads = [threading.Thread(target=view) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(results), 12)
        for result in results:
            self.assertTrue(np.array_equal(result, expected))


class Signals(unittest.TestCase):
    """A signal handler runs during a run, and its exception ends the run."""

    def raised_by(self, handler):
        before = signal.signal(signal.SIGUSR1, handler)
        sky, begun = long_run(), threading.Event()
        sky.AddObserver("ProgressEvent", lambda caller, event: begun.set())

        def send():  # from outside, while VTK runs
            if begun.wait(60):
                os.kill(os.getpid(), signal.SIGUSR1)

        sender = threading.Thread(target=send)
        sender.start()
        try:
            skyline.update(sky)
        finally:
            sender.join()
            self.assertIs(signal.getsignal(signal.SIGUSR1), handler)
            signal.signal(signal.SIGUSR1, before)

    def test_a_handler_that_raises(self):
        def raise_timeout(number, frame):
            raise TimeoutError("too long")

        with self.assertRaisesRegex(TimeoutError, "too long"):
            self.raised_by(raise_timeout)

    def test_a_handler_that_exits_lets_python_clean_up(self):
        with self.assertRaises(SystemExit):
            self.raised_by(lambda number, frame: sys.exit(3))

    def test_a_handler_that_only_notes(self):
        noted = []
        sky = long_run()
        sky.SetNumberOfAzimuths(36)
        before = signal.signal(signal.SIGUSR1, lambda number, frame: noted.append(number))
        sky.AddObserver("StartEvent", lambda c, e: os.kill(os.getpid(), signal.SIGUSR1))
        try:
            skyline.update(sky)
        finally:
            signal.signal(signal.SIGUSR1, before)
        self.assertEqual(noted, [signal.SIGUSR1])
        self.assertIsNotNone(sky.GetOutput().GetPointData().GetArray("SkyViewFactor"))


class Warned(unittest.TestCase):
    def test_a_set_sun_has_infinite_shadow_heights_and_says_so(self):
        with warnings.catch_warnings(record=True) as heard:
            warnings.simplefilter("always")
            shadow = skyline.shadow_height(HILLS[:5, :5], 10.0, sun=(120.0, 0.0))
        self.assertTrue(np.all(shadow == np.inf))
        self.assertEqual([one.category for one in heard], [UserWarning])
        self.assertRegex(str(heard[0].message), "sun's centre stands at 0 degrees.*; assuming .*nodata")
        self.assertEqual(heard[0].filename, __file__, "it points at the caller")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            skyline.shadow_height(HILLS[:5, :5], 10.0, sun=(120.0, 0.1))


class EdgeTrust(unittest.TestCase):
    def test_level_square(self):
        level = np.zeros((41, 41))
        trust = skyline.sky_view(level, 10.0, quantity="EdgeTrust", edge_distance=100)
        for (row, column), azimuths in {(20, 20): 72, (0, 20): 37, (20, 40): 37, (40, 0): 19}.items():
            self.assertAlmostEqual(float(trust[row, column]), azimuths / 72, places=6)
        both = skyline.sky_view(level, 10.0, quantity=["SkyViewFactor", "EdgeTrust"])
        self.assertEqual(sorted(both), ["EdgeTrust", "SkyViewFactor"])

    def test_refusals(self):
        level = np.zeros((5, 5))
        with self.assertRaisesRegex(ValueError, "edge_distance is for"):
            skyline.sky_view(level, 10.0, edge_distance=100)
        with self.assertRaisesRegex(ValueError, "edge_distance is -1"):
            skyline.sky_view(level, 10.0, quantity="EdgeTrust", edge_distance=-1)


class Eclipse(unittest.TestCase):
    """The eclipse at Burgos on 2026-08-12, total at 18:29 UTC."""

    def setUp(self):
        self.burgos = skyline.to_image(
            np.full((11, 11), 860.0), crs="EPSG:4326", transform=(-3.755, 0.01, 0, 42.395, 0, -0.01))

    def test_position_says_so(self):
        position = skyline.sun_position(self.burgos, "2026-08-12T18:29:10Z")
        azimuth, elevation, radius = position
        self.assertEqual((azimuth, elevation, radius),
                         (position.azimuth, position.elevation, position.radius))
        self.assertEqual(position.obscuration, 1.0)
        self.assertGreater(position.magnitude, 1.0)
        position = skyline.sun_position(self.burgos, "2026-08-11T18:29:10Z")
        self.assertEqual((position.magnitude, position.obscuration), (0.0, 0.0))

    def test_visibility_and_irradiance(self):
        time = "2026-08-12T18:00Z"
        left = 1.0 - skyline.sun_position(self.burgos, time).obscuration
        seen = skyline.to_array(skyline.sun_visibility(self.burgos, time=time), "SunVisibility")
        self.assertAlmostEqual(float(seen[5, 5]), left, delta=1e-4)
        self.assertGreater(seen.max() - seen.min(), 1e-4, "it differs from place to place")
        lit = skyline.to_array(skyline.irradiance(
            self.burgos, time=time, horizontal=True, lights=[]), "Irradiance")
        plain = skyline.to_array(skyline.irradiance(
            self.burgos, sun=skyline.sun_position(self.burgos, time)[:2], horizontal=True), "Irradiance")
        self.assertAlmostEqual(float(lit[5, 5, 0] / plain[5, 5, 0]), left, delta=1e-3)
        dark = skyline.sun_visibility(self.burgos, time="2026-08-12T18:29:10Z")
        self.assertEqual(skyline.to_array(dark, "SunVisibility").max(), 0.0)


if __name__ == "__main__":
    unittest.main()
