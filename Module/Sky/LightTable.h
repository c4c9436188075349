// SPDX-License-Identifier: BSD-3-Clause
// The light that comes from one swath of a light map above any horizon and falls on any plane:
// Timonen & Westerholm 2010, equations 6 and 7, in an exact form.
#ifndef skyline_LightTable_h
#define skyline_LightTable_h

#include "Sky/LightMap.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <vector>

namespace skyline
{

/// A light map with its orientation and scale.
struct TurnedLightMap
{
  LightMap Map;
  double Rotation = 0.0;               ///< radians clockwise about the vertical
  double Scale[3] = { 1.0, 1.0, 1.0 }; ///< factors on red, green and blue, 0 or more
};

/// A piece of a swath: azimuths (radians, clockwise from grid north) and the weight of the light
/// there, which is linear from `begin` to `end`.
struct SwathPiece
{
  double Begin = 0.0, End = 0.0;
  double WeightAtBegin = 1.0, WeightAtEnd = 1.0;
};

/// The light that a swath of a light map sends to a plane with the slopes ge, gn (rise per metre to
/// the east and to the north) from above an elevation e. The normal of the plane is nz (-ge, -gn,
/// 1). Integrated over the azimuths a of the swath and the elevations u from e to the zenith, the
/// light is
///   nz [ Z(e) - ge X(e) - gn Y(e) ],    Z = Int Int L sin u cos u,  X = Int Int L cos^2 u sin a,
///                                       Y = Int Int L cos^2 u cos a.
/// These three integrals per colour replace the table of the paper over (normal angle, horizon
/// angle): the limits of the plane only change e. Inside a row of the map, where L does not depend
/// on u,
///   Z(e) = Z0 + Z1 cos^2 e,   X(e) = X0 + X1 D(e),   Y(e) = Y0 + Y1 D(e),
///   D(e) = (pi/2 - e) - sin e cos e,
/// so that, with one line of coefficients for each row, the light is exact at every elevation, and
/// a disc of any size keeps its edge. Pixels that the swath cuts count with the part inside.
class SKYLINECORE_EXPORT LightTable
{
public:
  /// Floats per line: Z0, Z1, X0, X1, Y0, Y1 with four floats each (red, green, blue, unused).
  static constexpr std::ptrdiff_t LineSize = 24;

  /// Computes the table. The pieces may span any number of turns; `piecesEnd` is past the last
  /// piece.
  void Build(
    const TurnedLightMap& light, const SwathPiece* piecesBegin, const SwathPiece* piecesEnd);

  /// Number of lines from the zenith down to the line that contains the horizon.
  std::ptrdiff_t LineCount() const { return this->Count; }
  /// Lines per radian of zenith angle: a zenith angle z is in line floor(z LinesPerRadian()).
  double LinesPerRadian() const { return this->PerRadian; }
  const float* Lines() const { return this->Values.data(); }

  /// Returns true if the swath has no light, so that it can be skipped.
  bool Dark() const { return !this->Lit; }

private:
  void AddColumns(const TurnedLightMap& light, const SwathPiece& piece);

  struct ColumnWeight
  {
    std::ptrdiff_t Column;
    double Plain, Sine, Cosine; ///< integrals of the weight times 1, sin a, cos a over the column
  };

  std::ptrdiff_t Count = 0;
  double PerRadian = 1.0;
  bool Lit = false;
  std::vector<float> Values;
  std::vector<ColumnWeight> Columns;
};

} // namespace skyline

#endif
