// SPDX-License-Identifier: BSD-3-Clause
// Which other files a height file may refer to while it is read.
#ifndef skyline_SourcePolicy_h
#define skyline_SourcePolicy_h

#include <string>
#include <vector>

namespace skyline
{

/// A raster can name other files: sources, masks, overviews, servers. These names were chosen by
/// the author of the file. By default they are followed only inside the folder of the file, and
/// only in formats of local rasters.
struct SourcePolicy
{
  bool AllowNetwork = false;   ///< URLs and GDAL's network file systems (/vsicurl/, /vsis3/ ...)
  bool AllowElsewhere = false; ///< files outside the folder of the file that the user named
  std::vector<std::string> Drivers; ///< short names of GDAL's drivers besides DefaultDrivers
};

/// The short names of GDAL's drivers for local rasters that may contain heights.
const std::vector<std::string>& DefaultDrivers();

/// The drivers with which `policy` allows a file to be opened. Throws IoFailure for a name that
/// GDAL does not know, and for a driver that reads from servers if AllowNetwork is false.
std::vector<std::string> AllowedDrivers(const SourcePolicy& policy);

} // namespace skyline

#endif
