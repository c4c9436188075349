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

skyline.__version__ is the version, "0.2.0" for instance.
"""

from typing import TYPE_CHECKING, Any

from ._built import __version__ as __version__
from ._native import *  # noqa: F401,F403
# "as": type checkers hand on only what is renamed.
from ._doors import Options as Options
from ._doors import horizon as horizon
from ._doors import irradiance as irradiance
from ._doors import shadow_height as shadow_height
from ._doors import sky_view as sky_view
from ._doors import sun_position as sun_position
from ._doors import sun_visibility as sun_visibility
from ._images import read as read
from ._images import to_array as to_array
from ._images import to_image as to_image
from ._images import write as write
from ._run import Error as Error
from ._run import update as update

if TYPE_CHECKING:

    def __getattr__(name: str) -> Any:
        """The wrapped classes, of which VTK has no hints."""

else:
    from ._renamed import find as __getattr__  # noqa: F401
