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
/// SanitizeLightMap). Row 0 is the top, at the zenith; the centre is north, to the right is
/// clockwise. The pixel (row, column) covers the polar angles [row, row + 1] pi / Rows and the
/// azimuths [column, column + 1] 2 pi / Columns - pi.
struct LightMap
{
  const float* Values = nullptr; ///< R, G, B of the pixel at the top left
  std::ptrdiff_t Columns = 0;    ///< 1 or more
  std::ptrdiff_t Rows = 0;       ///< 1 or more
  std::ptrdiff_t RowStride = 0;  ///< floats to the next row below; negative if stored bottom first

  const float* Pixel(std::ptrdiff_t row, std::ptrdiff_t column) const
  {
    return this->Values + row * this->RowStride + 3 * column;
  }
};

/// The view of pixels that follow each other row by row from the top.
inline LightMap ViewTopDown(const float* values, std::ptrdiff_t columns, std::ptrdiff_t rows)
{
  return { values, columns, rows, 3 * columns };
}

/// The view of pixels whose first row is the bottom one, as in a vtkImageData.
inline LightMap ViewBottomUp(const float* values, std::ptrdiff_t columns, std::ptrdiff_t rows)
{
  return { values + (rows - 1) * 3 * columns, columns, rows, -3 * columns };
}

/// The unit vector (x east, y north, z up) towards the middle of a pixel.
struct LightMapDirection
{
  double X, Y, Z;
};
SKYLINECORE_EXPORT LightMapDirection PixelDirection(
  const LightMap& map, std::ptrdiff_t row, std::ptrdiff_t column);

/// The solid angle of every pixel of a row, steradian: 2 pi / Columns (cos t - cos(t + pi / Rows)).
SKYLINECORE_EXPORT double PixelSolidAngle(const LightMap& map, std::ptrdiff_t row);

/// How many pixels had a channel that no radiance can have.
struct LightMapDefects
{
  std::ptrdiff_t Negative = 0;   ///< made 0, minus infinity too
  std::ptrdiff_t NotNumbers = 0; ///< NaN, made 0
  std::ptrdiff_t Infinite = 0;   ///< made the channel's largest finite value in the map, 0 if none
};

/// Makes `pixels` pixels of three floats finite and not negative. Values that are so already stay
/// as they are, however large.
SKYLINECORE_EXPORT LightMapDefects SanitizeLightMap(float* values, std::ptrdiff_t pixels);

/// What stands for a pixel in the sum of the projection.
enum class PixelRule
{
  Integral, ///< the integral of the harmonic over the pixel, to rounding: the map is a step function
  Centre    ///< the harmonic in the pixel's middle times its exact solid angle; off by O(pixel^2)
};

/// Projects maps of one size to spherical harmonics. Building one computes the waves of all
/// columns; rows may then be added by different threads to sums of their own.
class SKYLINECORE_EXPORT LightMapProjection
{
public:
  /// bands: 1 to 8.
  LightMapProjection(
    std::ptrdiff_t columns, std::ptrdiff_t rows, int bands, PixelRule rule = PixelRule::Integral);

  /// Adds the part of the rows [rowBegin, rowEnd) of a map of that size to `coefficients`: bands^2 of
  /// red, then of green, then of blue. Sums are in double, so a small sun keeps its energy.
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
  int WaveCount;                  ///< of cosines, and of sines: 4 or 8
  std::vector<double> Waves;      ///< for every column the cosines and the sines of m p
  std::vector<double> PixelWidth; ///< for every m: what the column's width makes of a wave
};

/// The spherical harmonics of a whole map: bands^2 coefficients of red, then of green, then of blue.
/// bands: 1 to 8. To turn the map about the vertical, turn them (RotateAboutVertical).
SKYLINECORE_EXPORT std::vector<double> ProjectLightMap(
  const LightMap& map, int bands = DefaultHarmonicBands, PixelRule rule = PixelRule::Integral);

} // namespace skyline

#endif
