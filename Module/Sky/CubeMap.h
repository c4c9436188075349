// SPDX-License-Identifier: BSD-3-Clause
// Radiance on the six faces of a cube, and its conversion to a latitude-longitude light map.
#ifndef skyline_CubeMap_h
#define skyline_CubeMap_h

#include "Sky/LightMap.h"
#include "SkylineCoreModule.h" // for the export macro

#include <array>
#include <cstddef>

namespace skyline
{

/// The arrangement of the faces in one image. Each face is seen from inside the cube.
enum class CubeLayout
{
  /// 1 x 6, as in OpenEXR (ImfEnvmap.h): +X -X +Y -Y +Z -Z from the top, where Y is up and X is to
  /// the left of an observer who looks along Z: west, east, up, down, north, south.
  VerticalStrip,
  /// 6 x 1: right, left, up, down, front, back, which are east, west, up, down, north, south.
  HorizontalStrip,
  /// 4 x 3: west, north, east, south side by side; up above north and down below it.
  HorizontalCross,
  /// 3 x 4: west, north, east side by side; up above north, down below it, and below that south,
  /// upside down.
  VerticalCross
};

/// A view of an image that contains a cube map: linear RGB floats, the top row first.
struct CubeMap
{
  const float* Values = nullptr; ///< R, G, B of the pixel at the top left of the image
  std::ptrdiff_t RowStride = 0;  ///< floats to the next row below
  std::ptrdiff_t Size = 0;       ///< pixels along the edge of a face, 1 or more
  CubeLayout Layout = CubeLayout::VerticalStrip;
};

/// Finds the layout of an image from its size, and the edge length of its faces. Returns false if
/// none fits.
SKYLINECORE_EXPORT bool FindCubeLayout(
  std::ptrdiff_t columns, std::ptrdiff_t rows, CubeLayout& layout, std::ptrdiff_t& size);

/// Whether the pixels of a cross that belong to no face are all equal, as in cube maps but not in a
/// photograph of the same shape. Strips have no such pixels.
SKYLINECORE_EXPORT bool UnusedPixelsAlike(const CubeMap& cube);

/// Integral of radiance over the sphere for each channel, with the exact solid angles of the
/// pixels.
SKYLINECORE_EXPORT std::array<double, 3> CubeEnergy(const CubeMap& cube);

/// Computes rows [rowBegin, rowEnd) of a map of the given size, with 3 * columns floats each, and
/// writes them to `pixels`, which begins with row 0. Each pixel is the mean over 8 x 8 directions
/// of the radiance, interpolated bilinearly within its face. Uniform light stays exactly uniform.
SKYLINECORE_EXPORT void CubeToLightMap(const CubeMap& cube, std::ptrdiff_t columns,
  std::ptrdiff_t rows, std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, float* pixels);

/// Scales each channel of a converted map so that it has the given energy. Interpolation changes
/// the energy by up to 2 % of that of one pixel if this lies at the corner of a face, and by much
/// less elsewhere. pixels: columns * rows pixels, starting at the top.
SKYLINECORE_EXPORT void KeepEnergy(
  const std::array<double, 3>& energy, std::ptrdiff_t columns, std::ptrdiff_t rows, float* pixels);

} // namespace skyline

#endif
