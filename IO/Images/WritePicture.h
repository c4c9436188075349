// SPDX-License-Identifier: BSD-3-Clause
#ifndef skyline_WritePicture_h
#define skyline_WritePicture_h

#include "ImageLibrary.h"

namespace skyline
{

/// ImageLibrary::WritePicture, implemented with OpenImageIO.
void WritePicture(
  const Picture& picture, const AtomicFile& file, const ImageLibrary::ReportFunction& report);

} // namespace skyline

#endif
