# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the package: arrays in, arrays out, one function per quantity."""

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
    """Keyword arguments that all functions on heights accept.

    row0
        "north" (default) or "south": the edge at which row 0 of arrays lies.
    crs, transform, nodata
        See to_image. For a file only nodata, as in read; for an image none of them.
    scalars
        Name of the point array with the heights of an image. Default: its active scalars.
    method
        How horizons are found: "exact" (default); "fast", at most 0.25 degrees below the exact
        horizon (how much depends on the processor); "sweep"; or "pyramid".
    surface
        The surface between the posts: "triangles" (default) or "bilinear".
    flat
        True ignores curvature and refraction. Default False.
    allow_network, allow_elsewhere, drivers
        For a file; see read.
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
    """The image that a filter uses, and how its result is returned."""

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
            f"the image has no {_quoted(scalars)}; choose its heights by scalars=: {_names(image)}")
    if array.GetName() is None:
        copy = vtkImageData()  # the array in the user's image stays without a name
        copy.ShallowCopy(image)
        array = array.NewInstance()
        array.ShallowCopy(image.GetPointData().GetScalars())
        array.SetName("Elevation")
        copy.GetPointData().SetScalars(array)
        image = copy
    if method in ("sweep", "pyramid") and surface == "bilinear":
        raise ValueError(
            f"surface is 'bilinear', which the method {method!r} does not support; "
            "give method='exact' or 'fast'")
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
    """Compute the horizon around each post. Row 0 of z is its NORTH edge (see row0).

    Parameters
    ----------
    z : array (rows, columns), file name or vtkImageData
        Heights in metres, one per post; or the name of a raster file; or an image with heights.
    spacing : float or (float, float)
        Metres between posts: one number, or (dx, dy). Leave it out for a file, for an image, and if
        a transform is given.
    azimuths : int
        Number of evenly spaced azimuths, 1 to 3600. Default 72.
    **options
        row0, crs, transform, nodata, scalars, method, surface, flat and others: see
        skyline.Options.

    Returns
    -------
    float32 array (rows, columns, azimuths)
        The elevation angle of the horizon in degrees above the horizontal plane. Component k is
        that in the azimuth 360 k / azimuths, clockwise from grid north (up in the grid). It is -90
        where no terrain lies in the azimuth, and NaN at missing posts. Rows are in the order of z.
        For a vtkImageData the result is that image with the point array HorizonElevation.

    Raises
    ------
    TypeError, ValueError
        An argument is wrong. The message names the value, and says what to give instead.
    skyline.Error
        A file cannot be read, or the computation failed.

    Examples
    --------
    A wall in the north, 10 metres high and 10 metres away:

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
    """Compute how much of the sky each post sees. Row 0 of z is its NORTH edge (see row0).

    Parameters
    ----------
    z, spacing, azimuths, **options
        See skyline.horizon.
    quantity : str, or list of str
        "SkyViewFactor" (default): the cosine-weighted share of the sky, tilted surface, 0 to 1.
        "SkyViewFactorHorizontal": the same for a level surface.
        "VisibleSkyFraction": the share of the solid angle of the upper hemisphere, 0 to 1.
        "PositiveOpenness": the mean zenith angle of the horizon in degrees, 0 to 180.
        "EdgeTrust": the share of the azimuths in which the data reach edge_distance, 0 to 1.
        Several quantities in a list take only one search.
    edge_distance : float
        For EdgeTrust: metres, 0 (any terrain at all) or more. Default: 1000, or a tenth of the
        shorter side of the height field if that is less.

    Returns
    -------
    float32 array (rows, columns)
        NaN at missing posts; rows in the order of z. For a list of quantities, a dictionary from
        the names to such arrays. For a vtkImageData, that image with point arrays of these names.

    Raises
    ------
    TypeError, ValueError, skyline.Error
        See skyline.horizon.

    Notes
    -----
    Nothing is assumed beyond the edge of the data: where no terrain lies in a direction, the
    horizon is -90 degrees. Therefore posts near the edge see too much sky: on level ground
    PositiveOpenness is 90, but 135 at an edge. Use only posts with EdgeTrust 1.

    Examples
    --------
    >>> float(sky_view([[5, 5], [5, 5]], 30.0)[0, 0])  # level ground sees the whole sky
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
            raise ValueError('edge_distance is for the quantity "EdgeTrust" only; add that quantity')
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
    """Compute the visible part of the sun's disc. Row 0 of z is its NORTH edge (see row0).

    Parameters
    ----------
    z, spacing, **options
        See skyline.horizon.
    sun : (float, float)
        Azimuth of the sun in degrees clockwise from grid north, and its apparent elevation in
        degrees, -90 to 90. Give either sun or time.
    time : str, datetime or numpy.datetime64
        Time of the sun, in the years 1900 to 2100: text such as "2026-06-21T06:00Z" or as Python
        and pandas print it, a datetime with a time zone, or numpy.datetime64 (UTC). A text without
        a time zone is taken as UTC, with a warning. The heights need a place on the Earth: a file,
        an image from read, or crs and transform.
    radius : float
        Angular radius of the disc in degrees, 0 (hard shadows) to below 90. Default: the true
        radius with time, otherwise 0.26645.
    limb_darkening : bool
        Whether the disc is darker towards its edge. Default False.

    Returns
    -------
    float32 array (rows, columns)
        0 (in shadow) to 1; NaN at missing posts; rows in the order of z. For a vtkImageData, that
        image with the point array SunVisibility.

    Raises
    ------
    TypeError, ValueError, skyline.Error
        See skyline.horizon.

    Examples
    --------
    The sun in the west, behind a wall in column 2 whose shadow is 84 m long:

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
    """Compute how high the shadow of the terrain reaches. Row 0 of z is its NORTH edge (see row0).

    Parameters
    ----------
    z, spacing, **options
        See skyline.horizon. The method "pyramid" and the surface "bilinear" have no shadow heights.
    sun, time
        See skyline.sun_visibility. With time, all posts have the sun over the middle of the raster.
    below_terrain : bool
        If True, the result at lit posts is the height at which the shadow passes below the ground.
        If False (default), it is the height of the post.

    Returns
    -------
    float32 array (rows, columns)
        A point above the post is in shadow if it is lower than this height, in metres in the frame
        of the heights. Rows are in the order of z; NaN at missing posts. If the sun is not above
        the horizontal plane, all values are infinite, with a warning; write turns them into nodata.
        For a vtkImageData, that image with the point array ShadowHeight.

    Raises
    ------
    TypeError, ValueError, skyline.Error
        See skyline.horizon.

    Examples
    --------
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
    """Compute the light that falls on each post. Row 0 of z is its NORTH edge (see row0).

    Parameters
    ----------
    z, spacing, **options
        See skyline.horizon.
    environment : str, file name, array or vtkImageData
        The sky: "uniform" (radiance 1); "cie:1" to "cie:16" (radiance 1 at the zenith);
        "perez:DIRECT,DIFFUSE" (W/m2; its sun must be given and shines too); the name of a .hdr or
        .exr file; or a light map as an array (rows, 2 rows, 3) of linear RGB, with the zenith in
        row 0 and north in the centre column. Default: "uniform" if there is no other light,
        otherwise none.
    sun, time
        The position of the sun, also of the sun in the sky: see skyline.sun_visibility.
    sun_irradiance : float or (float, float, float)
        Irradiance of the sun on a plane that faces it, as one number or RGB. Default: 1; for perez,
        DIRECT.
    radius : float
        Angular radius of the sun: see skyline.sun_visibility.
    lamps : list of tuples
        Glowing balls (x, y, z, radius) or (x, y, z, radius, red, green, blue). x and y are in the
        CRS; without a CRS they are metres from the south-west post. z and radius are metres. The
        radiance is 1 by default.
    lights : list of vtkSkylineLight
        Further lights.
    rotation : float
        Degrees by which a light map, or a sky that is brighter around its sun, is turned clockwise.
        Default 0.
    azimuths : int
        Number of evenly spaced azimuths, 1 to 3600. More are added where a light map is bright.
        Default 128.
    horizontal : bool
        If True, the light on level receivers instead of on the tilted surface. Default False.
    light_method : str
        "table" (default), or "sh" for spherical harmonics, which blur the light.

    Returns
    -------
    float32 array (rows, columns, 3)
        Linear RGB; NaN at missing posts; rows in the order of z. For a vtkImageData, that image
        with the point array Irradiance.

    Raises
    ------
    TypeError, ValueError, skyline.Error
        See skyline.horizon.

    Examples
    --------
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
                raise ValueError(f"{name} is given, but no sun is given; give sun or time")
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
                f"rotation turns the sky {environment}, which is brighter around the sun, away from the sun",
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
    """Compute where the sun stands over the middle of a raster.

    Parameters
    ----------
    place : file name or vtkImageData
        The name of a raster file with a CRS, or an image from read or to_image.
    time : str, datetime or numpy.datetime64
        See skyline.sun_visibility.
    nodata : float, or list of float
        For a file; see skyline.read.

    Returns
    -------
    tuple (azimuth, elevation, radius)
        In degrees. The azimuth counts clockwise from grid north; the elevation is apparent, that is
        with refraction. Other functions accept them as `sun`. The attributes magnitude (the covered
        part of the sun's diameter) and obscuration (the covered share of the disc, 0 to 1) describe
        an eclipse of the sun; they are 0 at other times.

    Raises
    ------
    TypeError, ValueError, skyline.Error
        See skyline.horizon; also if the place has no CRS on the Earth.

    Examples
    --------
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
