// SPDX-License-Identifier: BSD-3-Clause
// CRSs that a file declares and GDAL did not read: without a look, degrees would pass for metres.
#ifndef skyline_DeclaredCrs_h
#define skyline_DeclaredCrs_h

#include <string>

class GDALDataset;

namespace skyline
{

/// For a dataset without a CRS. Part: what declares one that could not be read, as a part of a
/// sentence ("'dem.prj'"), empty: nothing. Beside: a file that declares one and does not belong to the
/// dataset by its format's rules, empty: none.
struct UnreadCrs
{
  std::string Part;
  std::string Beside;
};
UnreadCrs FindUnreadCrs(GDALDataset& dataset);

} // namespace skyline

#endif
