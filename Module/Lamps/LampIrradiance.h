// SPDX-License-Identifier: BSD-3-Clause
// The light of a lamp at all posts, by direct integration over the disc of the lamp.
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
  Surface Shape = Surface::Triangles; ///< the surface between the posts
  double CurvatureDrop = 0.0; ///< (1 - k) / 2R in 1/m, as in HorizonSettings; also lowers the lamp
  int Azimuths = 32;        ///< initial number of vertical planes through the disc of a lamp, 2 or
                            ///< more
  double Tolerance = 0.002; ///< between planes with a shadow edge, more planes are added until the
                            ///< error is about this part of the unshadowed irradiance
  double Least = 0.0;       ///< a lamp is ignored if its irradiance for radiance 1 cannot exceed
                            ///< this value; 0: no lamp is ignored
};

/// Adds the irradiance of a lamp at the posts of rows [rowBegin, rowEnd) to rgb (3 floats per post,
/// row by row from post (0, 0) of the grid): the integral of L V max(0, n.d) over directions d.
/// Missing posts get NaN. Disjoint ranges may run at the same time.
///
/// V is 1 if the ray from the post meets the surface of the lamp before any terrain. Terrain behind
/// the lamp or inside it hides nothing of the part in front. Rays may point downwards; only terrain
/// and the plane of the receiver block them.
///
/// grid: the posts of the field, with the spacing that holds at the receivers. east, north: the
/// gradients of all posts (Normals.h); null: level receivers. Throws what CheckLamp throws.
SKYLINECORE_EXPORT void AddLampIrradiance(const LampTerrain& terrain, const Grid& grid,
  const float* east, const float* north, const Lamp& lamp, const LampSettings& settings,
  std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, float* rgb);

/// Counts of the work of such calls, for tests and benchmarks.
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
