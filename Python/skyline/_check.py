# SPDX-License-Identifier: BSD-3-Clause
"""Checks of arguments. Each message names the value and says what to give instead."""

from __future__ import annotations

import datetime
import math
import operator
import os
from typing import Any, Sequence

import numpy as np

from . import _warnings
from .SkylineFilters import vtkSkylineSunLight

def short(value: Any) -> str:
    """The value as one short line for a message."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else text[:57] + "..."


def number(name: str, value: Any, wanted: str, fits: Any = math.isfinite) -> float:
    """`value` as a finite float for which fits(value) holds; `wanted` describes these in words."""
    if isinstance(value, (bool, np.bool_, str, bytes)):
        raise TypeError(f"{name} is {short(value)}; give {wanted}")
    try:
        result = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {short(value)}; give {wanted}") from None
    if not math.isfinite(result) or not fits(result):
        raise ValueError(f"{name} is {result:g}; give {wanted}")
    return result


def numbers(name: str, values: Any, count: int, wanted: str) -> list[float]:
    """`values` as a list of `count` finite numbers."""
    try:
        listed = list(values)
    except TypeError:
        raise TypeError(f"{name} is {short(values)}; give {wanted}") from None
    if isinstance(values, (str, bytes)) or len(listed) != count:
        raise ValueError(f"{name} is {short(values)}; give {wanted}")
    return [number(name, value, wanted) for value in listed]


def whole(name: str, value: Any, least: int, most: int) -> int:
    """`value` as a whole number from `least` to `most`."""
    try:
        result = operator.index(value)
    except TypeError:
        result = None
    if result is None or isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} is {short(value)}; give a whole number from {least} to {most}")
    if not least <= result <= most:
        raise ValueError(f"{name} is {result}; give {least} to {most}")
    return result


def flag(name: str, value: Any) -> bool:
    """`value` as a bool. Only True and False are accepted, since bool("no") is True."""
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} is {short(value)}; give True or False")
    return bool(value)


def file_name(name: str, value: Any) -> str:
    """`value`, a file name or path, as text."""
    try:
        text = os.fsdecode(value)
        text.encode()
    except TypeError:
        raise TypeError(f"{name} is {short(value)}; give a file's name, as text or a path") from None
    except UnicodeError:
        raise ValueError(f"{name} is {short(value)}, which is not Unicode; rename the file") from None
    if not text or "\0" in text:
        raise ValueError(f"{name} is {short(value)}; give a file's name")
    return text


def texts(name: str, values: Any, wanted: str) -> list[str]:
    """`values` as a list of texts that are not empty."""
    if isinstance(values, (str, bytes)) or not np.iterable(values):
        raise TypeError(f"{name} is {short(values)}; give {wanted}")
    for value in values:
        if not isinstance(value, str) or not value:
            raise TypeError(f"{name} holds {short(value)}; give {wanted}")
    return list(values)


def choice(name: str, value: Any, choices: Sequence[str]) -> int:
    """The index of `value` in `choices`."""
    if value not in choices:
        raise ValueError(f"{name} is {short(value)}; give {' or '.join(map(repr, choices))}")
    return list(choices).index(value)


def color(name: str, value: Any) -> list[float]:
    """`value`, one number or three, as RGB; no component may be negative."""
    wanted = "one number or three (red, green, blue), 0 or more"
    rgb = [value] * 3 if np.ndim(value) == 0 else numbers(name, value, 3, wanted)
    return [number(name, part, wanted, lambda part: part >= 0.0) for part in rgb]


def direction(name: str, value: Any) -> list[float]:
    """`value` as [azimuth, elevation] in degrees."""
    wanted = "(azimuth, elevation) in degrees, the elevation from -90 to 90"
    azimuth, elevation = numbers(name, value, 2, wanted)
    number(name + "[1]", elevation, wanted, lambda degrees: abs(degrees) <= 90.0)
    return [math.fmod(azimuth, 360.0), elevation]


def moment(value: Any) -> str:
    """`value`, a time, as ISO 8601 text that the classes can read."""
    if isinstance(value, datetime.datetime):
        if value.tzinfo is None:
            raise ValueError(f"time {value} has no time zone; give tzinfo=datetime.timezone.utc")
        value = value.astimezone(datetime.timezone.utc).replace(tzinfo=None)
        return value.isoformat(timespec="milliseconds") + "Z"
    if isinstance(value, np.datetime64):
        if np.isnat(value):
            raise ValueError("time is NaT; give a moment such as '2026-06-21T06:00Z'")
        return str(value.astype("datetime64[ms]")) + "Z"
    if not isinstance(value, str):
        raise TypeError(f"time is {short(value)}; give text such as '2026-06-21T06:00Z' or a datetime")
    return _moment_text(value)


def _moment_text(text: str) -> str:
    """Checks a time given as text; adds UTC, with a warning, if it names no time zone."""
    if vtkSkylineSunLight.FindTimeError(text):
        raise ValueError(
            f"time is {short(text)}, which is not a time from 1900 to 2100; give one such as "
            "'2026-06-21T06:00Z'")
    if vtkSkylineSunLight.NamesZone(text):
        return text
    in_utc = text + ("Z" if ":" in text else "T00:00Z")
    _warnings.doubt(f"the time {text} has no time zone", "UTC", f"time='{in_utc}'")
    return in_utc
