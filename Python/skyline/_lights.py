# SPDX-License-Identifier: BSD-3-Clause
"""Lights as users write them, made into classes."""

from __future__ import annotations

import math
import os
import re
from typing import Any, Iterable

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData

from . import _check, _warnings
from ._images import _numeric, _to_vtk
from ._run import reported, run
from .SkylineFilters import (
    vtkSkylineEnvironmentLight,
    vtkSkylineKeyLight,
    vtkSkylineLampLight,
    vtkSkylineLight,
    vtkSkylineSunLight,
)
from .SkylineIO import vtkSkylineLightMapReader

_ZONAL = (1, 3, 5, 16)  # the CIE skies that are the same all around
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)  # no "inf", "1_000" or " 1"

MEAN_SUN_RADIUS = 0.26645  # degrees, as in vtkHeightFieldSunShadow
LARGEST_SUN = 3.0  # degrees: greater discs are key lights
_SKIES = "'uniform', 'cie:1' to 'cie:16', 'perez:DIRECT,DIFFUSE' in W/m2, a file's name or a light map"


def environment_light(environment: Any, rotation: Any, sun: Any) -> vtkSkylineEnvironmentLight:
    """The environment of irradiance(); `sun` is (azimuth, elevation) or None."""
    light = vtkSkylineEnvironmentLight()
    light.SetRotation(math.fmod(_check.number("rotation", rotation, "degrees"), 360.0))
    if isinstance(environment, (str, os.PathLike)):
        name = _check.file_name("environment", environment)
        kind, _, rest = name.partition(":")
        if kind in ("cie", "perez"):
            _set_sky(light, name, kind, rest, sun)
        elif name != "uniform":
            reader = vtkSkylineLightMapReader()
            reader.SetFileName(name)
            run(reader)
            light.SetImage(reader.GetOutput())
    elif isinstance(environment, vtkImageData):
        light.SetImage(environment)
    else:
        light.SetImage(_light_map(environment))
    same = light.GetSource() == light.UNIFORM or (
        light.GetSource() == light.CIE and light.GetCieType() in _ZONAL)
    if rotation != 0.0 and same:
        raise ValueError(
            f"rotation is {rotation:g}, but this sky is the same all around; leave it out, or give a light map")
    return light


def _set_sky(
    light: vtkSkylineEnvironmentLight, name: str, kind: str, rest: str, sun: Any
) -> None:
    parts = rest.split(",")
    given = [float(part) for part in parts] if all(map(_NUMBER.fullmatch, parts)) else []
    given = given if all(map(math.isfinite, given)) else []
    if kind == "cie" and len(given) == 1 and given[0] in range(1, 17):
        light.SetSourceToCie()
        light.SetCieType(int(given[0]))
    elif kind == "perez" and len(given) == 2 and given[0] >= 0.0 and given[1] > 0.0:
        light.SetSourceToPerez()
        light.SetDirectIrradiance(given[0])
        light.SetDiffuseIrradiance(given[1])
        if sun is None:
            raise ValueError(
                f"environment is {name!r}, a sky of the sun; give sun=(azimuth, elevation) or time")
    else:
        raise ValueError(f"environment is {name!r}; give {_SKIES}")
    if sun is not None:
        light.SetSunAzimuth(sun[0])
        light.SetSunElevation(sun[1])
    elif kind == "cie" and light.GetCieType() not in _ZONAL:
        _warnings.doubt(
            f"the sky {name} is brighter about the sun, and no sun is given",
            "its sun at azimuth 315, elevation 45", "sun=(azimuth, elevation)")


def _light_map(pixels: Any) -> vtkImageData:
    """Rows from the zenith down, centre column north, (rows, 2 rows, 3)."""
    values = _numeric("environment", pixels)
    rows, columns = values.shape[:2] if values.ndim == 3 else (0, 0)
    if rows < 1 or columns != 2 * rows or values.shape[2] != 3:
        raise ValueError(
            f"environment has the shape {values.shape}; give (rows, 2 rows, 3), linear RGB, the top "
            "row the zenith")
    wrong = values[~(np.isfinite(values) & (values >= 0))]
    if wrong.size:
        raise ValueError(
            f"environment holds {wrong[0]:g}; give linear RGB, finite and 0 or more, by "
            "np.nan_to_num(environment.clip(0)) for instance")
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    radiance = _to_vtk(values[::-1].astype(np.float32))
    radiance.SetName("Radiance")
    image.GetPointData().SetScalars(radiance)
    return image


