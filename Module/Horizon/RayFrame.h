// SPDX-License-Identifier: BSD-3-Clause
// One azimuth seen by the posts: every ray of the azimuth meets the surface's edges at the same
// offsets, with the same weights, in the same order.
#ifndef skyline_RayFrame_h
#define skyline_RayFrame_h

#include "HeightField/Grid.h"
#include "HeightField/HeightField.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <cstdint>
#include <vector>

namespace skyline
{

/// Unit vector of a grid azimuth in radians clockwise from north: (east, north). Exact for multiples of 45
/// degrees times RadiansPerDegree. Any finite azimuth; others throw std::invalid_argument.
struct Direction
{
  double East, North;
};
SKYLINECORE_EXPORT Direction DirectionOfAzimuth(double azimuth);

/// Columns and rows a metre along an azimuth on a grid; radians and errors as in DirectionOfAzimuth.
struct PostsPerMetre
{
  double Columns, Rows;
};
PostsPerMetre RayOfAzimuth(const Grid& grid, double azimuth);

/// What a ray meets from line D - 1 to line D ahead of its receiver. `trail` and `lead` are the two
/// posts of a line on either side of the ray, the lead on the side the ray drifts to. A slope, in
/// metres of height per line, is  a * A + b * B - sink  with heights A, B above the receiver.
struct RayStep
{
  std::int32_t Lane;                ///< lane of the trail post on line D, from the receiver's lane
  std::int32_t Next;                ///< 1: the ray changes its column of cells in this step
  float RowTrail, RowLead, RowSink; ///< the edge from trail to lead on line D
  float MidNear, MidFar, MidSink; ///< between the lines, weights of the posts on lines D - 1 and D:
                                  ///< the cell's diagonal, or the column edge if Next
};

/// The diagonals of both cells of a Next step, on a surface whose diagonals run against the drift.
struct SideStep
{
  float LeftNear, LeftFar, LeftSink;
  float RightNear, RightFar, RightSink;
};

/// Places of a step, for the bilinear surface and missing posts.
struct StepPlace
{
  double Part;    ///< of the way from trail to lead on line D; 0: through the trail post exactly
  double MidLine; ///< lines from the receiver to the edge between the lines
};

/// The frame of an azimuth: lines are rows or columns of the image, whichever the rays cross
/// fastest, counted along the rays.
class SKYLINECORE_EXPORT RayFrame
{
public:
  /// azimuth: radians clockwise from grid north; sink: (1 - k) / 2R in 1/m, 0 for a flat body.
  RayFrame(const HeightField& field, const Grid& grid, double azimuth, double sink);

  /// True if the frame's lines are columns of the image: the field must be transposed then.
  static bool TakesColumns(const Grid& grid, double azimuth);

  const float* Heights = nullptr; ///< post (line 0, lane 0)
  std::ptrdiff_t LineStride = 0;  ///< floats to the next line along the rays, may be negative
  std::ptrdiff_t Lines = 0;       ///< lines of posts
  std::ptrdiff_t Lanes = 0;       ///< posts in a line
  bool Columns = false;           ///< lines are columns of the image
  bool Reversed = false;          ///< lines count from the north or east edge
  int Drift = 1;                  ///< +1 or -1: where the ray drifts, in lanes
  double Slant = 0.0;             ///< lanes of drift per line, 0 to 1
  double StepLength = 1.0;        ///< metres along the ray per line
  bool Against = false;           ///< the diagonals run against the drift
  float SinkPerLine2 = 0.0f;      ///< metres of sink per line squared
  std::vector<RayStep> Steps;     ///< [D] for D = 1 .. Lines - 1; [0] is all zero
  std::vector<SideStep> Sides;    ///< likewise
  std::vector<StepPlace> Places;  ///< likewise

  /// Whole lanes of drift after `lines` lines.
  std::ptrdiff_t DriftAfter(std::ptrdiff_t lines) const
  {
    return static_cast<std::ptrdiff_t>(this->Slant * static_cast<double>(lines));
  }

  /// The last step in which a ray of one of the `width` receivers from `lane` on may meet data.
  std::ptrdiff_t LastStep(std::ptrdiff_t lane, std::ptrdiff_t width) const;

  /// Image line of a frame line.
  std::ptrdiff_t ImageLine(std::ptrdiff_t line) const
  {
    return this->Reversed ? this->Lines - 1 - line : line;
  }

private:
  void FillSteps(double sinkPerLine2);
};

} // namespace skyline

#endif
