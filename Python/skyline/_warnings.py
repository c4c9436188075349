# SPDX-License-Identifier: BSD-3-Clause
"""Warnings about doubtful input, with the same text as on the command line."""

from __future__ import annotations

import re
import sys
import warnings

# The option at the end of a warning of the command line: "use --nodata -9999 to say otherwise".
_CURE = re.compile(r"--([a-z][a-z-]*)(?: (\S+))?(?= to say otherwise)")


def _argument(match: re.Match[str]) -> str:
    """An option of the command line as a Python argument."""
    return match[1].replace("-", "_") + "=" + (match[2] or "True")


def warn(text: str) -> None:
    """Raises a UserWarning that points at the line of the user program that called Skyline."""
    depth = 1
    frame = sys._getframe(0)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").startswith("skyline."):
        frame = frame.f_back
        depth += 1
    warnings.warn(_CURE.sub(_argument, text), UserWarning, stacklevel=depth)


def doubt(finding: str, assumption: str, cure: str = "") -> None:
    """Warns of doubtful input: what was found, what is assumed, and the argument to change that."""
    text = f"{finding}; assuming {assumption}"
    warn(f"{text}; use {cure} to say otherwise" if cure else text)
