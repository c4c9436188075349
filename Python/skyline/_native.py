# SPDX-License-Identifier: BSD-3-Clause
"""The wrapped classes. If they cannot be loaded, one error says what is missing."""

import sys

from ._built import PYTHON_VERSION, VTK_VERSION

# Checked before compiled modules are loaded: in another Python they may crash instead of raising.
_python = "%d.%d" % sys.version_info[:2]
if _python != PYTHON_VERSION:
    raise ImportError(
        f"skyline was built for Python {PYTHON_VERSION}, but {sys.executable} is Python {_python}; "
        f"run python{PYTHON_VERSION}, or build Skyline with -DPython3_EXECUTABLE={sys.executable}")

try:
    import numpy  # noqa: F401
    import vtkmodules

    # Python must know the base classes of the wrapped classes first.
    from vtkmodules import vtkCommonCore, vtkCommonDataModel  # noqa: F401
    from vtkmodules import vtkCommonExecutionModel, vtkIOCore  # noqa: F401
except ImportError as reason:
    raise ImportError(
        f"skyline needs numpy and VTK's Python modules, but in {sys.executable}: {reason}; run a Python "
        "that has them, for instance Debian's /usr/bin/python3 with python3-numpy and python3-vtk9"
    ) from None

# Two versions of VTK in one process cannot use each other's classes.
_vtk = vtkCommonCore.vtkVersion.GetVTKVersion()
if _vtk.split(".")[:2] != VTK_VERSION.split(".")[:2]:
    raise ImportError(
        f"skyline was built with VTK {VTK_VERSION}, but {vtkmodules.__file__} is VTK {_vtk}; run the "
        "Python whose VTK it was built with, or build Skyline with that VTK (-DVTK_DIR=...)")

try:
    from vtkmodules import vtkRenderingCore, vtkRenderingOpenGL2  # noqa: F401

    from .SkylineFilters import *  # noqa: F401,F403
    from .SkylineIO import *  # noqa: F401,F403
    from .SkylineRendering import *  # noqa: F401,F403
except ImportError as reason:
    raise ImportError(
        f"skyline's compiled modules cannot be loaded: {reason}; build them with ./bootstrap python and "
        "use the package in build/python") from None
