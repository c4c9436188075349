// SPDX-License-Identifier: BSD-3-Clause
// The height fields that the benchmark runs on.
#ifndef skyline_Scenes_h
#define skyline_Scenes_h

#include "Reference/Oracle.h"

#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

struct Scene
{
  std::string Name;
  std::string Description;
  oracle::OracleField Field; ///< flat: no method here is asked to bend the body
};

/// Names of the scenes that need no file from the user.
const std::vector<std::string>& SceneNames();

/// Greatest side of a raster; of a larger one its middle counts.
constexpr std::ptrdiff_t LargestSide = 2048;

/// A scene of SceneNames() with size x size posts (helens and lidar have their own size), or any raster that
/// GDAL opens. std::runtime_error with a one-line reason.
Scene MakeScene(const std::string& nameOrFile, std::ptrdiff_t size);

/// Hills under travelling waves, 0 <= time: seconds. "moving" is the one at time 0.
oracle::OracleField MovingTerrain(std::ptrdiff_t size, double time);

} // namespace benchmark
} // namespace skyline

#endif
