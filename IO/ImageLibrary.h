// SPDX-License-Identifier: BSD-3-Clause
// The part of Skyline that uses OpenImageIO, in a library of its own.
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
  bool Half = false; ///< floats are stored as halves
};

/// Reads and writes Radiance, OpenEXR and PNG files. OpenImageIO brings some 130 libraries (Debian 12)
/// that take longer to load than many a command takes to compute, so it is loaded with the first image.
class ImageLibrary
{
public:
  virtual ~ImageLibrary() = default;

  /// Opens `file` and reads its header. What it is shows in its first bytes, not in its name. Throws
  /// IoFailure with a one-line reason that names the file.
  virtual std::unique_ptr<LightMapFile> OpenLightMap(const std::string& file) const = 0;

  /// Called with the part done (0 to 1); stops the writing by an exception, which gets through.
  using ReportFunction = std::function<void(double)>;

  /// Writes a picture to `file`, in the format of its name (.png: bytes, .exr: floats), and reads it
  /// back. Throws IoFailure.
  virtual void WritePicture(
    const Picture& picture, const AtomicFile& file, const ReportFunction& report) const = 0;

  /// The library. Throws IoFailure where it cannot be loaded.
  static const ImageLibrary& Get();
};

/// The only function that the library SkylineImages offers by name.
using ImageLibraryFunction = const ImageLibrary* (*)();
constexpr const char* ImageLibraryFunctionName = "SkylineImageLibrary";

} // namespace skyline

/// Of the library SkylineImages; SkylineIO looks it up by its name.
extern "C" SKYLINEIO_EXPORT const skyline::ImageLibrary* SkylineImageLibrary();

#endif
