// SPDX-License-Identifier: BSD-3-Clause
// The sky all around as a picture of its radiance.
#ifndef skyline_SkyImage_h
#define skyline_SkyImage_h

#include "LitTerrain.h"

#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{

/// Linear light, latitude and longitude as in LightMap.h: the top row ends at the zenith, the middle
/// is the sky's own north, to the right is clockwise.
struct SkyImage
{
  std::ptrdiff_t Columns = 0, Rows = 0;
  std::vector<float> Values; ///< RGB
  float Typical = 0.0f;      ///< geometric mean of the luminance above the horizon

  float Peak() const; ///< the brightest channel; 0 where all is dark
};

/// Columns of a sky that a formula gives, and the most of one that was measured: larger maps are
/// averaged down.
constexpr std::ptrdiff_t FormulaColumns = 180;
constexpr std::ptrdiff_t MostMapColumns = 2048;

/// A formula's sky ends at the horizon. Below, it fades to a plain of this albedo under the same light,
/// by 1 - exp(-sin(depth) / PlainDepth): far ground in the haze.
constexpr Rgb PlainAlbedo{ { 0.30f, 0.34f, 0.40f } };
constexpr double PlainDepth = 0.08;

/// The sky of a light; `level` and `ground` as LitTerrain's GetSkyRadiance and GetGroundLight give them
/// for that light. Throws std::invalid_argument for skies that cannot be.
SkyImage MakeSkyImage(const TerrainLight& light, const Rgb& level, const Rgb& ground);

/// A text that differs where MakeSkyImage would.
std::string SkyImageKey(const TerrainLight& light, const Rgb& level, const Rgb& ground);

} // namespace skyline

#endif
