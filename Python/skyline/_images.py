# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of numpy arrays to height fields of VTK and back; reading and writing of rasters."""

from __future__ import annotations

import os
from typing import Any, Iterable, Literal, Sequence, Union
from xml.sax.saxutils import escape

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData

from . import _check
from ._run import Error, reported, run
from .SkylineFilters import vtkHeightFieldInspection
from .SkylineIO import vtkHeightFieldPictureWriter, vtkHeightFieldReader, vtkHeightFieldWriter

FileName = Union[str, "os.PathLike[str]"]
Row0 = Literal["north", "south"]
Spacing = Union[float, Sequence[float]]
Nodata = Union[float, Sequence[float], None]


def to_image(
    z: ArrayLike,
    spacing: Spacing | None = None,
    *,
    row0: Row0 = "north",
    crs: Any = None,
    transform: Any = None,
    nodata: Nodata = None,
) -> vtkImageData:
    """Make a height field from an array. Row 0 of z is its NORTH edge, as in rasterio and GDAL.

    Parameters
    ----------
    z : array (rows, columns)
        Heights in metres, integers or floats, at least 2 x 2 posts. Column 0 is the west edge. NaN,
        infinite and masked posts are missing.
    spacing : float or (float, float)
        Metres between columns and between rows: one number, or (dx, dy), above 0. Leave it out if a
        transform is given.
    row0 : str
        "north" (default) or "south": the edge at which row 0 of z lies.
    crs : str, int or object
        "EPSG:25830", WKT, an EPSG number, or a CRS object of rasterio or pyproj. It is needed for
        curvature, refraction, true north and the sun at a time. It needs a transform.
    transform : Affine or six floats
        The transform of rasterio, or the six numbers of GDAL's GetGeoTransform, in units of the
        CRS.
    nodata : float, or list of float
        The value or values in z that mark missing posts.

    Returns
    -------
    vtkImageData
        The heights are its point scalars "Elevation". Its row 0 is the south edge. It shares the
        memory of z if row0 is "south", z is contiguous, and no post is missing by mask or nodata;
        otherwise it holds a copy.

    Raises
    ------
    TypeError, ValueError
        An argument is wrong. The message names the value, and says what to give instead.
    skyline.Error
        The place cannot be used.

    Examples
    --------
    >>> image = to_image([[3, 4], [1, 2]], 10.0)  # 1 and 2 are in the south
    >>> image.GetDimensions(), image.GetSpacing()
    ((2, 2, 1), (10.0, 10.0, 1.0))
    >>> [image.GetScalarComponentAsDouble(x, 0, 0, 0) for x in (0, 1)]
    [1.0, 2.0]
    """
    missing = _missing(nodata)
    heights = _heights(z, missing)
    south = bool(_check.choice("row0", row0, ("north", "south")))
    rows, columns = heights.shape
    if transform is None:
        if crs is not None:
            raise ValueError(f"crs is {_check.short(crs)} without a transform; give transform= too")
        image = vtkImageData()
        image.SetDimensions(columns, rows, 1)
        image.SetSpacing(*_metres(spacing), 1.0)
    elif spacing is not None:
        raise ValueError(f"spacing is {_check.short(spacing)}, but the transform gives it; leave spacing out")
    else:
        image = _place(rows, columns, crs, _six(transform, rows, south))
    array = _to_vtk(heights if south else heights[::-1])
    array.SetName("Elevation")
    image.GetPointData().SetScalars(array)
    finite = [value for value in missing if np.isfinite(value)]
    if finite:
        _store(image, "NodataValue", finite[:1])
    inspection = vtkHeightFieldInspection()
    with reported(inspection):
        inspection.Inspect(image, "the array")
    return image


def to_array(
    image: vtkImageData, name: str | None = None, *, row0: Row0 = "north"
) -> NDArray[Any]:
    """Return a point array of an image as a numpy array. Row 0 is the NORTH edge (see row0).

    Parameters
    ----------
    image : vtkImageData
        An image with one slice.
    name : str
        Name of the point array. Default: the active scalars.
    row0 : str
        "north" (default), or "south" for the row order of VTK.

    Returns
    -------
    array (rows, columns) or (rows, columns, components)
        A view of the memory of the image, never a copy.

    Raises
    ------
    TypeError, ValueError
        An argument is wrong, or there is no such array.

    Examples
    --------
    >>> to_array(to_image([[3, 4], [1, 2]], 10.0))
    array([[3, 4],
           [1, 2]])
    """
    south = bool(_check.choice("row0", row0, ("north", "south")))
    if not isinstance(image, vtkImageData):
        raise TypeError(f"image is {_check.short(image)}; give a vtkImageData")
    points = image.GetPointData()
    array = points.GetScalars() if name is None else points.GetArray(name)
    if array is None:
        raise ValueError(f"the image has no {_quoted(name)}; it has {_names(image)}")
    columns, rows, slices = image.GetDimensions()
    if slices != 1:
        raise ValueError(f"the image has {slices} slices; give one with a single slice")
    values: NDArray[Any] = vtk_to_numpy(array)
    values = values.reshape((rows, columns) + values.shape[1:])
    return values if south else values[::-1]


