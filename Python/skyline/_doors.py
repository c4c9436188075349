# SPDX-License-Identifier: BSD-3-Clause
"""Arrays in, arrays out: one function a quantity."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Iterable, Literal, Sequence, TypedDict, Union, Unpack, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData

from . import _check, _lights, _warnings
from ._images import FileName, Nodata, Row0, Spacing, _names, _quoted, read, to_array, to_image
from ._run import run
from .SkylineFilters import (
    vtkHeightFieldAlgorithm,
    vtkHeightFieldHorizon,
    vtkHeightFieldIrradiance,
    vtkHeightFieldSkyView,
    vtkHeightFieldSunShadow,
    vtkHeightFieldShadowHeight,
    vtkSkylineLight,
)

Names = Union[list[str], tuple[str, ...]]
Sun = Sequence[float]
Floats = NDArray[np.float32]
Heights = Union[ArrayLike, FileName]

_METHODS = ("exact", "fast", "sweep", "pyramid")
_SURFACES = ("triangles", "bilinear")
_QUANTITIES = (
    "SkyViewFactor", "SkyViewFactorHorizontal", "VisibleSkyFraction", "PositiveOpenness", "EdgeTrust")


class Options(TypedDict, total=False):
    """What every function takes, by name.

    row0, crs, transform, nodata   as in to_image; of a file: nodata as in read, and no other
    scalars    name of an image's heights; default its active scalars
    method     "exact" (default), "fast" (below the horizon by 0.25 degrees at most, by how much depends
               on the processor), "sweep", "pyramid"
    surface    "triangles" (default) or "bilinear"
    flat       True leaves curvature and refraction out; default False
    allow_network, allow_elsewhere, drivers   of a file, as in read
    """

    row0: Row0
    crs: Any
    transform: Any
    nodata: Nodata
    scalars: str | None
    method: Literal["exact", "fast", "sweep", "pyramid"]
    surface: Literal["triangles", "bilinear"]
    flat: bool
    allow_network: bool
    allow_elsewhere: bool
    drivers: Sequence[str]


@dataclass
class _Terrain:
    """The image that a filter takes, and how its result goes back."""

    image: vtkImageData
    row0: Row0
    as_image: bool
    name: str
    method: int
    surface: int
    flat: bool

    def run(self, filter_: vtkHeightFieldAlgorithm) -> vtkImageData:
        filter_.SetInputData(self.image)
        filter_.SetInputArrayToProcess(
            0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, self.name)
        filter_.SetMethod(self.method)
        filter_.SetSurface(self.surface)
        filter_.SetFlat(self.flat)
        run(filter_)
        return filter_.GetOutput()

    def result(self, filter_: vtkHeightFieldAlgorithm, name: str) -> Any:
        output = self.run(filter_)
        return output if self.as_image else to_array(output, name, row0=self.row0)


def _terrain(
    z: Any,
    spacing: Any,
    row0: Row0 = "north",
    crs: Any = None,
    transform: Any = None,
    nodata: Nodata = None,
    scalars: str | None = None,
    method: str = "exact",
    surface: str = "triangles",
    flat: bool = False,
    allow_network: bool = False,
    allow_elsewhere: bool = False,
    drivers: Sequence[str] = (),
) -> _Terrain:
    as_image = isinstance(z, vtkImageData)
    placed = as_image or isinstance(z, (str, os.PathLike))
    if placed:
        given = {"spacing": spacing, "crs": crs, "transform": transform}
        if as_image:
            given["nodata"] = nodata
        for name, value in given.items():
            if value is not None:
                raise TypeError(f"{name} is given, but an image or a file has its own; leave it out")
        image = z if as_image else read(z, nodata=nodata, allow_network=allow_network,
                                        allow_elsewhere=allow_elsewhere, drivers=drivers)
        if not as_image:
            _check.choice("row0", row0, ("north", "south"))
    else:
        image = to_image(z, spacing, row0=row0, crs=crs, transform=transform, nodata=nodata)
    array = image.GetPointData().GetScalars() if scalars is None else (
        image.GetPointData().GetArray(scalars))
    if array is None:
        raise ValueError(
            f"the image has no {_quoted(scalars)}; name its heights by scalars=: {_names(image)}")
    if array.GetName() is None:
        copy = vtkImageData()  # the user's image keeps its nameless array
        copy.ShallowCopy(image)
        array = array.NewInstance()
        array.ShallowCopy(image.GetPointData().GetScalars())
        array.SetName("Elevation")
        copy.GetPointData().SetScalars(array)
        image = copy
    if method in ("sweep", "pyramid") and surface == "bilinear":
        raise ValueError(f"surface is 'bilinear', which {method!r} does not know; give method='exact' or 'fast'")
    return _Terrain(
        image, row0, as_image, array.GetName(), _check.choice("method", method, _METHODS),
        _check.choice("surface", surface, _SURFACES), _check.flag("flat", flat))


@overload
def horizon(z: Heights, spacing: Spacing | None = None, azimuths: int = 72,
            **options: Unpack[Options]) -> Floats: ...
@overload
def horizon(z: vtkImageData, spacing: None = None, azimuths: int = 72,
            **options: Unpack[Options]) -> vtkImageData: ...
def horizon(z: Any, spacing: Any = None, azimuths: int = 72, **options: Unpack[Options]) -> Any:
    """The horizon all around every post; z's row 0 is its NORTH edge, or its south one by row0="south".

    z          array (rows, columns) of heights, metres; the name of a raster file; or a vtkImageData
    spacing    metres between posts, one number or (dx, dy); none with a file, an image or a transform
    azimuths   how many, evenly spread; 1 to 3600
    options    row0, crs, transform, nodata, method, surface, flat: see skyline.Options

    Returns float32 (rows, columns, azimuths), rows as z has them: degrees above the horizontal plane,
    component k in azimuth 360 k / azimuths, clockwise from grid north (the grid's up); -90 where no
    terrain lies there, NaN at missing posts. For a vtkImageData, that image with the point array
    HorizonElevation. Raises TypeError, ValueError or skyline.Error, which name value and cure.

    A wall in the north, ten metres high and ten away:

    >>> z = [[10, 10, 10],
    ...      [0, 0, 0],
    ...      [0, 0, 0]]
    >>> horizon(z, 10.0, azimuths=4)[1, 1]
    array([45.,  0.,  0.,  0.], dtype=float32)
    """
    terrain = _terrain(z, spacing, **options)
    filter_ = vtkHeightFieldHorizon()
    filter_.SetNumberOfAzimuths(_check.whole("azimuths", azimuths, 1, 3600))
    return terrain.result(filter_, "HorizonElevation")


@overload
def sky_view(z: Heights, spacing: Spacing | None = None, azimuths: int = 72,
             quantity: str = ..., *, edge_distance: float | None = None,
             **options: Unpack[Options]) -> Floats: ...
@overload
def sky_view(z: Heights, spacing: Spacing | None = None, azimuths: int = 72, *, quantity: Names,
             edge_distance: float | None = None, **options: Unpack[Options]) -> dict[str, Floats]: ...
@overload
def sky_view(z: Heights, spacing: Spacing | None, azimuths: int, quantity: Names, *,
             edge_distance: float | None = None, **options: Unpack[Options]) -> dict[str, Floats]: ...
@overload
def sky_view(z: vtkImageData, spacing: None = None, azimuths: int = 72,
             quantity: str | Names = ..., *, edge_distance: float | None = None,
             **options: Unpack[Options]) -> vtkImageData: ...
def sky_view(
    z: Any, spacing: Any = None, azimuths: int = 72,
    quantity: str | Names = "SkyViewFactor", *, edge_distance: float | None = None,
    **options: Unpack[Options],
) -> Any:
    """How much sky every post sees; z's row 0 is its NORTH edge, or its south one by row0="south".

    z, spacing, azimuths, options   as in horizon
    quantity   "SkyViewFactor" (cosine-weighted, on the tilted surface, 0 to 1),
               "SkyViewFactorHorizontal" (the same on a level surface), "VisibleSkyFraction" (of the
               upper hemisphere's solid angle), "PositiveOpenness" (degrees), or "EdgeTrust" (the share
               of the azimuths in which the data reach at least edge_distance). Several, as a list, take
               one search.
    edge_distance   of EdgeTrust: metres, 0 (any terrain at all) or more; default 1000, or a tenth of the
               shorter side if that is less

    Beyond the data nothing is known: where no terrain lies the horizon is -90 degrees, so posts near the
    rim see too much (openness of level ground: 90, at an edge 135). Keep those with EdgeTrust 1.

    Returns float32 (rows, columns), rows as z has them, NaN at missing posts; for a list of quantities
    a dictionary of them. For a vtkImageData, that image with the point arrays of these names.

    >>> float(sky_view([[5, 5], [5, 5]], 30.0)[0, 0])  # level ground sees all of it
    1.0
    """
    terrain = _terrain(z, spacing, **options)
    if not isinstance(quantity, (str, list, tuple)):
        raise TypeError(
            f"quantity is {_check.short(quantity)}; give a name, or a list of {', '.join(_QUANTITIES)}")
    wanted = [quantity] if isinstance(quantity, str) else list(quantity)
    for name in wanted:
        _check.choice("quantity", name, _QUANTITIES)
    if not wanted:
        raise ValueError(f"quantity is empty; give one of {', '.join(_QUANTITIES)}")
    filter_ = vtkHeightFieldSkyView()
    filter_.SetNumberOfAzimuths(_check.whole("azimuths", azimuths, 1, 3600))
    for name in _QUANTITIES:
        getattr(filter_, "Set" + name)(name in wanted)
    if edge_distance is not None:
        if "EdgeTrust" not in wanted:
            raise ValueError('edge_distance is for the quantity "EdgeTrust"; ask for it too')
        filter_.AutoEdgeDistanceOff()
        filter_.SetEdgeDistance(_check.number(
            "edge_distance", edge_distance, "metres, 0 or more", lambda d: d >= 0.0))
    if terrain.as_image or isinstance(quantity, str):
        return terrain.result(filter_, wanted[0])
    output = terrain.run(filter_)
    return {name: to_array(output, name, row0=terrain.row0) for name in wanted}


@overload
def sun_visibility(z: Heights, spacing: Spacing | None = None, sun: Sun | None = None, *,
                   time: Any = None, radius: float | None = None, limb_darkening: bool = False,
                   **options: Unpack[Options]) -> Floats: ...
@overload
def sun_visibility(z: vtkImageData, spacing: None = None, sun: Sun | None = None, *, time: Any = None,
                   radius: float | None = None, limb_darkening: bool = False,
                   **options: Unpack[Options]) -> vtkImageData: ...
def sun_visibility(
    z: Any, spacing: Any = None, sun: Any = None, *, time: Any = None, radius: float | None = None,
    limb_darkening: bool = False, **options: Unpack[Options],
) -> Any:
    """The lit part of the sun's disc at every post; z's row 0 is its NORTH edge (else row0="south").

    z, spacing, options   as in horizon
    sun        (azimuth, elevation), degrees: clockwise from grid north, apparent elevation
    time       in place of `sun`: "2026-06-21T06:00Z" or as Python and pandas print it (without a zone:
               UTC, with a warning), a datetime with a zone, or numpy.datetime64 (UTC); 1900 to 2100. Needs a place: a file, an image from read, or crs and transform
    radius     of the disc, degrees, 0 (hard shadows) to below 90; default 0.26645, with time the true one
    limb_darkening   let the disc darken towards its limb

    Returns float32 (rows, columns), 0 (shadow) to 1, rows as z has them, NaN at missing posts. For a
    vtkImageData, that image with the point array SunVisibility.

    The sun in the west, beyond a wall in column 2, whose shadow is 84 m long:

    >>> z = np.zeros((3, 20))
    >>> z[:, 2] = 100.0
    >>> sun_visibility(z, 10.0, sun=(270.0, 50.0))[1, 8:13]
    array([0., 0., 0., 1., 1.], dtype=float32)
    """
    terrain = _terrain(z, spacing, **options)
    filter_ = vtkHeightFieldSunShadow()
    _lights.place_sun(filter_.GetSun(), sun, time)
    if radius is not None:
        filter_.SetTrueRadius(False)
        filter_.SetSunAngularRadius(_lights.check_radius(radius))
    if _check.flag("limb_darkening", limb_darkening) and radius == 0:
        raise ValueError("radius is 0, a point without a limb; leave limb_darkening out")
    filter_.SetLimbDarkening(limb_darkening)
    return terrain.result(filter_, "SunVisibility")


@overload
def shadow_height(z: Heights, spacing: Spacing | None = None, *, sun: Sun,
                  below_terrain: bool = False, **options: Unpack[Options]) -> Floats: ...
@overload
def shadow_height(z: Heights, spacing: Spacing | None = None, *, time: Any,
                  below_terrain: bool = False, **options: Unpack[Options]) -> Floats: ...
@overload
def shadow_height(z: vtkImageData, spacing: None = None, *, sun: Sun,
                  below_terrain: bool = False, **options: Unpack[Options]) -> vtkImageData: ...
@overload
def shadow_height(z: vtkImageData, spacing: None = None, *, time: Any,
                  below_terrain: bool = False, **options: Unpack[Options]) -> vtkImageData: ...
def shadow_height(
    z: Any, spacing: Any = None, *, sun: Any = None, time: Any = None, below_terrain: bool = False,
    **options: Unpack[Options],
) -> Any:
    """How high the terrain's shadow stands over every post; z's row 0 is its NORTH edge (else row0).

    z, spacing, options   as in horizon
    sun, time      as in sun_visibility; at a time, all posts have the sun over the middle
    below_terrain  tell also how far below the ground the shadow passes where the post is lit; else
                   there it is the post's own height

    Returns float32 (rows, columns), metres in the frame of the heights, rows as z has them; with
    the sun on or under the horizontal plane plus infinity, with a warning (write makes it nodata). For a vtkImageData, that image with ShadowHeight.

    >>> z = np.zeros((2, 6))
    >>> z[:, 0] = 30.0
    >>> shadow_height(z, 10.0, sun=(270.0, 45.0))[0]
    array([30., 20., 10.,  0.,  0.,  0.], dtype=float32)
    """
    terrain = _terrain(z, spacing, **options)
    if terrain.method == _METHODS.index("pyramid"):
        raise ValueError("method is 'pyramid', which has no shadow heights; give 'exact' or 'sweep'")
    if terrain.surface != 0:
        raise ValueError("surface is 'bilinear', which has no shadow heights; leave it out")
    filter_ = vtkHeightFieldShadowHeight()
    _lights.place_sun(filter_.GetSun(), sun, time)
    filter_.SetBelowTerrain(_check.flag("below_terrain", below_terrain))
    return terrain.result(filter_, "ShadowHeight")


@overload
def irradiance(z: Heights, spacing: Spacing | None = None, environment: Any = None, *,
               sun: Sun | None = None, time: Any = None, sun_irradiance: Any = None,
               radius: float | None = None, lamps: Iterable[Sequence[float]] = (),
               lights: Iterable[vtkSkylineLight] = (), rotation: float = 0.0, azimuths: int = 128,
               horizontal: bool = False, light_method: Literal["table", "sh"] = "table",
               **options: Unpack[Options]) -> Floats: ...
@overload
def irradiance(z: vtkImageData, spacing: None = None, environment: Any = None, *,
               sun: Sun | None = None, time: Any = None, sun_irradiance: Any = None,
               radius: float | None = None, lamps: Iterable[Sequence[float]] = (),
               lights: Iterable[vtkSkylineLight] = (), rotation: float = 0.0, azimuths: int = 128,
               horizontal: bool = False, light_method: Literal["table", "sh"] = "table",
               **options: Unpack[Options]) -> vtkImageData: ...
def irradiance(
    z: Any, spacing: Any = None, environment: Any = None, *, sun: Any = None, time: Any = None,
    sun_irradiance: Any = None, radius: float | None = None, lamps: Any = (), lights: Any = (),
    rotation: float = 0.0, azimuths: int = 128, horizontal: bool = False,
    light_method: str = "table", **options: Unpack[Options],
) -> Any:
    """The light that falls on every post; z's row 0 is its NORTH edge, or its south one by row0="south".

    z, spacing, options   as in horizon
    environment    the sky: "uniform" (radiance 1), "cie:1" to "cie:16" (radiance 1 in the zenith),
                   "perez:DIRECT,DIFFUSE" (W/m2; its sun, which must be given, shines too), a .hdr or .exr file, or a light map
                   (rows, 2 rows, 3): linear RGB, row 0 the zenith, the centre column north. Default
                   "uniform" if there is no other light
    sun, time      where the sun stands, as in sun_visibility; the sun of a sky too
    sun_irradiance on a plane that faces it, one number or RGB; default 1, with perez: DIRECT
    radius         of its disc, degrees, as in sun_visibility
    lamps          glowing balls (x, y, z, radius) or (x, y, z, radius, red, green, blue): x and y in the
                   CRS, without one metres from the south-west post; z and radius in metres; radiance 1
    lights         further vtkSkylineLight objects
    rotation       degrees by which a light map, or a sky that is brighter about its sun, is turned clockwise
    azimuths       evenly spread; more are added where a light map is bright
    horizontal     level receivers in place of the posts' own planes
    light_method   "table", or "sh": spherical harmonics, a blur

    Returns float32 (rows, columns, 3), linear RGB, rows as z has them, NaN at missing posts. For a
    vtkImageData, that image with the point array Irradiance.

    >>> float(irradiance([[5, 5], [5, 5]], 30.0, sun=(180.0, 30.0), sun_irradiance=800.0)[0, 0, 0])
    400.0
    """
    terrain = _terrain(z, spacing, **options)
    filter_ = vtkHeightFieldIrradiance()
    filter_.SetNumberOfAzimuths(_check.whole("azimuths", azimuths, 1, 3600))
    filter_.SetHorizontal(_check.flag("horizontal", horizontal))
    filter_.SetLightMethod(_check.choice("light_method", light_method, ("table", "sh")))
    lamps, lights = list(_lights.lamp_lights(lamps, terrain.image)), list(lights)
    for place, light in enumerate(lights):
        if not isinstance(light, vtkSkylineLight):
            raise TypeError(f"lights[{place}] is {_check.short(light)}; give a vtkSkylineLight")
    if sun is not None and time is not None:
        raise TypeError("give sun=(azimuth, elevation), or time, and not both")
    time = None if time is None else _check.moment(time)
    direction = None if sun is None else _check.direction("sun", sun)
    if time is not None:
        direction = list(sun_position(terrain.image, time)[:2])
    if environment is None and direction is None and not lamps and not lights:
        environment = "uniform"
    if environment is None and _check.number("rotation", rotation, "degrees") != 0.0:
        raise ValueError(f"rotation is {rotation:g}, but no light map is given; leave it out")
    if direction is None:
        for name, value in {"sun_irradiance": sun_irradiance, "radius": radius}.items():
            if value is not None:
                raise ValueError(f"{name} is given, but no sun shines; give sun or time")
    if environment is None and direction is None and not lights and light_method == "sh":
        raise ValueError("light_method is 'sh', which lamps do not use; leave it out")
    if environment is not None:
        sky = _lights.environment_light(environment, rotation, direction)
        filter_.AddLight(sky)
        if sky.GetSource() == sky.PEREZ:
            if sun_irradiance is None:
                sun_irradiance = sky.GetDirectIrradiance()
        if rotation != 0.0 and sky.GetSource() != sky.IMAGE and np.any(
                np.asarray(1.0 if sun_irradiance is None else sun_irradiance)):
            _warnings.doubt(
                f"rotation turns the sky {environment}, which is brighter about the sun, away from the sun",
                "a sky that does not belong to the sun")
    strength = 1.0 if sun_irradiance is None else sun_irradiance
    if time is not None:
        filter_.AddLight(_lights.sun_of_time(time, strength, radius))
    elif direction is not None:
        filter_.AddLight(_lights.sun_light(direction, strength, radius))
    for light in lamps + lights:
        filter_.AddLight(light)
    return terrain.result(filter_, "Irradiance")


def sun_position(
    place: FileName | vtkImageData, time: Any, *, nodata: Nodata = None
) -> _lights.SunPosition:
    """Where the sun stands over the middle of a raster: azimuth, elevation, angular radius; degrees.

    place   the name of a raster file with a CRS, or an image that read or to_image gave
    time    as in sun_visibility
    nodata  of a file, as in read

    The azimuth counts clockwise from grid north, the elevation is apparent (lifted by the air): what
    `sun` takes elsewhere. In an eclipse of the sun the tuple also says so, by its attributes magnitude
    (the covered part of the diameter) and obscuration (the share of the disc that the Moon covers, 0 to
    1), which are 0 at other times.

    >>> azimuth, elevation, radius = sun_position("Testing/Data/dem/SainteHelens.tif", "2026-06-21T20:00Z")
    >>> round(azimuth), round(elevation)
    (173, 67)
    """
    if isinstance(place, vtkImageData):
        if nodata is not None:
            raise TypeError("nodata is given, but an image has its own; leave it out")
        image = place
    else:
        image = read(place, nodata=nodata)
    return _lights.find_direction(image, _check.moment(time))
