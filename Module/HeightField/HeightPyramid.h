// SPDX-License-Identifier: BSD-3-Clause
// Ever smoother copies of a height field: the pyramid of Snyder & Nowrouzezahrai 2008 (SN08),
// sections 4 and 6.
#ifndef skyline_HeightPyramid_h
#define skyline_HeightPyramid_h

#include "HeightField/HeightField.h"
#include "SkylineCoreModule.h" // for the export macro

#include <array>
#include <cstddef>
#include <vector>

namespace skyline
{

/// Levels of a pyramid over n posts with `step` levels an octave: ceil(step log2 n) + 1.
SKYLINECORE_EXPORT int PyramidLevels(std::ptrdiff_t posts, double step);

/// Posts between the samples of a level, and its samples.
struct PyramidSize
{
  double Scale = 1.0;
  std::ptrdiff_t Columns = 0, Rows = 0;
};

/// All levels over columns x rows posts, the coarsest first. step: levels an octave, 1 to 16, else
/// std::invalid_argument.
SKYLINECORE_EXPORT std::vector<PyramidSize> PyramidSizes(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double step);

/// The two samples of a finer level that a sample reads along one axis.
struct LinearTaps
{
  std::ptrdiff_t First, Second;
  float Weight; ///< of the second
};

/// Those of all samples of an axis; ratio: of the scales, coarse to fine.
SKYLINECORE_EXPORT std::vector<LinearTaps> DecimationTaps(
  double ratio, std::ptrdiff_t fine, std::ptrdiff_t coarse);

/// One level. A sample stands for Scale x Scale posts; sample c lies at post (c + 1/2) Scale - 1/2
/// along either axis, so that the first one's square begins where the first post's does.
struct PyramidLevel
{
  double Scale = 1.0; ///< posts between samples, 2^(k / step)
  std::ptrdiff_t Columns = 0, Rows = 0;
  std::vector<float> Heights;  ///< metres above the field's base, times Coverage
  std::vector<float> Coverage; ///< part of the sample with a surface, 0 to 1; empty if all have one
};

/// The weights of the samples that a place on an axis reads, and the first of them.
struct SplineTaps
{
  std::array<float, 4> Weights{};
  std::array<std::ptrdiff_t, 4> Samples{}; ///< clamped to the level
};

/// Uniform cubic b-spline at post `place` (any fraction) of an axis with `samples` samples.
SKYLINECORE_EXPORT SplineTaps TapsAt(double place, double scale, std::ptrdiff_t samples);

/// SN08's pyramid: level i = 0 is the coarsest and i = N - 1 the field itself, each level the one
/// after it, bilinearly sampled b = 2^(1 / step) samples apart. Any size; the greater number of posts
/// decides N. Missing posts weigh nothing: a sample is the mean of what it covers.
///
/// Heights between samples are the bicubic b-spline of a level, bilinear between posts, as section 6
/// has it. Each level is kept as b-splined along the rows alone (`Row`): its rows are n, n / b,
/// n / b^2 ... in number, so that all levels together take 1 / (1 - 1 / b) copies of the field, not
/// N; the other axis has the same weights along a whole row and costs a few products.
class SKYLINECORE_EXPORT HeightPyramid
{
public:
  /// step: levels an octave, 1 to 16, not necessarily whole; else std::invalid_argument. The field
  /// is closed; nothing of it is kept.
  HeightPyramid(const HeightField& field, double step);

  /// Builds the rows [begin, end) of RowCount(), in any order and on any thread: all of them before
  /// the first use of Row.
  void Expand(std::ptrdiff_t begin, std::ptrdiff_t end);
  std::ptrdiff_t RowCount() const { return this->FirstRow.back(); }

  int Levels() const { return static_cast<int>(this->Pyramid.size()); }
  const PyramidLevel& Level(int i) const { return this->Pyramid[static_cast<std::size_t>(i)]; }
  bool HasMissing() const { return this->Missing; }

  /// The rows of level i, not the finest, that a row of posts is splined from.
  const SplineTaps& RowTaps(int i, std::ptrdiff_t row) const
  {
    return this->Along[static_cast<std::size_t>(i)][static_cast<std::size_t>(row)];
  }

  /// Lanes that may be read before and after a row: a block of 64 and its reach.
  static constexpr std::ptrdiff_t Margin = 96;

  /// Row `row` of level i, a value a column of the field: heights times coverage, and coverage (only
  /// where HasMissing).
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
  std::vector<std::ptrdiff_t> FirstRow; // of each level among all rows, and their number
  std::vector<std::vector<SplineTaps>> Across, Along; // of each level, a column or row of posts
  std::ptrdiff_t Columns = 0, Stride = 0;
  std::vector<float> Expanded, ExpandedCoverage;
  bool Missing = false;
};

} // namespace skyline

#endif
