// SPDX-License-Identifier: BSD-3-Clause
// A light map in a Radiance (.hdr) or OpenEXR file: the code of the reader that does not depend on
// VTK's pipeline.
#ifndef skyline_LightMapFile_h
#define skyline_LightMapFile_h

#include "Sky/LightMap.h"

#include <functional>

namespace skyline
{

/// An open file, made by ImageLibrary. Each function throws IoFailure with a one-line reason that
/// names the file.
class LightMapFile
{
public:
  virtual ~LightMapFile() = default;

  /// Pixels of the latitude-longitude map. They are those of the file, or 4 n x 2 n for a cube
  /// whose faces have n x n pixels.
  virtual int GetColumns() const = 0;
  virtual int GetRows() const = 0;
  virtual bool IsCube() const = 0;

  /// A function that receives the completed part (0 to 1) and returns false to stop the reading.
  using ProgressFunction = std::function<bool(double)>;

  /// Reads the map into `pixels`: Columns * Rows * 3 floats, bottom row first, all of them finite
  /// and not negative. Returns how many pixels of the file had to be corrected. Throws IoAborted if
  /// `progress` returns false.
  virtual LightMapDefects Read(float* pixels, const ProgressFunction& progress) = 0;
};

} // namespace skyline

#endif
