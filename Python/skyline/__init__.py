# SPDX-License-Identifier: BSD-3-Clause
"""Horizons, sky view, soft shadows and light of height fields.

Functions from arrays to arrays, whose row 0 is the NORTH edge unless row0="south":

    import skyline
    sky = skyline.sky_view("dem.tif")                              # a raster that GDAL opens
    lit = skyline.sun_visibility(z, 30.0, sun=(315.0, 45.0))       # z: heights (rows, columns), metres

horizon, sky_view, sun_visibility, shadow_height, irradiance, sun_position; read, write, to_image,
to_array between arrays, rasters and vtkImageData. What fails raises TypeError, ValueError, or
skyline.Error with the message of the class that failed.

And the VTK classes themselves, which behave like every wrapped class of VTK:

    reader = skyline.vtkHeightFieldReader()                        # help(skyline.vtkHeightFieldHorizon)
    skyline.update(reader)                                         # as reader.Update(), but errors are raised
"""

# The base classes of the wrapped ones must be known to Python first.
from vtkmodules import vtkCommonCore, vtkCommonDataModel, vtkCommonExecutionModel  # noqa: F401
from vtkmodules import vtkRenderingCore, vtkRenderingOpenGL2  # noqa: F401

from .SkylineFilters import *  # noqa: F401,F403
from .SkylineIO import *  # noqa: F401,F403
from .SkylineRendering import *  # noqa: F401,F403

from ._doors import Options  # noqa: F401
from ._doors import horizon, irradiance, shadow_height, sky_view, sun_position, sun_visibility  # noqa: F401
from ._images import read, to_array, to_image, write  # noqa: F401
from ._run import Error, update  # noqa: F401
