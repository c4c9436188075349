// SPDX-License-Identifier: BSD-3-Clause
#include "ImageLibrary.h"
#include "OpenLightMap.h"
#include "WritePicture.h"

namespace
{

class OpenImageIo : public skyline::ImageLibrary
{
public:
  std::unique_ptr<skyline::LightMapFile> OpenLightMap(const std::string& file) const override
  {
    return skyline::OpenLightMap(file);
  }

  void WritePicture(const skyline::Picture& picture, const skyline::AtomicFile& file,
    const ReportFunction& report) const override
  {
    skyline::WritePicture(picture, file, report);
  }
};

} // namespace

const skyline::ImageLibrary* SkylineImageLibrary()
{
  static const OpenImageIo library;
  return &library;
}
