// SPDX-License-Identifier: BSD-3-Clause
// The light of a lamp on every post, by direct integration over the lamp's disc.
#ifndef skyline_LampIrradiance_h
#define skyline_LampIrradiance_h

#include "HeightField/Grid.h"
#include "Lamps/Lamp.h"
#include "Lamps/LampTerrain.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>

namespace skyline
{

struct LampSettings
{
  Surface Shape = Surface::Triangles; ///< the surface through the posts
  double Sink = 0.0;        ///< (1 - k) / 2R in 1/m, as in HorizonSettings; the lamp sinks likewise
  int Azimuths = 32;        ///< vertical planes laid through a lamp's disc to begin with, 2 or more
  double Tolerance = 0.002; ///< where a shadow's edge falls between planes, more of them are laid
                            ///< until the irradiance errs by about this part of the unshadowed
  double Least = 0.0;       ///< a lamp that could not give more than this irradiance for radiance 1
                            ///< counts as none; 0: every lamp reaches everywhere
};

/// Adds the irradiance of a lamp at the posts of rows [rowBegin, rowEnd) to rgb (3 floats a post,
/// row by row from post (0, 0) of the grid): the integral of L V max(0, n.d) over directions d. NaN
/// at missing posts. Disjoint ranges may run at the same time.
///
/// V is 1 if the ray from the post meets the lamp's surface before any terrain: terrain behind the
/// lamp, or inside it, hides nothing of the part in front. The ray may fall; nothing but terrain
/// and the plane of the receiver ends it.
///
/// grid: the field's posts with the spacing that holds where the receivers are. east, north: the
/// gradients of Gradients(), for all posts; null: level receivers. Throws as CheckLamp does.
SKYLINECORE_EXPORT void AddLampIrradiance(const LampTerrain& terrain, const Grid& grid,
  const float* east, const float* north, const Lamp& lamp, const LampSettings& settings,
  std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, float* rgb);

/// Planes swept and steps walked by calls like the above: for tests and benchmarks.
struct LampWork
{
  std::ptrdiff_t Posts = 0;  ///< posts that face the lamp
  std::ptrdiff_t Planes = 0; ///< vertical planes walked from a post to the lamp
};
SKYLINECORE_EXPORT void AddLampIrradiance(const LampTerrain& terrain, const Grid& grid,
  const float* east, const float* north, const Lamp& lamp, const LampSettings& settings,
  std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, float* rgb, LampWork& work);

} // namespace skyline

#endif
