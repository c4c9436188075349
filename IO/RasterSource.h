// SPDX-License-Identifier: BSD-3-Clause
// One band of a raster file as a lattice of heights: the code of the reader that does not depend on
// VTK's pipeline.
#ifndef skyline_RasterSource_h
#define skyline_RasterSource_h

#include "CoordinateSystem.h"
#include "GdalDataset.h"
#include "GdalErrors.h"
#include "Geo/Georeference.h"
#include "HeightField/HeightCensus.h"
#include "Shared/Doubt.h"
#include "SourceGuard.h"

#include <cpl_conv.h>
#include <gdal_priv.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace skyline
{

/// The posts [ColumnBegin, ColumnBegin + Columns) x [RowBegin, RowBegin + Rows), counted from the
/// south-west.
struct PostWindow
{
  int ColumnBegin = 0, RowBegin = 0;
  int Columns = 0, Rows = 0;
};

/// An open band. Each function throws IoFailure with a one-line reason that names the file.
class RasterSource
{
public:
  /// Opens `file` (any name that GDAL opens with the drivers of `policy`) and examines its band
  /// `band` (counted from 1). `furtherNodata`: values that mark missing posts in addition to the
  /// one that the file declares, as stored in the band (before scale and unit). `spooled`: the path
  /// of the copied bytes if the file is a pipe, else empty.
  RasterSource(const std::string& file, int band, const std::vector<double>& furtherNodata = {},
    const SourcePolicy& policy = {}, const std::string& spooled = "");

  PostWindow GetWhole() const { return { 0, 0, this->Columns, this->Rows }; }

  /// The VTK type of the heights: the type of the band if its integers are metres already, else
  /// float, or double if float would lose digits.
  int GetVtkType() const { return this->VtkType; }

  /// Distance between columns and between rows in metres, at the centre row if the rows differ.
  const std::array<double, 2>& GetSpacing() const { return this->Spacing; }

  /// The CRS coordinates of the south-west post in metres, on a projected or local map; else 0.
  const std::array<double, 2>& GetOrigin() const { return this->Origin; }

  /// The georeference of a part of the raster. Its row spacings are those of the whole raster.
  Georeference GetGeoreference(const PostWindow& window) const;

  /// The files that the raster is read from, according to GDAL.
  std::vector<std::string> GetFiles() const;

  bool HasNodata() const { return this->DeclaresNodata; }
  double GetNodata() const { return this->Nodata; }

  /// The doubts about the raster: those about its place and unit, and after Read those about its
  /// heights.
  const std::vector<Doubt>& GetDoubts() const { return this->Doubts; }

  /// A function that receives the completed part (0 to 1) and returns false to stop the reading.
  using ProgressFunction = std::function<bool(double)>;

  /// Reads the heights of a window into `heights`, an array of the type GetVtkType: metres, row 0
  /// in the south, NaN for missing posts. Throws IoAborted if `progress` returns false, and
  /// IoFailure if all posts of the raster are missing.
  void Read(const PostWindow& window, void* heights, const ProgressFunction& progress);

private:
  [[noreturn]] void Refuse(const std::string& reason) const;
  void Open(int band);
  void FailToOpen();
  void CheckCrs();
  void CheckComplaints();
  void CheckRefusal() const;
  void ReadTransform();
  void ReadPlace();
  void ReadValues();
  template <typename T>
  void ReadAs(const PostWindow& window, T* heights, const ProgressFunction& progress);
  void ReadStrip(int column, int row, int columns, int rows, void* heights, unsigned char* mask);
  template <typename T, typename Missing>
  bool Convert(T* heights, const unsigned char* mask, std::size_t count, Missing& missing,
    HeightCensus& census);
  void RefuseOtherPlaces() const;
  void CheckSpacing() const;
  void DoubtHeights(const HeightCensus& census);

  GdalErrors Errors; // first, so that closing the file prints nothing
  // GDAL must not leave a file with the size beside a gzip file that it reads.
  CPLConfigOptionSetter NoGzipProperties{ "CPL_VSIL_GZIP_WRITE_PROPERTIES", "NO", false };
  std::string File;
  std::string Opened; ///< the name that GDAL opens; differs from File for a pipe
  SourceGuard Guard;  // before Dataset, which opens its sources only when it reads them
  std::vector<double> FurtherNodata;
  std::vector<Doubt> Doubts;
  GdalDataset Dataset;
  GDALRasterBand* Band = nullptr;
  int Columns = 0, Rows = 0;
  int VtkType = 0;
  CoordinateSystem Crs;
  Georeference Whole;
  bool MirroredX = false; ///< the first column of the file is the eastern one
  bool SouthUp = false;   ///< the first row of the file is the southern one
  std::array<double, 2> Spacing{ { 1.0, 1.0 } };
  std::array<double, 2> Origin{ { 0.0, 0.0 } };
  bool Plain = true;                ///< heights are the band's values, unchanged
  double Scale = 1.0, Offset = 0.0; ///< metres = value * Scale + Offset
  bool DeclaresNodata = false;
  double Nodata = 0.0;
  bool HasMask = false; ///< the file has a mask or an alpha band
};

} // namespace skyline

#endif
