// SPDX-License-Identifier: BSD-3-Clause
// A light map in a Radiance (.hdr) or OpenEXR file: the reader without the pipeline.
#ifndef skyline_LightMapFile_h
#define skyline_LightMapFile_h

#include "CubeMap.h"
#include "LightMap.h"
#include "NoImageThreads.h"

#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace skyline
{

/// An open file. Every function throws IoFailure with a one-line reason that names the file.
class LightMapFile
{
public:
  /// Opens `file` and reads its header. What it is shows in its first bytes, not in its name.
  explicit LightMapFile(const std::string& file);

  /// Pixels of the latitude-longitude map: the file's, or of a cube with faces of n x n pixels
  /// 4 n x 2 n.
  int GetColumns() const { return this->Columns; }
  int GetRows() const { return this->Rows; }
  bool IsCube() const { return this->Cube; }

  /// Called with the part done (0 to 1); false stops the reading.
  using ProgressFunction = std::function<bool(double)>;

  /// Reads the map into `pixels`, Columns * Rows times three floats with the bottom row first, all
  /// finite and not negative, and says how many pixels of the file had to be mended. Throws
  /// IoAborted when `progress` says so.
  LightMapDefects Read(float* pixels, const ProgressFunction& progress);

private:
  void Open();
  void FindChannels();
  void FindShape();
  void CheckClaim(std::int64_t pixels) const;
  std::unique_ptr<float[]> ReadPixels(const ProgressFunction& progress);
  void PlaceInWindow(const float* values, float* pixels) const;
  [[noreturn]] void Refuse(const std::string& reason) const;

  std::string File;
  NoImageThreads Alone;
  std::unique_ptr<OIIO::ImageInput> Input;
  OIIO::ImageSpec Spec; ///< of the first part, full resolution
  int FirstChannel = 0;
  int Channels = 3; ///< 1 (grey) or 3
  int Columns = 0, Rows = 0;
  bool Cube = false;
  CubeMap Faces; ///< if a cube, without values
};

} // namespace skyline

#endif
