// SPDX-License-Identifier: BSD-3-Clause
// A dataset of GDAL that is closed at the end of its owner.
#ifndef skyline_GdalDataset_h
#define skyline_GdalDataset_h

#include <gdal_priv.h>

#include <memory>

namespace skyline
{

struct GdalCloser
{
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using GdalDataset = std::unique_ptr<GDALDataset, GdalCloser>;

} // namespace skyline

#endif
