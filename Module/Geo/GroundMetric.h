// SPDX-License-Identifier: BSD-3-Clause
// True lengths and angles between the posts of a height field, on whatever map it lies.
#ifndef skyline_GroundMetric_h
#define skyline_GroundMetric_h

#include "Geo/Georeference.h"
#include "Geo/RowSpacing.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <vector>

namespace skyline
{

/// A map is taken at its word, one spacing and right angles everywhere, where no distance in the raster
/// is wrong by more than this part and no direction by more than this angle. UTM inside its zone stays
/// within 0.098 % and has no error of direction. Beyond, every post has its own lengths and angles.
constexpr double DistanceTolerance = 1e-3;
constexpr double AzimuthTolerance = 0.05; // degrees

/// The steps from a post, metres on the ground, on axes of its own: y is the ground direction of the
/// image's +y axis, x is at right angles to its right. The next row lies at (0, Y), the next column at
/// (X, Shear).
struct PostMetric
{
  double X = 1.0, Shear = 0.0, Y = 1.0;
};

/// By how much a direction and a distance may differ when `used` stands for `truth`.
struct MetricError
{
  double Azimuth = 0.0;  ///< radians, the largest over all directions
  double Distance = 0.0; ///< relative, the largest over all directions
};
SKYLINECORE_EXPORT MetricError ErrorOf(const PostMetric& used, const PostMetric& truth);

/// Metres per line of a ray that crosses `columns` and `rows` in it.
SKYLINECORE_EXPORT double LengthOf(const PostMetric& metric, double columns, double rows);

/// Lengths and angles of all posts: of the rows where the georeference has them, otherwise of its
/// lattice; linear between nodes, which are as many as NodeTolerance needs.
class SKYLINECORE_EXPORT GroundMetric
{
public:
  /// Largest relative error of the interpolation between nodes.
  static constexpr double NodeTolerance = 5e-5;

  /// `image`: the image's spacing, metres. It holds everywhere (Uniform) for a field without a place, for
  /// one smaller than a metre, and where the true lengths differ within DistanceTolerance and
  /// AzimuthTolerance. Throws std::invalid_argument, naming post and number, where the map has no lengths
  /// at some post: beyond its domain, or folded.
  GroundMetric(const Georeference& place, const PostSpacing& image);

  /// One metric serves all posts: that of the image's spacing.
  bool Uniform() const { return this->Nodes.size() == 1; }

  /// Every row has one metric without shear.
  bool ByRows() const { return !this->SpacingX.empty(); }

  /// Metres between columns and between rows, one of each a row from the south, where ByRows; else null.
  const double* RowSpacingX() const { return this->ByRows() ? this->SpacingX.data() : nullptr; }
  const double* RowSpacingY() const { return this->ByRows() ? this->SpacingY.data() : nullptr; }

  /// At a post; fractions are allowed, beyond the edge the edge's counts.
  PostMetric At(double column, double row) const;
  PostMetric Centre() const;

  /// The error, at the worst post, of taking `used` everywhere.
  MetricError WorstError(const PostMetric& used) const;

  /// Azimuth on the ground (radians clockwise from y, PostMetric) of an azimuth on the image at a post
  /// with this metric: Georeference::GridAzimuthAt tells how the image's azimuths count.
  double GroundAzimuth(const PostMetric& metric, double imageAzimuth) const;

  /// Metres per line, at `count` posts of a row from `column` on, of a ray that crosses `columns` and
  /// `rows` in a line (LengthOf).
  void Lengths(std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, double columns,
    double rows, float* metres) const;

  /// Turns gradients of a row of posts along the image's axes (per metre of `image`) into those along
  /// the axes of PostMetric. Does nothing where Uniform.
  void TurnGradients(
    std::ptrdiff_t row, const PostSpacing& image, std::ptrdiff_t count, float* x, float* y) const;

  /// Calls f(metric) for every node, row by row from the south.
  template <typename Function>
  void ForEachNode(const Function& f) const
  {
    const auto step = [](std::ptrdiff_t posts, std::ptrdiff_t nodes)
    { return nodes > 1 ? static_cast<double>(posts - 1) / static_cast<double>(nodes - 1) : 0.0; };
    const double across = step(this->ColumnCount, this->Across);
    const double along = step(this->RowCount, this->Along);
    for (std::ptrdiff_t j = 0; j < this->Along; ++j)
    {
      for (std::ptrdiff_t i = 0; i < this->Across; ++i)
      {
        f(this->At(static_cast<double>(i) * across, static_cast<double>(j) * along));
      }
    }
  }

  /// Values of the nodes, in that order, interpolated at `count` posts of a row from `column` on.
  void Interpolate(const std::vector<float>& nodes, std::ptrdiff_t row, std::ptrdiff_t column,
    std::ptrdiff_t count, float* values) const;

  std::ptrdiff_t Columns() const { return this->ColumnCount; }
  std::ptrdiff_t Rows() const { return this->RowCount; }

private:
  bool Sample(const Georeference& place, std::ptrdiff_t side);
  PostMetric Between(double column, double row) const;
  const PostMetric& Node(std::ptrdiff_t i, std::ptrdiff_t j) const
  {
    return this->Nodes[static_cast<std::size_t>(j * this->Across + i)];
  }

  std::ptrdiff_t ColumnCount = 0, RowCount = 0;
  std::ptrdiff_t Across = 1, Along = 1;   ///< nodes
  std::vector<PostMetric> Nodes;          ///< row by row from the south
  std::vector<double> SpacingX, SpacingY; ///< of rows, where each has its own
  bool Collapses = false;                 ///< somewhere all columns meet in a point
  bool TrueImage = false;                 ///< image azimuths count in true lengths
  double ImageX = 1.0, ImageY = 1.0;      ///< steps of the image's plane, if not
};

} // namespace skyline

#endif
