# SPDX-License-Identifier: BSD-3-Clause
"""Horizons, sky view, soft shadows and light of height fields.

The functions take arrays and return arrays. Row 0 of an array is its NORTH edge, unless
row0="south":

    import skyline
    sky = skyline.sky_view("dem.tif")                              # a raster that GDAL opens
    lit = skyline.sun_visibility(z, 30.0, sun=(315.0, 45.0))       # z: heights in metres

The functions horizon, sky_view, sun_visibility, shadow_height, irradiance and sun_position compute;
read, write, to_image and to_array convert between arrays, rasters and vtkImageData. They raise
TypeError or ValueError for wrong arguments, and skyline.Error with the message of the VTK class
that failed. Doubtful input raises a UserWarning.

The VTK classes are also here. They behave like all wrapped classes of VTK:

    reader = skyline.vtkHeightFieldReader()     # see help(skyline.vtkHeightFieldReader)
    skyline.update(reader)                      # like reader.Update(), but raises errors

skyline.__version__ is the version, for instance "0.2.0".
"""

from typing import TYPE_CHECKING, Any

from ._built import __version__ as __version__
from ._native import *  # noqa: F401,F403
# Type checkers export only names that are imported with "as".
from ._functions import Options as Options
from ._functions import horizon as horizon
from ._functions import irradiance as irradiance
from ._functions import shadow_height as shadow_height
from ._functions import sky_view as sky_view
from ._functions import sun_position as sun_position
from ._functions import sun_visibility as sun_visibility
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
