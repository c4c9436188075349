// SPDX-License-Identifier: BSD-3-Clause
// Colour maps for heights, as short lists of control colours. Pure functions, without VTK.
//
// The colours of each list grow lighter from the first to the last (a test checks this), so that
// the order of heights remains visible with any colour vision and in a black-and-white print.
#ifndef skyline_ColorMaps_h
#define skyline_ColorMaps_h

#include "Color/ToneMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace skyline
{

/// A colour map: evenly spaced control colours as sRGB codes 0xRRGGBB, from low to high heights.
struct ColorMap
{
  std::string_view Name;
  std::string_view Description;
  std::array<unsigned int, 11> Colors; ///< the first `Count` elements are used
  std::size_t Count;
  std::size_t
    SeaCount; ///< number of colours for heights below 0, used only there; 0: no sea colours
};

/// All colour maps; the first is the default.
inline const std::array<ColorMap, 5>& ColorMaps()
{
  // hypsometric and ocean are our own. viridis (CC0, van der Walt and Smith 2015) and cividis
  // (Nunez, Anderton and Renslow 2018) are sampled at ten colours.
  static const std::array<ColorMap, 5> maps{ {
    { "hypsometric", "from muted green through ochre to white",
      { { 0x3d5447, 0x536b52, 0x6f7f5e, 0x90916d, 0xab9f77, 0xb9a67f, 0xc2ad8e, 0xccbaa3, 0xd9cdbd,
        0xe9e2da, 0xf9f7f5 } },
      11, 0 },
    { "ocean", "blue below height 0, the hypsometric colours above it",
      { { 0x15293f, 0x1d3a57, 0x274d70, 0x356288, 0x4a789b, 0x6c8c66, 0x90916d, 0xb2a27b, 0xc5b193,
        0xdacebf, 0xf9f7f5 } },
      11, 5 },
    { "viridis", "from dark violet through green to yellow",
      { { 0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b,
        0xfde725 } },
      10, 0 },
    { "cividis", "from dark blue through grey to yellow",
      { { 0x00204d, 0x00336f, 0x39486b, 0x575c6d, 0x707173, 0x8a8779, 0xa69d75, 0xc4b56c, 0xe4cf5b,
        0xffea46 } },
      10, 0 },
    { "gray", "one light grey, which shows the light alone", { { 0xd8d8d8, 0xd9d9d9 } }, 2, 0 },
  } };
  return maps;
}

/// The colour map with the given name, or nullptr if there is none.
inline const ColorMap* FindColorMap(std::string_view name)
{
  for (const ColorMap& map : ColorMaps())
  {
    if (map.Name == name)
    {
      return &map;
    }
  }
  return nullptr;
}

/// The position of a height in the list of a map, 0 to 1. The list spans the heights from `low` to
/// `high`. In a map with sea colours, height 0 is the middle of the list, and both halves have the
/// same scale, so that a shallow sea is not drawn in deep colours; no height below 0 reaches the
/// middle.
inline double PlaceOnMap(const ColorMap& map, double height, double low, double high)
{
  double first = low;
  double last = high;
  if (map.SeaCount > 0)
  {
    const double reach = std::max(std::abs(low), std::abs(high));
    first = -reach;
    last = reach;
  }
  const double place = last > first ? std::clamp((height - first) / (last - first), 0.0, 1.0) : 0.5;
  return map.SeaCount > 0 && height < 0.0 ? std::min(place, std::nextafter(0.5, 0.0)) : place;
}

/// The colour at position t of the list (clamped to 0 to 1) as linear light: the albedo of the
/// ground. Colours between the control colours are interpolated linearly in their sRGB codes. In a
/// map with sea colours, these fill the positions below 0.5 and the others the rest, so that the
/// colour changes abruptly at the coast.
inline Rgb ColorAt(const ColorMap& map, double t)
{
  double place = std::clamp(t, 0.0, 1.0);
  std::size_t first = 0;
  std::size_t count = map.Count;
  if (map.SeaCount > 0)
  {
    const bool sea = place < 0.5;
    place = sea ? 2.0 * place : 2.0 * place - 1.0;
    first = sea ? 0 : map.SeaCount;
    count = sea ? map.SeaCount : map.Count - map.SeaCount;
  }
  const double step = place * static_cast<double>(count - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(step), count - 2);
  const float weight = static_cast<float>(step - static_cast<double>(i));
  Rgb color{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    const unsigned int shift = static_cast<unsigned int>(16 - 8 * c);
    const float a = static_cast<float>((map.Colors[first + i] >> shift) & 0xffu);
    const float b = static_cast<float>((map.Colors[first + i + 1] >> shift) & 0xffu);
    color[c] = DecodeSrgb((a + weight * (b - a)) / 255.0f);
  }
  return color;
}

} // namespace skyline

#endif
