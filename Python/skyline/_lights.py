# SPDX-License-Identifier: BSD-3-Clause
"""Turns lights in the form of arguments into light objects."""

from __future__ import annotations

import math
import os
from typing import Any, Iterable

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData

from . import _check, _warnings
from ._images import _numeric, _to_vtk
from ._run import Error, reported, run
from .SkylineFilters import (
    vtkSkylineEnvironmentLight,
    vtkSkylineKeyLight,
    vtkSkylineLampLight,
    vtkSkylineLight,
    vtkSkylineSunLight,
)
from .SkylineIO import vtkSkylineLightMapReader

_SKIES = "'uniform', 'cie:1' to 'cie:16', 'perez:DIRECT,DIFFUSE' in W/m2, a file's name or a light map"


def environment_light(environment: Any, rotation: Any, sun: Any) -> vtkSkylineEnvironmentLight:
    """The environment of irradiance(); `sun` is (azimuth, elevation) or None."""
    light = vtkSkylineEnvironmentLight()
    light.SetRotation(math.fmod(_check.number("rotation", rotation, "degrees"), 360.0))
    if isinstance(environment, (str, os.PathLike)):
        _set_sky(light, _check.file_name("environment", environment), sun)
    elif isinstance(environment, vtkImageData):
        light.SetImage(environment)
    else:
        light.SetImage(_light_map(environment))
    if rotation != 0.0 and light.IsSameAllAround():
        raise ValueError(
            f"rotation is {rotation:g}, but this sky is the same all around; "
            "leave it out, or give a light map")
    return light


def _set_sky(light: vtkSkylineEnvironmentLight, name: str, sun: Any) -> None:
    """Sets a sky given as text, or the light map of a file."""
    try:
        with reported(light):
            by_formula = light.SetSky(name)
    except Error:
        raise ValueError(f"environment is {name!r}; give {_SKIES}") from None
    if not by_formula:
        reader = vtkSkylineLightMapReader()
        reader.SetFileName(name)
        run(reader)
        light.SetImage(reader.GetOutput())
    elif sun is not None:
        light.SetSunAzimuth(sun[0])
        light.SetSunElevation(sun[1])
    elif light.GetSource() == light.PEREZ:
        raise ValueError(
            f"environment is {name!r}, which needs a sun; give sun=(azimuth, elevation) or time")
    elif not light.IsSameAllAround():
        _warnings.doubt(
            f"the sky {name} is brighter around the sun, and no sun is given",
            "its sun at azimuth 315, elevation 45", "sun=(azimuth, elevation)")


def _light_map(pixels: Any) -> vtkImageData:
    """An image of a light map (rows, 2 rows, 3): row 0 is the zenith, the centre column north."""
    values = _numeric("environment", pixels)
    rows, columns = values.shape[:2] if values.ndim == 3 else (0, 0)
    if rows < 1 or columns != 2 * rows or values.shape[2] != 3:
        raise ValueError(
            f"environment has the shape {values.shape}; give (rows, 2 rows, 3), linear RGB, the top "
            "row the zenith")
    wrong = values[~(np.isfinite(values) & (values >= 0))]
    if wrong.size:
        raise ValueError(
            f"environment holds {wrong[0]:g}; give linear RGB, finite and 0 or more, "
            "for instance np.nan_to_num(environment.clip(0))")
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    radiance = _to_vtk(values[::-1].astype(np.float32))
    radiance.SetName("Radiance")
    image.GetPointData().SetScalars(radiance)
    return image


def place_sun(light: vtkSkylineSunLight, sun: Any, time: Any) -> None:
    """Sets the position of a sun: `sun`, which is (azimuth, elevation), or `time`."""
    if (sun is None) == (time is None):
        raise TypeError("give sun=(azimuth, elevation), or time, and not both")
    if time is not None:
        light.UseTimeOn()
        light.SetTime(_check.moment(time))
    else:
        azimuth, elevation = _check.direction("sun", sun)
        light.SetAzimuth(azimuth)
        light.SetElevation(elevation)


def sun_light(direction: list[float], irradiance: Any, radius: Any) -> vtkSkylineLight:
    """The sun in a direction. A wide disc becomes a key light of the same irradiance."""
    rgb = _check.color("sun_irradiance", irradiance)
    light: Any = vtkSkylineSunLight()
    width = check_radius(light.GetAngularRadius() if radius is None else radius)
    if width > light.GetLargestRadius():
        light = vtkSkylineKeyLight()
        light.SetRadiance(*(part / (math.pi * math.sin(math.radians(width)) ** 2) for part in rgb))
    else:
        light.SetIrradiance(*rgb)
    light.SetAzimuth(direction[0])
    light.SetElevation(direction[1])
    light.SetAngularRadius(width)
    return light


def sun_of_time(time: Any, irradiance: Any, radius: Any) -> vtkSkylineSunLight:
    """The sun at a time over each post."""
    light = vtkSkylineSunLight()
    place_sun(light, None, time)
    light.SetIrradiance(*_check.color("sun_irradiance", irradiance))
    if radius is not None:
        largest = light.GetLargestRadius()
        light.SetTrueRadius(False)
        light.SetAngularRadius(_check.number(
            "radius", radius, f"0 to {largest:g} degrees with time", lambda r: 0.0 <= r <= largest))
    return light


def check_radius(radius: Any) -> float:
    return _check.number("radius", radius, "0 to below 90 degrees", lambda r: 0.0 <= r < 90.0)


def lamp_lights(lamps: Any, terrain: vtkImageData) -> Iterable[vtkSkylineLampLight]:
    """Lamps from (x, y, z, radius) or (x, y, z, radius, red, green, blue)."""
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
        light.SetMapPosition(terrain, *given[:3])
        light.SetRadius(given[3])
        if count == 7:
            light.SetRadiance(*_check.color(name + "[4:]", given[4:]))
        yield light


class SunPosition(tuple[float, float, float]):
    """(azimuth, elevation, radius) in degrees, also as attributes, and the eclipse at that time.

    magnitude
        The part of the sun's diameter that the Moon covers; in a total or annular eclipse, the
        ratio of the two diameters. 0 without an eclipse.
    obscuration
        The share of the area of the disc that the Moon covers, 0 to 1.
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
    place_sun(light, None, time)
    found, eclipse = [0.0, 0.0, 0.0], [0.0, 0.0]
    with reported(light):
        light.FindDirection(terrain, found)
        light.FindEclipse(terrain, eclipse)
    position = SunPosition(found)
    position.magnitude, position.obscuration = eclipse
    return position
