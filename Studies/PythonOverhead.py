# SPDX-License-Identifier: BSD-3-Clause
"""CPU time of sky_view on an array, relative to the class on an image: the least of five runs."""

import time

import numpy as np
import skyline

AZIMUTHS = 16
z = np.random.default_rng(1).random((1000, 1000)).cumsum(axis=0).cumsum(axis=1) / 500.0 % 300.0
image = skyline.to_image(z, 10.0)


def by_class():
    filter_ = skyline.vtkHeightFieldSkyView()
    filter_.SetInputData(image)
    filter_.SetNumberOfAzimuths(AZIMUTHS)
    for name in ["SkyViewFactorHorizontal", "VisibleSkyFraction", "PositiveOpenness"]:
        getattr(filter_, "Set" + name)(False)
    filter_.Update()
    return filter_


def seconds(call):
    times = []
    for _ in range(5):
        start = time.process_time()
        call()
        times.append(time.process_time() - start)
    return min(times)


own, function = seconds(by_class), seconds(lambda: skyline.sky_view(z, 10.0, AZIMUTHS))
print(f"class {own:.3f} s, function {function:.3f} s: {function / own:.3f}")