def sun_light(direction: list[float], irradiance: Any, radius: Any) -> vtkSkylineLight:
    """The sun of a direction; a wide disc is a key light of the same irradiance."""
    rgb = _check.color("sun_irradiance", irradiance)
    width = check_radius(MEAN_SUN_RADIUS if radius is None else radius)
    if width > LARGEST_SUN:
        light = vtkSkylineKeyLight()
        light.SetRadiance(*(part / (math.pi * math.sin(math.radians(width)) ** 2) for part in rgb))
    else:
        light = vtkSkylineSunLight()
        light.SetIrradiance(*rgb)
    light.SetAzimuth(direction[0])
    light.SetElevation(direction[1])
    light.SetAngularRadius(width)
    return light


def sun_of_time(time: Any, irradiance: Any, radius: Any) -> vtkSkylineSunLight:
    """The sun of a moment over each post."""
    light = vtkSkylineSunLight()
    light.UseTimeOn()
    light.SetTime(_check.moment(time))
    light.SetIrradiance(*_check.color("sun_irradiance", irradiance))
    if radius is not None:
        light.SetTrueRadius(False)
        light.SetAngularRadius(_check.number(
            "radius", radius, "0 to 3 degrees with time", lambda r: 0.0 <= r <= LARGEST_SUN))
    return light


def check_radius(radius: Any) -> float:
    return _check.number("radius", radius, "0 to below 90 degrees", lambda r: 0.0 <= r < 90.0)


def lamp_lights(lamps: Any, terrain: vtkImageData) -> Iterable[vtkSkylineLampLight]:
    """Lamps (x, y, z, radius) or (x, y, z, radius, red, green, blue)."""
    wanted = "(x, y, z, radius) in metres, or with red, green and blue after them"
    if isinstance(lamps, (str, bytes)) or not np.iterable(lamps):
        raise TypeError(f"lamps is {_check.short(lamps)}; give a list of {wanted}")
    for place, lamp in enumerate(lamps):
        name = f"lamps[{place}]"
        parts = tuple(lamp) if np.iterable(lamp) else lamp
        count = 7 if np.size(parts) == 7 else 4
        given = _check.numbers(name, parts, count, wanted)
        _check.number(name + "[3]", given[3], "a radius above 0", lambda r: r > 0.0)
        light = vtkSkylineLampLight()
        light.SetPosition(*_in_image(given[0], given[1], terrain), given[2])
        light.SetRadius(given[3])
        if count == 7:
            light.SetRadiance(*_check.color(name + "[4:]", given[4:]))
        yield light


def _in_image(x: float, y: float, terrain: vtkImageData) -> tuple[float, float]:
    """Coordinates of the CRS as those of the image; without a CRS they are the same."""
    array = terrain.GetFieldData().GetArray("GeoTransform")
    if array is None:
        return x, y
    x0, dx, _, y0, _, dy = array.GetTuple(0)
    rows = terrain.GetDimensions()[1]
    column = (x - x0) / dx - 0.5
    row = rows - 1 - ((y - y0) / dy - 0.5)
    origin, spacing = terrain.GetOrigin(), terrain.GetSpacing()
    return origin[0] + column * spacing[0], origin[1] + row * spacing[1]


class SunPosition(tuple[float, float, float]):
    """(azimuth, elevation, radius) in degrees, also by name, and the eclipse at that time.

    magnitude     the part of the sun's diameter that the Moon covers; in totality, and with a ring, the
                  ratio of both diameters; 0 without an eclipse
    obscuration   the share of the disc's area that it covers, 0 to 1
    """

    magnitude: float
    obscuration: float

    @property
    def azimuth(self) -> float:
        return self[0]

    @property
    def elevation(self) -> float:
        return self[1]

    @property
    def radius(self) -> float:
        return self[2]


def find_direction(terrain: vtkImageData, time: str) -> SunPosition:
    light = vtkSkylineSunLight()
    light.UseTimeOn()
    light.SetTime(time)
    found, eclipse = [0.0, 0.0, 0.0], [0.0, 0.0]
    with reported(light):
        light.FindDirection(terrain, found)
        light.FindEclipse(terrain, eclipse)
    position = SunPosition(found)
    position.magnitude, position.obscuration = eclipse
    return position
