// SPDX-License-Identifier: BSD-3-Clause
// Reading terrain and writing results.
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

/// The heights, with their georeference in field data. Throws Failure as the reader words it.
/// With `output`, throws Failure too if that is a file that the heights were read from.
vtkSmartPointer<vtkImageData> ReadTerrain(
  const TerrainOptions& options, const Talk& talk, const std::string& output = "");

/// The middle of a height field.
struct Center
{
  Georeference Place;
  double Height = 0.0; ///< metres, of the post with a height nearest to the middle; 0: none is near
  double Longitude = 0.0, Latitude = 0.0; ///< degrees; 0 without a CRS
};
/// The post with a height is looked for up to 512 posts away; a warning where there is none.
Center CenterOf(vtkImageData* terrain, const Talk& talk);

/// The same, reading no more of the file than is needed: the middle, and more where that is missing.
Center ReadCenter(const TerrainOptions& options, const Talk& talk);

/// Before any work: throws Failure if `output` cannot become a file, or is part of an input.
void CheckOutput(const std::string& output, const std::vector<std::string>& inputs);

/// The same for a raster, whose name ends in .tif or has no extension: else WrongUsage.
void CheckRasterOutput(const std::string& output, const std::vector<std::string>& inputs);

/// Writes point arrays of an updated algorithm's output as the bands of a GeoTIFF. Throws Failure,
/// and leaves no file, if that fails.
void WriteRaster(vtkAlgorithm* source, const std::vector<std::string>& arrays,
  const OutputOptions& options, const Talk& talk);

/// Kinds of picture files.
enum class PictureFormat
{
  Png,
  Exr,
  Tiff
};

/// By the file's name; throws WrongUsage for another one.
PictureFormat FormatOf(const std::string& file);

/// Writes the picture that vtkHeightFieldShading made: Radiance as EXR, Picture as PNG or GeoTIFF.
void WritePicture(
  vtkAlgorithm* source, PictureFormat format, const OutputOptions& options, const Talk& talk);

} // namespace skyline

#endif
