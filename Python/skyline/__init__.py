# SPDX-License-Identifier: BSD-3-Clause
"""Horizons, sky view and soft shadows of height fields, as VTK classes.

    import skyline
    reader = skyline.vtkHeightFieldReader()

The classes behave like every wrapped VTK class: see help(skyline.vtkHeightFieldHorizon).
"""

# The base classes of the wrapped ones must be known to Python first.
from vtkmodules import vtkCommonCore, vtkCommonDataModel, vtkCommonExecutionModel  # noqa: F401
from vtkmodules import vtkRenderingCore, vtkRenderingOpenGL2  # noqa: F401

from .SkylineFilters import *  # noqa: F401,F403
from .SkylineIO import *  # noqa: F401,F403
from .SkylineRendering import *  # noqa: F401,F403
