// SPDX-License-Identifier: BSD-3-Clause
// Opening a raster: what is refused or doubted before any height is read.
#include "RasterSource.h"

#include "DeclaredCrs.h"
#include "IoFailure.h"

#include "vtkErrorCode.h"

#include <string>

namespace skyline
{

/// A forbidden file is reported first: what GDAL reports may be its consequence.
void RasterSource::CheckRefusal() const
{
  if (!this->Guard.GetRefusal().empty())
  {
    this->Refuse(this->Guard.GetRefusal());
  }
}

/// Refuses the file if GDAL reported a failure, although the file opened: GDAL continues without a
/// CRS, mask or georeference that it could not read. Warnings of GDAL become doubts.
void RasterSource::CheckComplaints()
{
  this->CheckRefusal();
  const auto refuse = [this](const std::string& words)
  {
    this->Refuse("GDAL could not read all of it: " + words +
      "; correct the file, or the setup of GDAL and PROJ (gdalinfo shows the same)");
  };
  if (this->Errors.Any())
  {
    refuse(this->Errors.First());
  }
  for (const std::string& warning : this->Errors.GetWarnings())
  {
    if (warning.rfind("PROJ: ", 0) == 0)
    {
      refuse(warning); // without PROJ's database, a CRS loses its units and axes
    }
    this->Doubts.push_back(
      { "GDAL warns about '" + this->File + "': " + warning, "the file was read correctly", "" });
  }
  this->Errors.Clear();
}

void RasterSource::FailToOpen()
{
  this->CheckRefusal();
  const std::string driver = this->Guard.DriverRefusal(this->Opened);
  this->CheckRefusal();
  if (!driver.empty())
  {
    this->Refuse(driver);
  }
  VSIStatBufL status;
  const bool found = VSIStatL(this->Opened.c_str(), &status) == 0;
  const unsigned long code =
    found ? vtkErrorCode::UnrecognizedFileTypeError : vtkErrorCode::FileNotFoundError;
  // GDAL's message begins with the file name, as ours does.
  std::string reason = this->Errors.First();
  const std::string name = this->Opened + ": ";
  reason.erase(0, reason.rfind(name, 0) == 0 ? name.size() : 0);
  throw IoFailure(code,
    "cannot read '" + this->File + "': " + reason +
      (found ? "; give a raster that gdalinfo can open" : "; check the path"));
}

/// Without a CRS, the raster is a map in metres. This must not be assumed if it has a CRS that
/// could not be read.
void RasterSource::CheckCrs()
{
  const OGRSpatialReference* crs = this->Dataset->GetSpatialRef();
  if (crs && !crs->IsEmpty())
  {
    return;
  }
  this->CheckComplaints(); // GDAL's messages are more precise
  this->RefuseOtherPlaces();
  const UnreadCrs unread = FindUnreadCrs(*this->Dataset);
  if (!unread.Part.empty())
  {
    this->Refuse("the CRS that " + unread.Part +
      " declares cannot be read; assign the right one (gdal_edit.py -a_srs)");
  }
  if (!unread.Beside.empty())
  {
    this->Doubts.push_back({ "'" + this->File + "' has no CRS that GDAL reads, though '" +
        unread.Beside + "' lies beside it",
      "x and y in metres", "gdal_edit.py -a_srs" });
  }
}

void RasterSource::Open(int band)
{
  this->Dataset.reset(this->Guard.Open(this->Opened));
  if (!this->Dataset)
  {
    this->FailToOpen();
  }
  this->CheckRefusal();

  const int bands = this->Dataset->GetRasterCount();
  if (bands == 0)
  {
    char** parts = this->Dataset->GetMetadata("SUBDATASETS");
    const char* first = CSLFetchNameValue(parts, "SUBDATASET_1_NAME");
    this->Refuse(first ? "it holds " + std::to_string(CSLCount(parts) / 2) +
          " rasters; name one, such as '" + first + "'"
                       : std::string("it has no raster band; give a file with heights"));
  }
  if (band < 1 || band > bands)
  {
    this->Refuse("it has no band " + std::to_string(band) + "; choose " +
      (bands == 1 ? std::string("band 1") : "a band from 1 to " + std::to_string(bands)));
  }
  this->Band = this->Dataset->GetRasterBand(band);
  this->Columns = this->Dataset->GetRasterXSize();
  this->Rows = this->Dataset->GetRasterYSize();
  if (this->Columns < 2 || this->Rows < 2)
  {
    this->Refuse(std::to_string(this->Columns) + " x " + std::to_string(this->Rows) +
      " posts make no surface; give at least 2 x 2");
  }
  this->CheckCrs();
}

} // namespace skyline
