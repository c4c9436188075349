// SPDX-License-Identifier: BSD-3-Clause
// Radiance from all directions as an image, and its spherical harmonics.
#ifndef skyline_LightMap_h
#define skyline_LightMap_h

#include "Harmonics/SphericalHarmonics.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <vector>

namespace skyline
{

/// A view of a latitude-longitude map of radiance: linear RGB floats, finite and not negative (see
/// SanitizeLightMap). Row 0 is the top row, at the zenith. The centre column is north, and columns
/// to the right are clockwise from it. Pixel (row, column) covers the polar angles [row, row + 1]
/// pi / Rows and the azimuths [column, column + 1] 2 pi / Columns - pi.
struct LightMap
{
  const float* Values = nullptr; ///< R, G, B of the pixel at the top left
  std::ptrdiff_t Columns = 0;    ///< 1 or more
  std::ptrdiff_t Rows = 0;       ///< 1 or more
  std::ptrdiff_t RowStride = 0;  ///< floats to the next row below; negative if the bottom row is
                                 ///< stored first

  const float* Pixel(std::ptrdiff_t row, std::ptrdiff_t column) const
  {
    return this->Values + row * this->RowStride + 3 * column;
  }
};

/// A view of pixels that are stored row by row, starting at the top.
inline LightMap ViewTopDown(const float* values, std::ptrdiff_t columns, std::ptrdiff_t rows)
{
  return { values, columns, rows, 3 * columns };
}

/// A view of pixels that are stored row by row, starting at the bottom, as in a vtkImageData.
inline LightMap ViewBottomUp(const float* values, std::ptrdiff_t columns, std::ptrdiff_t rows)
{
  return { values + (rows - 1) * 3 * columns, columns, rows, -3 * columns };
}

/// The unit vector (x east, y north, z up) towards the centre of a pixel.
struct LightMapDirection
{
  double X, Y, Z;
};
SKYLINECORE_EXPORT LightMapDirection PixelDirection(
  const LightMap& map, std::ptrdiff_t row, std::ptrdiff_t column);

/// The solid angle of each pixel of a row, in steradians: 2 pi / Columns (cos t - cos(t + pi /
/// Rows)).
SKYLINECORE_EXPORT double PixelSolidAngle(const LightMap& map, std::ptrdiff_t row);

/// Numbers of pixels with a channel that is not a possible radiance.
struct LightMapDefects
{
  std::ptrdiff_t Negative = 0;   ///< set to 0; includes minus infinity
  std::ptrdiff_t NotNumbers = 0; ///< NaN, set to 0
  std::ptrdiff_t Infinite = 0;   ///< set to the largest finite value of the channel in the map, or
                                 ///< 0 without one
};

/// Makes all channels of `pixels` pixels of three floats finite and not negative. Valid values are
/// unchanged, however large they are.
SKYLINECORE_EXPORT LightMapDefects SanitizeLightMap(float* values, std::ptrdiff_t pixels);

/// What represents a pixel in the sum of the projection.
enum class PixelRule
{
  Integral, ///< the exact integral of the harmonic over the pixel: the map is a step function
  Centre    ///< the harmonic at the centre times the exact solid angle; error O(pixel^2)
};

/// Projects maps of one size to spherical harmonics. The constructor computes the waves of all
/// columns. Threads may then add different rows, each to its own sums.
class SKYLINECORE_EXPORT LightMapProjection
{
public:
  /// bands: 1 to 8.
  LightMapProjection(
    std::ptrdiff_t columns, std::ptrdiff_t rows, int bands, PixelRule rule = PixelRule::Integral);

  /// Adds the contribution of rows [rowBegin, rowEnd) of a map of this size to `coefficients`:
  /// bands^2 for red, then for green, then for blue. Sums are in double, so that the energy of a
  /// small sun is not lost.
  void AddRows(const LightMap& map, std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd,
    double* coefficients) const;

private:
  template <int Waves>
  void AddRowsOf(const LightMap& map, std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd,
    double* coefficients) const;
  void PolarParts(std::ptrdiff_t row, double* parts) const;

  std::ptrdiff_t Columns, Rows;
  int Bands;
  PixelRule Rule;
  int WaveCount;                  ///< number of cosines, and of sines: 4 or 8
  std::vector<double> Waves;      ///< the cosines and sines of m p for each column
  std::vector<double> PixelWidth; ///< for each m: factor on a wave due to the width of a column
};

/// The spherical harmonics of a whole map: bands^2 coefficients for red, then for green, then for
/// blue. bands: 1 to 8. To rotate the map about the vertical, rotate the coefficients
/// (RotateAboutVertical).
SKYLINECORE_EXPORT std::vector<double> ProjectLightMap(
  const LightMap& map, int bands = DefaultHarmonicBands, PixelRule rule = PixelRule::Integral);

} // namespace skyline

#endif
