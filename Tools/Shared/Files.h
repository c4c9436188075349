// SPDX-License-Identifier: BSD-3-Clause
// Reads terrain and writes results.
#ifndef skyline_Files_h
#define skyline_Files_h

#include "Geo/Georeference.h"
#include "Options.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Reads the heights, with their georeference in the field data. Throws Failure with the message of
/// the reader; also if `output` is given and is a file that the heights were read from.
vtkSmartPointer<vtkImageData> ReadTerrain(
  const TerrainOptions& options, const CommonOptions& common, const std::string& output = "");

/// The middle of a height field.
struct Center
{
  Georeference Place;
  double Height = 0.0; ///< metres, of the nearest post with a height; 0 if none is near
  double Longitude = 0.0, Latitude = 0.0; ///< degrees; 0 without a CRS
};
/// Finds the middle. A post with a height is searched up to 512 posts away; a warning if there is
/// none.
Center CenterOf(vtkImageData* terrain, const CommonOptions& common);

/// The same, but reads only as much of the file as is needed: the middle, and more if that is
/// missing.
Center ReadCenter(const TerrainOptions& options, const CommonOptions& common);

/// Throws Failure if `output` cannot become a file or is part of an input. To be called before any
/// work.
void CheckOutput(const std::string& output, const std::vector<std::string>& inputs);

/// The same for a raster. Throws WrongUsage unless its name ends in .tif or has no extension.
void CheckRasterOutput(const std::string& output, const std::vector<std::string>& inputs);

/// Writes point arrays of the output of an updated algorithm as bands of a GeoTIFF. Throws Failure
/// if that fails; then no file is left.
void WriteRaster(vtkAlgorithm* source, const std::vector<std::string>& arrays,
  const OutputOptions& options, const CommonOptions& common);

/// Formats of picture files.
enum class PictureFormat
{
  Png,
  Exr,
  Tiff
};

/// The format by the name of the file. Throws WrongUsage for other names.
PictureFormat FormatOf(const std::string& file);

/// Writes the picture of vtkHeightFieldShading: Radiance as EXR, Picture as PNG or GeoTIFF.
void WritePicture(vtkAlgorithm* source, PictureFormat format, const OutputOptions& options,
  const CommonOptions& common);

} // namespace skyline

#endif
