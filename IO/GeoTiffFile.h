// SPDX-License-Identifier: BSD-3-Clause
// Bands of an image to a GeoTIFF: the writer without the pipeline.
#ifndef skyline_GeoTiffFile_h
#define skyline_GeoTiffFile_h

#include "Geo/Georeference.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

class AtomicFile;

/// One component of an array.
struct BandSource
{
  vtkDataArray* Array = nullptr;
  int Component = 0;
  std::string Description;
  std::string Unit;
};

/// All that goes into the file.
struct GeoTiffContent
{
  int Columns = 0, Rows = 0; ///< arrays hold the rows from the south
  std::vector<BandSource> Bands;
  Georeference Place;
  bool HasNodata = false; ///< the input declared `Nodata`
  double Nodata = 0.0;
  bool CloudOptimized = false;
  bool Picture = false; ///< three bands are red, green, blue, a fourth alpha
};

/// Size and field data of an image, without bands. Throws std::invalid_argument where the
/// georeference is another image's.
GeoTiffContent ContentOf(vtkImageData* image);

/// Writes and closes `file.GetPath()`. `report` gets the part done and may throw. Throws IoFailure.
void WriteGeoTiff(
  const GeoTiffContent& content, const AtomicFile& file, const std::function<void(double)>& report);

} // namespace skyline

#endif
