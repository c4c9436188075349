// SPDX-License-Identifier: BSD-3-Clause
// The part of Skyline that uses OpenImageIO, in a separate library.
#ifndef skyline_ImageLibrary_h
#define skyline_ImageLibrary_h

#include "LightMapFile.h"
#include "SkylineIOModule.h" // for the export macro

#include <functional>
#include <memory>
#include <string>

namespace skyline
{

class AtomicFile;

/// A picture in memory.
struct Picture
{
  const void* Values = nullptr; ///< south row first; floats, or bytes in sRGB
  int Columns = 0, Rows = 0;
  int Channels = 0; ///< 1 (grey), 3 (RGB) or 4 (RGBA)
  bool Bytes = false;
  bool Half = false; ///< floats are stored with 16 bits
};

/// Reads and writes Radiance, OpenEXR and PNG files. OpenImageIO needs about 130 other libraries
/// (on Debian 12). Loading them takes longer than many commands run, so this library is loaded when
/// the first image is read or written.
class ImageLibrary
{
public:
  virtual ~ImageLibrary() = default;

  /// Opens `file` and reads its header. The format is recognised by the first bytes, not by the
  /// name. Throws IoFailure with a one-line reason that names the file.
  virtual std::unique_ptr<LightMapFile> OpenLightMap(const std::string& file) const = 0;

  /// A function that receives the completed part (0 to 1). It may throw an exception to stop the
  /// writing; the caller of WritePicture gets that exception.
  using ReportFunction = std::function<void(double)>;

  /// Writes a picture to `file` in the format of its extension (.png: bytes, .exr: floats) and
  /// reads it back to check it. Throws IoFailure.
  virtual void WritePicture(
    const Picture& picture, const AtomicFile& file, const ReportFunction& report) const = 0;

  /// The loaded library. Throws IoFailure if it cannot be loaded.
  static const ImageLibrary& Get();
};

/// The only function that the library SkylineImages exports.
using ImageLibraryFunction = const ImageLibrary* (*)();
constexpr const char* ImageLibraryFunctionName = "SkylineImageLibrary";

} // namespace skyline

/// Exported by the library SkylineImages; SkylineIO looks it up by its name.
extern "C" SKYLINEIO_EXPORT const skyline::ImageLibrary* SkylineImageLibrary();

#endif