def read(
    file: FileName,
    band: int = 1,
    *,
    nodata: Nodata = None,
    allow_network: bool = False,
    allow_elsewhere: bool = False,
    drivers: Sequence[str] = (),
) -> vtkImageData:
    """Read a raster as a height field. Row 0 of to_array(image) is the NORTH edge.

    Parameters
    ----------
    file : file name
        A raster that GDAL can open.
    band : int
        Band of the raster, from 1 (default).
    nodata : float, or list of float
        Values of missing posts besides the nodata value that the file declares, as they are in the
        file, before its scale and unit.
    allow_network : bool
        True allows a file on a server, or one that refers to a server. Default False.
    allow_elsewhere : bool
        True allows a file that refers to files outside its own folder. Default False.
    drivers : list of str
        Short names of GDAL drivers that may open the file, besides those of local rasters.

    Returns
    -------
    vtkImageData
        The heights in metres are its point scalars "Elevation"; its field data have the
        georeference.

    Raises
    ------
    TypeError, ValueError
        An argument is wrong.
    skyline.Error
        The file cannot be read. The message names the file.

    Examples
    --------
    >>> image = read("Testing/Data/dem/SainteHelens.tif")
    >>> to_array(image).shape
    (468, 327)
    """
    reader = vtkHeightFieldReader()
    reader.SetFileName(_check.file_name("file", file))
    reader.SetBand(_check.whole("band", band, 1, 2**31 - 1))
    for value in _missing(nodata):
        reader.AddNodata(value)
    reader.SetAllowNetwork(_check.flag("allow_network", allow_network))
    reader.SetAllowElsewhere(_check.flag("allow_elsewhere", allow_elsewhere))
    for name in _check.texts("drivers", drivers, "a list of GDAL's short names, such as ['WMS']"):
        reader.AddDriver(name)
    run(reader)
    return reader.GetOutput()


def write(
    file: FileName,
    values: ArrayLike | vtkImageData,
    like: FileName | vtkImageData | None = None,
    *,
    names: str | Iterable[str] | None = None,
    spacing: Spacing | None = None,
    row0: Row0 = "north",
    crs: Any = None,
    transform: Any = None,
    nodata: float | None = None,
) -> None:
    """Write an array as a raster or a picture. Row 0 of the array is the NORTH edge (see row0).

    Parameters
    ----------
    file : file name
        A GeoTIFF (.tif); or a picture of 1, 3 or 4 bands, which needs no place: .png (unsigned 8
        bits) or .exr (floats). If writing fails, no file is left.
    values : array (rows, columns) or (rows, columns, bands), or vtkImageData
        The values. Of an image, the point arrays `names` become bands (default: the active
        scalars).
    like : file name or vtkImageData
        A raster or an image with as many posts, which gives the place. Without it, give spacing, or
        transform and crs.
    names : str or list of str
        Names of the bands of an array, or of the point arrays of an image.
    spacing, row0, crs, transform
        See skyline.to_image.
    nodata : float
        The value for missing posts in the file.

    Raises
    ------
    TypeError, ValueError
        An argument is wrong. The message names the value, and says what to give instead.
    skyline.Error
        The file cannot be written.

    Examples
    --------
    >>> import tempfile
    >>> sky = np.linspace(0.0, 1.0, 6, dtype=np.float32).reshape(2, 3)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write(folder + "/sky.tif", sky, spacing=30.0, names="sky view")
    ...     np.array_equal(to_array(read(folder + "/sky.tif")), sky)
    True
    """
    file = _check.file_name("file", file)
    listed = [names] if isinstance(names, str) else list(names or [])
    picture = file.lower().endswith((".png", ".exr"))
    if isinstance(values, vtkImageData):
        image = values
    else:
        if picture and like is None and spacing is None and transform is None:
            spacing = 1.0
        image = _grid(values, like, spacing, row0, crs, transform)
        if nodata is not None:
            _store(image, "NodataValue", [_check.number("nodata", nodata, "a number")])
    if picture:
        writer = vtkHeightFieldPictureWriter()
        if image is values and listed:
            writer.SetArrayName(listed[0])
    else:
        writer = vtkHeightFieldWriter()
        if image is values:
            for name in listed:
                writer.AddArray(name)
        else:
            _name_bands(writer, listed, image.GetPointData().GetScalars().GetNumberOfComponents())
    writer.SetFileName(file)
    writer.SetInputData(image)
    run(writer, writer.Write)


