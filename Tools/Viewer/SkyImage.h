// SPDX-License-Identifier: BSD-3-Clause
// The sky in all directions, as an image of its radiance.
#ifndef skyline_SkyImage_h
#define skyline_SkyImage_h

#include "LitTerrain.h"

#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{

/// Linear light, in latitude and longitude as in LightMap.h: the top row ends at the zenith, the
/// middle column is north of the sky, and columns go clockwise to the right.
struct SkyImage
{
  std::ptrdiff_t Columns = 0, Rows = 0;
  std::vector<float> Values; ///< RGB
  float Typical = 0.0f;      ///< geometric mean of the luminance above the horizon

  float Peak() const; ///< the brightest channel; 0 if everything is dark
};

/// The number of columns of a sky from a formula, and the greatest number for a light map; larger
/// maps are reduced by averaging.
constexpr std::ptrdiff_t FormulaColumns = 180;
constexpr std::ptrdiff_t MostMapColumns = 2048;

/// A sky formula ends at the horizon. Below, the sky fades to a plain of this albedo under the same
/// light, by 1 - exp(-sin(depth) / PlainDepth), like distant ground in haze.
constexpr Rgb PlainAlbedo{ { 0.30f, 0.34f, 0.40f } };
constexpr double PlainDepth = 0.08;

/// Makes the sky of a light. `level` and `ground` are those of GetSkyRadiance and GetGroundLight of
/// LitTerrain for that light. Throws std::invalid_argument for impossible skies.
SkyImage MakeSkyImage(const TerrainLight& light, const Rgb& level, const Rgb& ground);

/// A text that differs whenever MakeSkyImage would give another image.
std::string SkyImageKey(const TerrainLight& light, const Rgb& level, const Rgb& ground);

} // namespace skyline

#endif
