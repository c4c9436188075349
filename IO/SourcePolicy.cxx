// SPDX-License-Identifier: BSD-3-Clause
#include "SourcePolicy.h"

#include "IoFailure.h"

#include "vtkErrorCode.h"

#include <gdal.h>

namespace skyline
{

const std::vector<std::string>& DefaultDrivers()
{
  static const std::vector<std::string> drivers{ // virtual rasters and rasters in memory
    "VRT", "DERIVED", "MEM",
    // common formats
    "GTiff", "COG", "GPKG", "HFA", "JP2OpenJPEG", "JP2KAK", "JP2ECW", "PNG", "JPEG", "WEBP", "TGA",
    "BMP", "PNM", "ENVI", "EHdr", "GenBin", "ISCE", "ROI_PAC", "RRASTER", "PCIDSK", "ERS", "KRO",
    // science
    "netCDF", "HDF4", "HDF4Image", "HDF5", "HDF5Image", "BAG", "GRIB", "FITS", "Zarr", "R",
    // terrain
    "AIG", "AAIGrid", "GRASSASCIIGrid", "DTED", "SRTMHGT", "USGSDEM", "SDTS", "NITF", "BT",
    "Leveller", "Terragen", "JDEM", "HF2", "SIGDEM", "LCP", "ACE2", "SNODAS", "XYZ", "CTG", "RIK",
    "PRF", "BLX", "MFF", "MFF2",
    // programs for geography and geology
    "SAGA", "GSAG", "GSBG", "GS7BG", "RST", "ILWIS", "PCRaster", "ZMap", "GXF", "NWT_GRD", "RMF",
    "ELAS", "LAN", "PAux", "ARG", "IRIS",
    // planets
    "PDS", "PDS4", "ISIS2", "ISIS3", "VICAR",
    // geoids
    "GTX", "BYN", "ISG", "NGSGEOID"
  };
  return drivers;
}

namespace
{

/// True for drivers that contact servers by themselves.
bool IsOfTheNetwork(const std::string& driver)
{
  for (const char* name : { "DAAS", "EEDAI", "GeoRaster", "HTTP", "NGW", "OGCAPI", "PLMOSAIC",
         "PLSCENES", "PostGISRaster", "STACIT", "STACTA", "WCS", "WMS", "WMTS" })
  {
    if (EQUAL(driver.c_str(), name))
    {
      return true;
    }
  }
  return false;
}

} // namespace

std::vector<std::string> AllowedDrivers(const SourcePolicy& policy)
{
  std::vector<std::string> drivers = DefaultDrivers();
  if (policy.AllowNetwork)
  {
    drivers.emplace_back("HTTP"); // opens a file by its URL
  }
  for (const std::string& name : policy.Drivers)
  {
    if (!GDALGetDriverByName(name.c_str()))
    {
      throw IoFailure(vtkErrorCode::UnknownError,
        "GDAL has no driver '" + name + "'; gdalinfo --formats lists those it has");
    }
    if (IsOfTheNetwork(name) && !policy.AllowNetwork)
    {
      throw IoFailure(vtkErrorCode::UnknownError,
        "the driver '" + name + "' reads from servers; use --allow-network too");
    }
    drivers.push_back(name);
  }
  return drivers;
}

} // namespace skyline