def _grid(
    values: Any, like: Any, spacing: Any, row0: Row0, crs: Any, transform: Any
) -> vtkImageData:
    """An image with the values as its point scalars."""
    south = bool(_check.choice("row0", row0, ("north", "south")))
    grid = _numeric("values", values)
    if grid.ndim not in (2, 3) or 0 in grid.shape:
        raise ValueError(
            f"values has the shape {grid.shape}; give (rows, columns) or (rows, columns, bands)")
    if like is None:
        flat = np.zeros(grid.shape[:2], np.int8)
        place = to_image(flat, spacing, row0=row0, crs=crs, transform=transform)
    elif spacing is None and crs is None and transform is None:
        place = like if isinstance(like, vtkImageData) else read(like)
    else:
        raise ValueError("like gives the place already; leave out spacing, crs and transform")
    columns, rows, _ = place.GetDimensions()
    if grid.shape[:2] != (rows, columns):
        raise ValueError(
            f"values has the shape {grid.shape}, but its place has {rows} rows and {columns} "
            "columns; give an array with the same posts")
    image = vtkImageData()
    image.CopyStructure(place)
    image.GetFieldData().ShallowCopy(place.GetFieldData())
    array = _to_vtk(grid if south else grid[::-1])
    array.SetName("Values")
    image.GetPointData().SetScalars(array)
    return image


def _name_bands(writer: vtkHeightFieldWriter, names: list[str], bands: int) -> None:
    if names and len(names) != bands:
        raise ValueError(f"names has {len(names)} entries for {bands} bands; give one per band")
    for band, name in enumerate(names, 1):
        writer.SetBandDescription(band, name)


def _quoted(name: str | None) -> str:
    return "active point scalars" if name is None else f"point array {name!r}"


def _names(image: vtkImageData) -> str:
    points = image.GetPointData()
    names = [points.GetArrayName(i) for i in range(points.GetNumberOfArrays())]
    return ", ".join(repr(name) for name in names) or "no point arrays"


def _numeric(name: str, values: Any) -> NDArray[Any]:
    """`values` as an array of integers or floats in the byte order of this machine."""
    try:
        array = values if isinstance(values, np.ma.MaskedArray) else np.asarray(values)
    except ValueError:
        raise ValueError(f"{name} has rows of different lengths; give (rows, columns)") from None
    if array.dtype.kind not in "iuf":
        raise TypeError(
            f"{name} has the type {array.dtype}; give integers or floats, "
            f"for instance {name}.astype(float)")
    if array.dtype.itemsize == 2 and array.dtype.kind == "f":
        return array.astype(np.float32)
    if array.dtype.itemsize > 8:
        return array.astype(np.float64)
    return array.astype(array.dtype.newbyteorder("="), copy=False)


def _missing(nodata: Any) -> list[float]:
    """`nodata` as a list of the values of missing posts."""
    values = [] if nodata is None else [nodata] if np.ndim(nodata) == 0 else list(nodata)
    for value in values:
        if np.ndim(value) != 0 or isinstance(value, (str, bytes, bool)):
            raise TypeError(f"nodata is {_check.short(nodata)}; give a number, or several")
    return [float(value) for value in values]


def _heights(z: Any, nodata: list[float]) -> NDArray[Any]:
    """`z` as an array of heights, with NaN for missing posts."""
    array = _numeric("z", z)
    if array.ndim != 2 or min(array.shape) < 2:
        raise ValueError(f"z has the shape {array.shape}; give (rows, columns), at least 2 x 2")
    masks: Any = np.ma  # some of its functions have no type hints
    missing = masks.getmaskarray(array) if isinstance(array, np.ma.MaskedArray) else None
    array = np.asarray(array)
    for value in nodata:
        # Compares with the precision of the array, which may have read the value from a file.
        with np.errstate(over="ignore"):
            absent = array == (np.float32(value) if array.dtype == np.float32 else value)
        missing = absent if missing is None else missing | absent
    if missing is not None and missing.any():
        small = array.dtype.itemsize <= 2 or array.dtype == np.float32
        array = array.astype(np.float32 if small else np.float64)
        array[missing] = np.nan
    return array


