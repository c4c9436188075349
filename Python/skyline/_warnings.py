# SPDX-License-Identifier: BSD-3-Clause
"""Warnings about doubtful input, worded as the command line words them."""

from __future__ import annotations

import re
import sys
import warnings

# The cure at the end of a warning, as the command line spells it: "use --nodata -9999 to say otherwise".
_CURE = re.compile(r"--([a-z][a-z-]*)(?: (\S+))?(?= to say otherwise)")


def _argument(match: re.Match[str]) -> str:
    """The option of the command line as a Python argument."""
    return match[1].replace("-", "_") + "=" + (match[2] or "True")


def warn(text: str) -> None:
    """Raises a UserWarning that points at the line of the user's program which called Skyline."""
    depth = 1
    frame = sys._getframe(0)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").startswith("skyline."):
        frame = frame.f_back
        depth += 1
    warnings.warn(_CURE.sub(_argument, text), UserWarning, stacklevel=depth)


def doubt(finding: str, assumption: str, cure: str = "") -> None:
    """Warns that `finding` is doubtful input, used as `assumption` says; `cure` is an argument."""
    text = f"{finding}; assuming {assumption}"
    warn(f"{text}; use {cure} to say otherwise" if cure else text)
