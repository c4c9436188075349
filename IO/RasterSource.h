// SPDX-License-Identifier: BSD-3-Clause
// One band of a raster file as a lattice of heights: the reader without the pipeline.
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

/// Posts [ColumnBegin, ColumnBegin + Columns) x [RowBegin, RowBegin + Rows), from the south-west.
struct PostWindow
{
  int ColumnBegin = 0, RowBegin = 0;
  int Columns = 0, Rows = 0;
};

/// An open band. Every function throws IoFailure with a one-line reason that names the file.
class RasterSource
{
public:
  /// Opens `file` (anything GDAL opens by the drivers of `policy`) and looks at its band `band` (from
  /// 1). furtherNodata: values of missing posts besides the one that the file declares, as the band has
  /// them (before scale and unit). spooled: where the bytes of a pipe are, else empty.
  RasterSource(const std::string& file, int band, const std::vector<double>& furtherNodata = {},
    const SourcePolicy& policy = {}, const std::string& spooled = "");

  PostWindow GetWhole() const { return { 0, 0, this->Columns, this->Rows }; }

  /// VTK's type of the heights: the band's own for integers that are metres as they are, else
  /// float, or double where float would lose digits of the band.
  int GetVtkType() const { return this->VtkType; }

  /// Metres between columns and between rows, of the centre row where rows differ.
  const std::array<double, 2>& GetSpacing() const { return this->Spacing; }

  /// Metres: the south-west post's CRS coordinates on a projected or local map, else 0.
  const std::array<double, 2>& GetOrigin() const { return this->Origin; }

  /// The georeference of part of the raster. Its row spacings are the whole raster's.
  Georeference GetGeoreference(const PostWindow& window) const;

  /// The files that the raster is read from, as GDAL knows them.
  std::vector<std::string> GetFiles() const;

  bool HasNodata() const { return this->DeclaresNodata; }
  double GetNodata() const { return this->Nodata; }

  /// What is doubtful about the raster: its place and unit, and after Read its heights.
  const std::vector<Doubt>& GetDoubts() const { return this->Doubts; }

  /// Called with the part done (0 to 1); false stops the reading.
  using ProgressFunction = std::function<bool(double)>;

  /// Reads the heights of a window into `heights`, an array of GetVtkType with row 0 in the south:
  /// metres, NaN where missing. Throws IoAborted when `progress` says so, and IoFailure when every
  /// post of the whole raster is missing.
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

  GdalErrors Errors; // first, so that closing the file is quiet too
  // Reading a file through gzip leaves no note of its size beside it.
  CPLConfigOptionSetter NoNotes{ "CPL_VSIL_GZIP_WRITE_PROPERTIES", "NO", false };
  std::string File;
  std::string Opened; ///< what GDAL opens in place of a pipe
  SourceGuard Guard;  // before the dataset, which opens its sources when they are read
  std::vector<double> FurtherNodata;
  std::vector<Doubt> Doubts;
  GdalDataset Dataset;
  GDALRasterBand* Band = nullptr;
  int Columns = 0, Rows = 0;
  int VtkType = 0;
  CoordinateSystem Crs;
  Georeference Whole;
  bool MirroredX = false; ///< the file's first column is the eastern one
  bool SouthUp = false;   ///< the file's first row is the southern one
  std::array<double, 2> Spacing{ { 1.0, 1.0 } };
  std::array<double, 2> Origin{ { 0.0, 0.0 } };
  bool Plain = true;                ///< heights are the band's values as they are
  double Scale = 1.0, Offset = 0.0; ///< metres = value * Scale + Offset
  bool DeclaresNodata = false;
  double Nodata = 0.0;
  bool HasMask = false; ///< the file has a mask or alpha band
};

} // namespace skyline

#endif
