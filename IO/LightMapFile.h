// SPDX-License-Identifier: BSD-3-Clause
// A light map in a Radiance (.hdr) or OpenEXR file: the reader without the pipeline.
#ifndef skyline_LightMapFile_h
#define skyline_LightMapFile_h

#include "Sky/LightMap.h"

#include <functional>

namespace skyline
{

/// An open file, from ImageLibrary. Every function throws IoFailure with a one-line reason that names
/// the file.
class LightMapFile
{
public:
  virtual ~LightMapFile() = default;

  /// Pixels of the latitude-longitude map: the file's, or of a cube with faces of n x n pixels
  /// 4 n x 2 n.
  virtual int GetColumns() const = 0;
  virtual int GetRows() const = 0;
  virtual bool IsCube() const = 0;

  /// Called with the part done (0 to 1); false stops the reading.
  using ProgressFunction = std::function<bool(double)>;

  /// Reads the map into `pixels`, Columns * Rows times three floats with the bottom row first, all
  /// finite and not negative, and says how many pixels of the file had to be mended. Throws
  /// IoAborted when `progress` says so.
  virtual LightMapDefects Read(float* pixels, const ProgressFunction& progress) = 0;
};

} // namespace skyline

#endif
