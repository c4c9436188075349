// SPDX-License-Identifier: BSD-3-Clause
// CRSs that a file declares but GDAL did not read. Without this check, degrees would be taken for
// metres.
#ifndef skyline_DeclaredCrs_h
#define skyline_DeclaredCrs_h

#include <string>

class GDALDataset;

namespace skyline
{

/// The result for a dataset without a CRS. Part: what declares a CRS that could not be read, as a
/// part of a sentence ("'dem.prj'"); empty if there is none. Beside: a file that declares a CRS but
/// does not belong to the dataset by the rules of its format; empty if there is none.
struct UnreadCrs
{
  std::string Part;
  std::string Beside;
};
UnreadCrs FindUnreadCrs(GDALDataset& dataset);

} // namespace skyline

#endif
