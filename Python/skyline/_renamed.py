# SPDX-License-Identifier: BSD-3-Clause
"""Classes under the names that they had before version 0.2."""

import warnings
from typing import Any

from . import _native

_NAMES = {
    "vtkHeightFieldSink": "vtkHeightFieldFileWriter",
    "vtkLightMapReader": "vtkSkylineLightMapReader",
    "vtkOpenGLShadowHeightMap": "vtkOpenGLHeightFieldShadowHeight",
    "vtkShadowHeightMap": "vtkHeightFieldShadowHeight",
    "vtkShadowReceiver": "vtkHeightFieldShadowReceiver",
    "vtkSoftShadowPolyDataMapper": "vtkSkylineSoftShadowPolyDataMapper",
    "vtkSoftShadowShader": "vtkSkylineSoftShadowShader",
}


def find(name: str) -> Any:
    """The class with an old name, with a DeprecationWarning. AttributeError for other names."""
    if name not in _NAMES:
        raise AttributeError(f"module 'skyline' has no attribute {name!r}")
    warnings.warn(
        f"{name} was renamed to {_NAMES[name]} in version 0.2", DeprecationWarning, stacklevel=3)
    return getattr(_native, _NAMES[name])
