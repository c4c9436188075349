// SPDX-License-Identifier: BSD-3-Clause
// Copies of a height field that are smoothed and coarsened step by step: the height pyramid of
// Snyder & Nowrouzezahrai 2008 (SN08), sections 4 and 6.
#ifndef skyline_HeightPyramid_h
#define skyline_HeightPyramid_h

#include "HeightField/HeightField.h"
#include "SkylineCoreModule.h" // for the export macro

#include <array>
#include <cstddef>
#include <vector>

namespace skyline
{

/// Number of levels of a pyramid over n posts with `step` levels per octave: ceil(step log2 n) + 1.
SKYLINECORE_EXPORT int PyramidLevels(std::ptrdiff_t posts, double step);

/// Distance between the samples of a level in posts, and their numbers along both axes.
struct PyramidSize
{
  double Scale = 1.0;
  std::ptrdiff_t Columns = 0, Rows = 0;
};

/// The sizes of all levels over columns x rows posts, the coarsest first. step: levels per octave,
/// 1 to 16; throws std::invalid_argument otherwise.
SKYLINECORE_EXPORT std::vector<PyramidSize> PyramidSizes(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double step);

/// The two samples of a finer level from which a sample is interpolated along one axis.
struct LinearTaps
{
  std::ptrdiff_t First, Second;
  float Weight; ///< of the second sample
};

/// The taps of all samples of an axis. ratio: scale of the coarse level divided by that of the fine
/// one.
SKYLINECORE_EXPORT std::vector<LinearTaps> DecimationTaps(
  double ratio, std::ptrdiff_t fine, std::ptrdiff_t coarse);

/// One level. A sample stands for Scale x Scale posts. Sample c lies at post (c + 1/2) Scale - 1/2
/// along each axis, so that the square of the first sample begins where the square of the first
/// post begins.
struct PyramidLevel
{
  double Scale = 1.0; ///< posts between samples, 2^(k / step)
  std::ptrdiff_t Columns = 0, Rows = 0;
  std::vector<float> Heights;  ///< metres above the base of the field, times Coverage
  std::vector<float> Coverage; ///< share of the sample with a surface, 0 to 1; empty if 1
                               ///< everywhere
};

/// The samples that are read for a position on an axis, and their weights.
struct SplineTaps
{
  std::array<float, 4> Weights{};
  std::array<std::ptrdiff_t, 4> Samples{}; ///< clamped to the level
};

/// Taps of the uniform cubic B-spline at post `place` (any fraction) of an axis with `samples`
/// samples.
SKYLINECORE_EXPORT SplineTaps TapsAt(double place, double scale, std::ptrdiff_t samples);

/// The pyramid of SN08: level i = 0 is the coarsest one and i = N - 1 is the field itself. Each
/// level is the next finer one, bilinearly sampled at distances of b = 2^(1 / step) samples. Fields
/// may have any size; the greater number of posts per axis decides N. Missing posts have no weight:
/// a sample is the mean of the posts that it covers.
///
/// Heights between samples follow the bicubic B-spline of a level, and are bilinear between posts,
/// as in section 6. Each level is stored after the B-spline along the rows (`Row`). As the levels
/// have n, n / b, n / b^2 ... rows, all of them together take 1 / (1 - 1 / b) copies of the field
/// instead of N. Along the other axis, the weights are the same for a whole row and need only a few
/// products.
class SKYLINECORE_EXPORT HeightPyramid
{
public:
  /// step: levels per octave, 1 to 16, may be a fraction; throws std::invalid_argument otherwise.
  /// The field must be closed; the pyramid keeps no reference to it.
  HeightPyramid(const HeightField& field, double step);

  /// Computes the rows [begin, end) of RowCount(), in any order and on any thread. All rows must be
  /// computed before the first use of Row.
  void Expand(std::ptrdiff_t begin, std::ptrdiff_t end);
  std::ptrdiff_t RowCount() const { return this->FirstRow.back(); }

  int Levels() const { return static_cast<int>(this->Pyramid.size()); }
  const PyramidLevel& Level(int i) const { return this->Pyramid[static_cast<std::size_t>(i)]; }
  bool HasMissing() const { return this->Missing; }

  /// The rows of level i (not the finest) from which a row of posts is interpolated.
  const SplineTaps& RowTaps(int i, std::ptrdiff_t row) const
  {
    return this->Along[static_cast<std::size_t>(i)][static_cast<std::size_t>(row)];
  }

  /// Lanes that may be read before and after a row: a block of 64 and its reach.
  static constexpr std::ptrdiff_t Margin = 96;

  /// Row `row` of level i with one value per column of the field: heights times coverage.
  /// CoverageRow gives the coverage (only if HasMissing).
  const float* Row(int i, std::ptrdiff_t row) const { return this->At(this->Expanded, i, row); }
  const float* CoverageRow(int i, std::ptrdiff_t row) const
  {
    return this->At(this->ExpandedCoverage, i, row);
  }

private:
  void Decimate(const PyramidLevel& fine, PyramidLevel& coarse) const;
  void ExpandRow(int i, std::ptrdiff_t row);
  const float* At(const std::vector<float>& rows, int i, std::ptrdiff_t row) const
  {
    return rows.data() + (this->FirstRow[static_cast<std::size_t>(i)] + row) * this->Stride +
      Margin;
  }

  std::vector<PyramidLevel> Pyramid;
  std::vector<std::ptrdiff_t> FirstRow; // first row of each level among all rows, and at the end
                                        // their number
  std::vector<std::vector<SplineTaps>> Across, Along; // for each level, per column and per row of
                                                      // posts
  std::ptrdiff_t Columns = 0, Stride = 0;
  std::vector<float> Expanded, ExpandedCoverage;
  bool Missing = false;
};

} // namespace skyline

#endif
