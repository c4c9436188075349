// SPDX-License-Identifier: BSD-3-Clause
// The light of a lamp by spherical harmonics: the fast, soft way of the thesis "Real-time soft
// shadows on dynamic height fields from local lights" (THESIS), sections 4.3.1 and 4.3.2.
#ifndef skyline_LampHarmonics_h
#define skyline_LampHarmonics_h

#include "Harmonics/SphericalHarmonics.h"
#include "HeightField/Grid.h"
#include "HeightField/HeightPyramid.h"
#include "Horizon/PyramidSettings.h"
#include "Lamps/Lamp.h"
#include "Lamps/LampTerrain.h"

#include <cstddef>

namespace skyline
{

/// How light, visibility and cosine are multiplied.
enum class LampProduct
{
  Transfer, ///< visibility times cosine is integrated as it is, then dotted with the light: only the
            ///< light is cut off after its bands
  Triple    ///< the three cut off, then multiplied: THESIS equation 4.29
};

struct LampHarmonicSettings
{
  int Bands = DefaultHarmonicBands; ///< 2 to 8
  int Azimuths = 32;                ///< all around, 1 or more; THESIS chapter 6 takes 32
  LampProduct Product = LampProduct::Transfer;
  Surface Shape = Surface::Triangles; ///< the surface through the posts
  double Sink = 0.0;                  ///< (1 - k) / 2R in 1/m, as in LampSettings
  /// The thesis's own horizons, from a pyramid of the same field, instead of those of the surface.
  const HeightPyramid* Pyramid = nullptr;
  PyramidSettings Levels; ///< how it is read
};

/// A lamp's disc of unit radiance around the zenith: `bands` zonal coefficients, closed form (THESIS
/// equations 4.27 and A.1, and on to any band), of discs of any size, the smallest too.
void LampZonal(int bands, const LampDisc& disc, double* zonal);

/// Slopes of the horizons of rows [rowBegin, rowEnd) in an azimuth (radians clockwise from grid
/// north), row by row from `slopes` on, counting only terrain nearer than the lamp's centre is, both
/// on the map (THESIS equation 4.22): they may be below 0. NoTerrainSlope where none lies in between;
/// at missing posts they mean nothing. Disjoint ranges may run at the same time.
void FindLampHorizons(const LampTerrain& terrain, const Grid& grid, Surface shape, double sink,
  const Lamp& lamp, double azimuth, std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, float* slopes);

/// Adds the irradiance of a lamp, as AddLampIrradiance does (LampIrradiance.h, which is exact where
/// this is soft: Documentation/lamps.md has figures). Where the series rings below 0, nothing is
/// added. std::invalid_argument for bands or azimuths out of range, and as CheckLamp.
void AddLampHarmonics(const LampTerrain& terrain, const Grid& grid, const float* east,
  const float* north, const Lamp& lamp, const LampHarmonicSettings& settings,
  std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, float* rgb);

} // namespace skyline

#endif
