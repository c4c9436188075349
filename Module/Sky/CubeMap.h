// SPDX-License-Identifier: BSD-3-Clause
// Radiance on the six faces of a cube, and its conversion to a latitude-longitude map.
#ifndef skyline_CubeMap_h
#define skyline_CubeMap_h

#include "Sky/LightMap.h"
#include "SkylineCoreModule.h" // for the export macro

#include <array>
#include <cstddef>

namespace skyline
{

/// How the faces lie in one image. Every face is seen from inside the cube.
enum class CubeLayout
{
  /// 1 x 6, OpenEXR's (ImfEnvmap.h): +X -X +Y -Y +Z -Z from the top, with Y up and X to the left
  /// of someone who faces Z: west, east, up, down, north, south.
  VerticalStrip,
  /// 6 x 1: right, left, up, down, front, back: east, west, up, down, north, south.
  HorizontalStrip,
  /// 4 x 3: west, north, east, south side by side; up above and down below north.
  HorizontalCross,
  /// 3 x 4: west, north, east side by side; up above, down below north, and below that south, upside
  /// down.
  VerticalCross
};

/// A view of an image with a cube in it: linear RGB floats, the top row first.
struct CubeMap
{
  const float* Values = nullptr; ///< R, G, B of the image's pixel at the top left
  std::ptrdiff_t RowStride = 0;  ///< floats to the next row below
  std::ptrdiff_t Size = 0;       ///< pixels along the edge of a face, 1 or more
  CubeLayout Layout = CubeLayout::VerticalStrip;
};

/// The layout of an image of that size, and the edge of its faces. False if it is none of them.
SKYLINECORE_EXPORT bool FindCubeLayout(
  std::ptrdiff_t columns, std::ptrdiff_t rows, CubeLayout& layout, std::ptrdiff_t& size);

/// Whether the pixels of a cross that belong to no face are all alike, as in every cube; a photograph
/// of that shape is not. Strips have no such pixels.
SKYLINECORE_EXPORT bool UnusedPixelsAlike(const CubeMap& cube);

/// Integral of radiance over the sphere, each channel, with the exact solid angles of the pixels.
SKYLINECORE_EXPORT std::array<double, 3> CubeEnergy(const CubeMap& cube);

/// Rows [rowBegin, rowEnd) of the map of so many columns and rows, 3 * columns floats each into
/// `pixels` (row 0's first): means over 8 x 8 directions in each pixel of the radiance interpolated
/// bilinearly in its face. Uniform light stays exactly uniform.
SKYLINECORE_EXPORT void CubeToLightMap(const CubeMap& cube, std::ptrdiff_t columns,
  std::ptrdiff_t rows, std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, float* pixels);

/// Scales every channel of a converted map so that it has that energy. Interpolation misses it by up
/// to 2 % of what one pixel at the corner of a face holds, and by much less elsewhere. pixels:
/// columns * rows from the top.
SKYLINECORE_EXPORT void KeepEnergy(
  const std::array<double, 3>& energy, std::ptrdiff_t columns, std::ptrdiff_t rows, float* pixels);

} // namespace skyline

#endif