def _metres(spacing: Any) -> list[float]:
    wanted = "metres between posts above 0: one number, or (dx, dy)"
    if spacing is None:
        raise TypeError(f"spacing is missing; give {wanted}")
    pair = [spacing] * 2 if np.ndim(spacing) == 0 else _check.numbers("spacing", spacing, 2, wanted)
    return [_check.number("spacing", step, wanted, lambda step: step > 0.0) for step in pair]


def _six(transform: Any, rows: int, south: bool) -> list[float]:
    """`transform` as the six numbers of GDAL for the raster with row 0 in the north."""
    wanted = "rasterio's transform or the six numbers of GDAL's GetGeoTransform"
    if all(hasattr(transform, part) for part in "abcdef"):  # that of rasterio
        six = [float(getattr(transform, part)) for part in "cabfde"]
    else:
        six = _check.numbers("transform", transform, 6, wanted)
    _, dx, shear, _, turn, dy = six
    if not np.isfinite(six).all() or shear != 0.0 or turn != 0.0 or dx <= 0.0 or dy == 0.0:
        raise ValueError(
            f"transform is {tuple(six)} in GDAL's order (x0, dx, 0, y0, 0, dy); give {wanted}, "
            "without rotation, with columns from west to east")
    if (dy > 0.0) != south:
        order, other = ("south", "north") if dy > 0.0 else ("north", "south")
        raise ValueError(
            f"row0 is {other!r}, but the transform's row step is {dy:g}: row 0 is the {order}ern row; "
            f"give row0={order!r} and the array in that order")
    if south:
        six[3] += dy * rows
        six[5] = -dy
    return six


def _crs_text(crs: Any) -> str:
    if crs is None:
        return ""
    if hasattr(crs, "to_wkt"):
        return str(crs.to_wkt())
    if isinstance(crs, int) and not isinstance(crs, bool):
        return f"EPSG:{crs}"
    if not isinstance(crs, str) or not crs.strip() or any(c < " " and c not in "\t\n\r" for c in crs):
        raise TypeError(f"crs is {_check.short(crs)}; give 'EPSG:25830', WKT, or an EPSG number")
    return crs


def _place(rows: int, columns: int, crs: Any, six: list[float]) -> vtkImageData:
    """An image with the place that the reader gives to a raster with that transform and CRS."""
    text = _crs_text(crs)
    raster = "<VRTDataset rasterXSize='%d' rasterYSize='%d'><SRS>%s</SRS><GeoTransform>%s" % (
        columns, rows, escape(text), ",".join(repr(part) for part in six))
    raster += "</GeoTransform><VRTRasterBand dataType='Byte' band='1'/></VRTDataset>"
    reader = vtkHeightFieldReader()
    reader.SetFileName(raster)
    try:
        run(reader)
    except Error as reason:
        said = str(reason).replace(f"'{raster}'", "the array").replace(raster, "the array")
        if "GDAL could not read all of it" in said or "that its SRS declares" in said:
            raise ValueError(f"crs is {_check.short(crs)}, which names no coordinate system that PROJ knows; "
                             "give 'EPSG:25830', WKT, or an EPSG number") from None
        raise Error(f"{said} (crs {_check.short(crs)}, transform {tuple(six)})") from None
    found = reader.GetOutput()
    if text and found.GetFieldData().GetAbstractArray("CRS") is None:
        raise ValueError(f"crs is {_check.short(crs)}, which names no coordinate system; "
                         "give 'EPSG:25830', WKT, or an EPSG number")
    image = vtkImageData()
    image.CopyStructure(found)
    image.GetFieldData().ShallowCopy(found.GetFieldData())
    return image


def _store(data: vtkDataObject, name: str, values: list[float]) -> None:
    array = vtkDoubleArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    data.GetFieldData().AddArray(array)


def _to_vtk(values: NDArray[Any]) -> Any:
    """A VTK array with one tuple per post; shares the memory of `values` where possible."""
    flat = values.reshape((-1,) + values.shape[2:])
    if not flat.flags.writeable or not flat.flags.c_contiguous:
        flat = flat.copy()
    return numpy_to_vtk(flat)
