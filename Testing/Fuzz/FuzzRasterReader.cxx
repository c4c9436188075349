// SPDX-License-Identifier: BSD-3-Clause
// Runs libFuzzer on the reader of height fields, with two types of input: complete files, whose
// bytes select the driver, and rasters made here, which are valid for GDAL and have any transform,
// CRS, nodata value, scale, unit and data type. The latter test Skyline's own code.
#include "FuzzTesting.h"

#include "vtkHeightFieldHorizon.h"
#include "vtkHeightFieldReader.h"
#include "vtkImageData.h"

#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>

#include <fuzzer/FuzzedDataProvider.h>

#include <cstring>
#include <vector>

namespace
{

using skyline::testing::Demand;

// Drivers of elevation formats whose files are read directly. Formats that refer to other files or
// to the network are excluded.
const char* const Drivers[] = { "GTiff", "AAIGrid", "GSAG", "GSBG", "USGSDEM", "SRTMHGT", "MEM" };

void KeepDrivers()
{
  GDALAllRegister();
  GDALDriverManager* manager = GetGDALDriverManager();
  for (int k = manager->GetDriverCount() - 1; k >= 0; --k)
  {
    GDALDriver* driver = manager->GetDriver(k);
    bool wanted = false;
    for (const char* name : Drivers)
    {
      wanted = wanted || std::strcmp(driver->GetDescription(), name) == 0;
    }
    if (!wanted)
    {
      manager->DeregisterDriver(driver);
    }
  }
  CPLSetErrorHandler(CPLQuietErrorHandler);
}

// Makes a GeoTIFF whose properties all come from the input.
void MakeRaster(FuzzedDataProvider& input, const std::string& file)
{
  const int columns = input.ConsumeIntegralInRange(1, 24);
  const int rows = input.ConsumeIntegralInRange(1, 24);
  const GDALDataType types[] = { GDT_Byte, GDT_Int16, GDT_UInt16, GDT_Int32, GDT_UInt32,
    GDT_Float32, GDT_Float64, GDT_CFloat32 };
  const GDALDataType type = input.PickValueInArray(types);
  auto* driver = static_cast<GDALDriver*>(GDALGetDriverByName("GTiff"));
  GDALDataset* raster = driver->Create(file.c_str(), columns, rows, 1, type, nullptr);
  if (raster == nullptr)
  {
    return;
  }
  const char* const systems[] = { "", "EPSG:4326", "EPSG:32610", "EPSG:3857", "EPSG:3031",
    "EPSG:4979", "EPSG:2229", "ESRI:102017", "IAU_2015:49900", "+proj=longlat +R=1 +no_defs",
    "LOCAL_CS[\"x\",UNIT[\"m\",1]]" };
  OGRSpatialReference system;
  const std::string name = input.ConsumeBool() ? std::string(input.PickValueInArray(systems))
                                               : input.ConsumeRandomLengthString(64);
  if (!name.empty() && system.SetFromUserInput(name.c_str()) == OGRERR_NONE)
  {
    raster->SetSpatialRef(&system);
  }
  double transform[6];
  for (double& number : transform)
  {
    number = input.ConsumeBool() ? input.ConsumeFloatingPointInRange(-200.0, 200.0)
                                 : input.ConsumeFloatingPoint<double>();
  }
  if (input.ConsumeBool())
  {
    transform[2] = transform[4] = 0.0; // north up
  }
  raster->SetGeoTransform(transform);
  GDALRasterBand* band = raster->GetRasterBand(1);
  if (input.ConsumeBool())
  {
    band->SetNoDataValue(input.ConsumeFloatingPoint<double>());
  }
  if (input.ConsumeBool())
  {
    band->SetScale(input.ConsumeFloatingPoint<double>());
    band->SetOffset(input.ConsumeFloatingPoint<double>());
  }
  if (input.ConsumeBool())
  {
    band->SetUnitType(input.ConsumeRandomLengthString(12).c_str());
  }
  std::vector<double> heights(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (double& height : heights)
  {
    height = input.ConsumeFloatingPoint<double>();
  }
  (void)band->RasterIO(
    GF_Write, 0, 0, columns, rows, heights.data(), columns, rows, GDT_Float64, 0, 0, nullptr);
  GDALClose(raster);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static const bool prepared = (KeepDrivers(), true);
  (void)prepared;
  if (size < 2)
  {
    return 0;
  }
  const std::string file = "/vsimem/fuzz.tif";
  FuzzedDataProvider input(bytes, size);
  if (input.ConsumeBool()) // ConsumeBool takes from the end of the input
  {
    MakeRaster(input, file);
  }
  else
  {
    VSIFCloseL(VSIFileFromMemBuffer(
      file.c_str(), const_cast<std::uint8_t*>(bytes), size - 1, /* bTakeOwnership = */ 0));
  }

  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(file.c_str());
  skyline::testing::UpdateQuietly(reader);
  vtkImageData* image = reader->GetOutput();
  const int* posts = image->GetDimensions();
  if (image->GetNumberOfPoints() > 0)
  {
    Demand(image->GetSpacing()[0] > 0.0 && image->GetSpacing()[1] > 0.0, "spacings above 0");
    if (posts[0] <= 64 && posts[1] <= 64)
    {
      // Values that were read must be valid for a filter, or the filter must refuse them.
      vtkNew<vtkHeightFieldHorizon> horizon;
      horizon->SetInputConnection(reader->GetOutputPort());
      horizon->SetNumberOfAzimuths(3);
      skyline::testing::UpdateQuietly(horizon);
    }
  }
  VSIUnlink(file.c_str());
  VSIUnlink("/vsimem/fuzz.tif.aux.xml");
  return 0;
}
