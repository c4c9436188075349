# SPDX-License-Identifier: BSD-3-Clause
"""Computes the sky view factor of a DEM as a numpy array, and makes a picture of it.

Usage: sky_view_array.py DEM OUT.png
"""

import sys

import numpy as np
import skyline

if len(sys.argv) != 3:
    sys.exit("usage: sky_view_array.py DEM OUT.png")

sky = skyline.sky_view(sys.argv[1], azimuths=36)  # (rows, columns), 0 to 1, row 0 in the north
print(f"{sky.shape[0]} x {sky.shape[1]} posts see {np.nanmin(sky):.2f} to {np.nanmax(sky):.2f} of the sky")

low, high = np.nanpercentile(sky, [0.2, 100.0])  # the values that become black and white
grey = np.nan_to_num((sky - low) / (high - low), nan=1.0).clip(0.0, 1.0)
skyline.write(sys.argv[2], (255.0 * grey).astype(np.uint8))
