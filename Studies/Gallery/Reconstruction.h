// SPDX-License-Identifier: BSD-3-Clause
// Horizons of the pyramid with reconstructions that Skyline does not offer: SN08, figure 9.
#ifndef skyline_Reconstruction_h
#define skyline_Reconstruction_h

#include "KeyShading.h"

namespace skyline
{
namespace gallery
{

/// The interpolation of heights between the samples of a level.
enum class Across
{
  Bilinear,
  Spline ///< bicubic B-spline
};

/// The interpolation of angles between the levels.
enum class Along
{
  Linear, ///< the greatest value is that of a level
  Spline  ///< cubic B-spline, evaluated at the levels and halfway between them
};

/// Simple loops: each height is interpolated where it is read, from the samples of the level.
HorizonsAt ReconstructedHorizons(
  const Scene& scene, double levelStep, double levelOffset, Along along, Across across);

} // namespace gallery
} // namespace skyline

#endif
