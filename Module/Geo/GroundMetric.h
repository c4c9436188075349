// SPDX-License-Identifier: BSD-3-Clause
// True lengths and angles between the posts of a height field on any map.
#ifndef skyline_GroundMetric_h
#define skyline_GroundMetric_h

#include "Geo/Georeference.h"
#include "Geo/RowSpacing.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <vector>

namespace skyline
{

/// The spacing and the right angles of a map are used everywhere if no distance in the raster is
/// wrong by more than this part and no direction by more than this angle. Inside its zone, UTM
/// stays within 0.098 % and has no error of direction. On other maps, each post has its own lengths
/// and angles.
constexpr double DistanceTolerance = 1e-3;
constexpr double AzimuthTolerance = 0.05; // degrees

/// The steps from a post, in metres on the ground, on local axes: y is the ground direction of the
/// +y axis of the image, and x points at a right angle to its right. The next row lies at (0, Y),
/// the next column at (X, Shear).
struct PostMetric
{
  double X = 1.0, Shear = 0.0, Y = 1.0;
};

/// Largest errors of direction and distance if `used` replaces `truth`.
struct MetricError
{
  double Azimuth = 0.0;  ///< radians, the largest over all directions
  double Distance = 0.0; ///< relative, the largest over all directions
};
SKYLINECORE_EXPORT MetricError ErrorOf(const PostMetric& used, const PostMetric& truth);

/// Metres per line of a ray that crosses `columns` columns and `rows` rows per line.
SKYLINECORE_EXPORT double LengthOf(const PostMetric& metric, double columns, double rows);

/// Lengths and angles at all posts. They come from the row spacings of the georeference if it has
/// any, otherwise from its lattice. They are linear between nodes, whose number follows from
/// NodeTolerance.
class SKYLINECORE_EXPORT GroundMetric
{
public:
  /// Largest relative error of the interpolation between nodes.
  static constexpr double NodeTolerance = 5e-5;

  /// `image`: the spacing of the image in metres. It holds everywhere (Uniform) for a field without
  /// a place on a body, for a field smaller than a metre, and if the true lengths differ by no more
  /// than DistanceTolerance and AzimuthTolerance. Throws std::invalid_argument, which names the
  /// post and the value, if the map has no lengths at some post, because the post lies outside its
  /// domain or the map is folded there.
  GroundMetric(const Georeference& place, const PostSpacing& image);

  /// True if one metric, that of the spacing of the image, serves all posts.
  bool Uniform() const { return this->Nodes.size() == 1; }

  /// True if each row has one metric without shear.
  bool ByRows() const { return !this->SpacingX.empty(); }

  /// Metres between columns and between rows, one value per row from the south, if ByRows;
  /// otherwise null.
  const double* RowSpacingX() const { return this->ByRows() ? this->SpacingX.data() : nullptr; }
  const double* RowSpacingY() const { return this->ByRows() ? this->SpacingY.data() : nullptr; }

  /// The metric at a post. Fractions are allowed. Beyond the edge, the metric of the edge is
  /// returned.
  PostMetric At(double column, double row) const;
  PostMetric Centre() const;

  /// The error at the worst post if `used` is taken everywhere.
  MetricError WorstError(const PostMetric& used) const;

  /// Azimuth on the ground (radians clockwise from y, PostMetric) of an azimuth on the image, at a
  /// post with this metric. Georeference::GridAzimuthAt defines azimuths on the image.
  double GroundAzimuth(const PostMetric& metric, double imageAzimuth) const;

  /// Metres per line (LengthOf) of a ray that crosses `columns` columns and `rows` rows per line,
  /// at `count` posts of a row, starting at `column`.
  void Lengths(std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, double columns,
    double rows, float* metres) const;

  /// Converts gradients of a row of posts along the axes of the image (per metre of `image`) to
  /// gradients along the axes of PostMetric. Does nothing if Uniform.
  void TurnGradients(
    std::ptrdiff_t row, const PostSpacing& image, std::ptrdiff_t count, float* x, float* y) const;

  /// Calls f(metric) for each node, row by row from the south.
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

  /// Interpolates the values of the nodes, in the order of the nodes, at `count` posts of a row,
  /// starting at `column`.
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
  std::ptrdiff_t Across = 1, Along = 1;   ///< numbers of nodes
  std::vector<PostMetric> Nodes;          ///< row by row from the south
  std::vector<double> SpacingX, SpacingY; ///< of the rows, if each row has its own
  bool Collapses = false;                 ///< all columns meet in a point somewhere
  bool TrueImage = false;                 ///< azimuths on the image use true lengths
  double ImageX = 1.0, ImageY = 1.0;      ///< otherwise: steps of the plane of the image
};

} // namespace skyline

#endif
