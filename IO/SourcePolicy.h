// SPDX-License-Identifier: BSD-3-Clause
// What a file of heights may lead to while it is read.
#ifndef skyline_SourcePolicy_h
#define skyline_SourcePolicy_h

#include <string>
#include <vector>

namespace skyline
{

/// A raster can name others: sources, masks, overviews, servers. Whoever made the file chose those
/// names, so by default they count only beside the file, and only in formats of local rasters.
struct SourcePolicy
{
  bool AllowNetwork = false;   ///< URLs and GDAL's network file systems (/vsicurl/, /vsis3/ ...)
  bool AllowElsewhere = false; ///< files outside the folder of the file that was asked for
  std::vector<std::string> Drivers; ///< GDAL's short names, beside those of DefaultDrivers
};

/// GDAL's drivers of local rasters in which heights come, by their short names.
const std::vector<std::string>& DefaultDrivers();

/// The drivers that `policy` lets open a file. Throws IoFailure for a name that GDAL does not know, and
/// for a driver that reads from servers without AllowNetwork.
std::vector<std::string> AllowedDrivers(const SourcePolicy& policy);

} // namespace skyline

#endif
