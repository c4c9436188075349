// SPDX-License-Identifier: BSD-3-Clause
// The height fields of the benchmark.
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
  oracle::OracleField Field; ///< flat, because not all methods can take curvature into account
};

/// Names of the scenes that need no file of the user.
const std::vector<std::string>& SceneNames();

/// The greatest side of a raster, in posts. Of a larger raster only the middle is used.
constexpr std::ptrdiff_t LargestSide = 2048;

/// Makes a scene of SceneNames() with size x size posts (helens and lidar have their own sizes), or
/// reads any raster that GDAL opens. Throws std::runtime_error with a one-line reason.
Scene MakeScene(const std::string& nameOrFile, std::ptrdiff_t size);

/// Hills with travelling waves at a time in seconds, 0 or more. The scene "moving" is at time 0.
oracle::OracleField MovingTerrain(std::ptrdiff_t size, double time);

} // namespace benchmark
} // namespace skyline

#endif
