// SPDX-License-Identifier: BSD-3-Clause
// The light of a lamp by spherical harmonics: the fast method for soft shadows of the thesis
// "Real-time soft shadows on dynamic height fields from local lights" (THESIS), sections 4.3.1 and
// 4.3.2.
#ifndef skyline_LampHarmonics_h
#define skyline_LampHarmonics_h

#include "Harmonics/SphericalHarmonics.h"
#include "HeightField/Grid.h"
#include "HeightField/HeightPyramid.h"
#include "Horizon/HorizonMethod.h"
#include "Lamps/Lamp.h"
#include "Lamps/LampTerrain.h"

#include <cstddef>

namespace skyline
{

/// How light, visibility and cosine are multiplied.
enum class LampProduct
{
  Transfer, ///< integrates visibility times cosine in full, then multiplies by the light: only the
            ///< light is truncated to its bands
  Triple    ///< truncates all three, then multiplies: THESIS equation 4.29
};

struct LampHarmonicSettings
{
  int Bands = DefaultHarmonicBands; ///< 2 to 8
  int Azimuths = 32;                ///< evenly spaced, 1 or more; THESIS chapter 6 uses 32
  LampProduct Product = LampProduct::Transfer;
  Surface Shape = Surface::Triangles; ///< the surface through the posts
  double CurvatureDrop = 0.0;         ///< (1 - k) / 2R in 1/m, as in LampSettings
  /// If not null, horizons are found as in the thesis, from a pyramid of the same field, instead of
  /// from the surface.
  const HeightPyramid* Pyramid = nullptr;
  PyramidSettings Levels; ///< how the pyramid is read
};

/// The zonal coefficients of a lamp's disc of unit radiance around the zenith, `bands` of them, in
/// closed form, for discs of any size (THESIS equations 4.27 and A.1, continued to any band).
void LampZonal(int bands, const LampDisc& disc, double* zonal);

/// Finds the slopes of the horizons of the rows [rowBegin, rowEnd) in one azimuth (radians
/// clockwise from grid north), row by row from `slopes` on.
/// Only terrain whose distance on the map is less than that of the lamp's centre counts (THESIS
/// equation 4.22). Slopes may be negative. They are NoTerrainSlope where there is no such terrain,
/// and have no meaning at missing posts. Disjoint ranges of rows may run at the same time.
void FindLampHorizons(const LampTerrain& terrain, const Grid& grid, Surface shape, double drop,
  const Lamp& lamp, double azimuth, std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, float* slopes);

/// Adds the irradiance of a lamp, as AddLampIrradiance does. The result is approximate, with soft
/// shadows, while that of LampIrradiance.h is exact; Documentation/lamps.md gives figures. Negative
/// values of the series count as 0. Throws std::invalid_argument if bands or azimuths are out of
/// range, and for the same errors as CheckLamp.
void AddLampHarmonics(const LampTerrain& terrain, const Grid& grid, const float* east,
  const float* north, const Lamp& lamp, const LampHarmonicSettings& settings,
  std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, float* rgb);

} // namespace skyline

#endif
