// SPDX-License-Identifier: BSD-3-Clause
// The geometry of one azimuth: every ray of the azimuth meets the edges of the surface at the same
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

/// Unit vector (east, north) of a grid azimuth in radians clockwise from north. Exact for multiples
/// of 45 degrees times RadiansPerDegree. Throws std::invalid_argument for an azimuth that is not
/// finite.
struct Direction
{
  double East, North;
};
SKYLINECORE_EXPORT Direction DirectionOfAzimuth(double azimuth);

/// Columns and rows per metre along an azimuth on a grid; radians and errors as in
/// DirectionOfAzimuth.
struct PostsPerMetre
{
  double Columns, Rows;
};
PostsPerMetre RayOfAzimuth(const Grid& grid, double azimuth);

/// What a ray meets from line D - 1 to line D ahead of its receiver. `trail` and `lead` are the two
/// posts of a line on both sides of the ray; the ray drifts towards the lead post. A slope, in
/// metres of height per line, is  a * A + b * B - drop,  where A and B are heights above the
/// receiver.
struct RayStep
{
  std::int32_t Lane;                ///< lane of the trail post on line D, relative to that of the
                                    ///< receiver
  std::int32_t Next;                ///< 1: in this step the ray crosses to the next column of cells
  float RowTrail, RowLead, RowDrop; ///< the edge from trail to lead on line D
  float MidNear, MidFar, MidDrop; ///< between the lines, weights of the posts on lines D - 1 and D:
                                  ///< the cell's diagonal, or the column edge if Next
};

/// The diagonals of both cells of a step with Next, on a surface whose diagonals run against the
/// drift.
struct SideStep
{
  float LeftNear, LeftFar, LeftDrop;
  float RightNear, RightFar, RightDrop;
};

/// Positions within a step, for the bilinear surface and for missing posts.
struct StepPlace
{
  double Part;    ///< fraction of the way from trail to lead on line D; 0: exactly the trail post
  double MidLine; ///< lines from the receiver to the edge between the lines
};

/// The frame of an azimuth. Lines are rows or columns of the image, whichever the rays cross
/// faster, and are counted along the rays.
class SKYLINECORE_EXPORT RayFrame
{
public:
  /// azimuth: radians clockwise from grid north; drop: (1 - k) / 2R in 1/m, 0 for a flat body.
  RayFrame(const HeightField& field, const Grid& grid, double azimuth, double drop);

  /// Returns true if the lines of the frame are columns of the image, so that the field must be
  /// transposed.
  static bool TakesColumns(const Grid& grid, double azimuth);

  const float* Heights = nullptr; ///< post (line 0, lane 0)
  std::ptrdiff_t LineStride = 0;  ///< floats to the next line along the rays; may be negative
  std::ptrdiff_t Lines = 0;       ///< lines of posts
  std::ptrdiff_t Lanes = 0;       ///< posts per line
  bool Columns = false;           ///< lines are columns of the image
  bool Reversed = false;          ///< lines are counted from the northern or eastern edge
  int Drift = 1;                  ///< +1 or -1: direction in lanes to which the ray drifts
  double Slant = 0.0;             ///< lanes of drift per line, 0 to 1
  double StepLength = 1.0;        ///< metres along the ray per line
  bool Against = false;           ///< the diagonals run against the drift
  float DropPerLine2 = 0.0f;      ///< drop in metres per squared number of lines
  std::vector<RayStep> Steps;     ///< [D] for D = 1 .. Lines - 1; [0] is all zero
  std::vector<SideStep> Sides;    ///< likewise
  std::vector<StepPlace> Places;  ///< likewise

  /// Whole lanes of drift after `lines` lines.
  std::ptrdiff_t DriftAfter(std::ptrdiff_t lines) const
  {
    return static_cast<std::ptrdiff_t>(this->Slant * static_cast<double>(lines));
  }

  /// The last step in which a ray of one of the `width` receivers, starting at `lane`, may meet
  /// data.
  std::ptrdiff_t LastStep(std::ptrdiff_t lane, std::ptrdiff_t width) const;

  /// The line of the image that corresponds to a line of the frame.
  std::ptrdiff_t ImageLine(std::ptrdiff_t line) const
  {
    return this->Reversed ? this->Lines - 1 - line : line;
  }

private:
  void FillSteps(double dropPerLine2);
};

} // namespace skyline

#endif
