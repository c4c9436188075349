# SPDX-License-Identifier: BSD-3-Clause
"""How much sky does each post of a DEM see? A post is the centre of a raster pixel with its height.

Usage: sky_view.py DEM OUT.tif
"""

import sys

import skyline

if len(sys.argv) != 3:
    sys.exit("usage: sky_view.py DEM OUT.tif")

reader = skyline.vtkHeightFieldReader()
reader.SetFileName(sys.argv[1])

sky_view = skyline.vtkHeightFieldSkyView()
sky_view.SetInputConnection(reader.GetOutputPort())
sky_view.SetNumberOfAzimuths(36)

writer = skyline.vtkHeightFieldWriter()
writer.SetInputConnection(sky_view.GetOutputPort())
writer.SetFileName(sys.argv[2])
sys.exit(0 if writer.Write() else 1)
