// SPDX-License-Identifier: BSD-3-Clause
// The pyramid's horizons with other reconstructions than Skyline has: SN08, figure 9.
#ifndef skyline_Reconstruction_h
#define skyline_Reconstruction_h

#include "KeyShading.h"

namespace skyline
{
namespace gallery
{

/// How heights between the samples of a level are found.
enum class Across
{
  Bilinear,
  Spline ///< bicubic b-spline
};

/// How angles between the levels are found.
enum class Along
{
  Linear, ///< its greatest value is that of a level
  Spline  ///< cubic b-spline at and halfway between the levels
};

/// Plain loops; every height is reconstructed where it is read, from the level's own samples.
HorizonsAt ReconstructedHorizons(
  const Scene& scene, double levelStep, double levelOffset, Along along, Across across);

} // namespace gallery
} // namespace skyline

#endif
