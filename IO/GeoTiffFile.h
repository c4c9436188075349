// SPDX-License-Identifier: BSD-3-Clause
// Writes bands of an image to a GeoTIFF: the code of the writer that does not depend on VTK's
// pipeline.
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

/// One component of an array, written as one band.
struct BandSource
{
  vtkDataArray* Array = nullptr;
  int Component = 0;
  std::string Description;
  std::string Unit;
};

/// The complete content of the file.
struct GeoTiffContent
{
  int Columns = 0, Rows = 0; ///< row 0 of the arrays is the southern one
  std::vector<BandSource> Bands;
  Georeference Place;
  bool HasNodata = false; ///< true if the input declares `Nodata`
  double Nodata = 0.0;
  bool CloudOptimized = false;
  bool Picture = false; ///< the bands are red, green, blue and possibly alpha
};

/// The size and the field data of an image, without bands. Throws std::invalid_argument if the
/// georeference belongs to an image of another size.
GeoTiffContent ContentOf(vtkImageData* image);

/// Writes `file.GetPath()` and closes it. `report` receives the completed part (0 to 1) and may
/// throw. Throws IoFailure.
void WriteGeoTiff(
  const GeoTiffContent& content, const AtomicFile& file, const std::function<void(double)>& report);

} // namespace skyline

#endif
