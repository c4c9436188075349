// SPDX-License-Identifier: BSD-3-Clause
// The light of one azimuth swath of a light map above any horizon, onto any plane: Timonen &
// Westerholm 2010, equations 6 and 7, in a form that is exact.
#ifndef skyline_LightTable_h
#define skyline_LightTable_h

#include "Sky/LightMap.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <vector>

namespace skyline
{

/// A light map and how it stands.
struct TurnedLightMap
{
  LightMap Map;
  double Rotation = 0.0;               ///< radians clockwise about the vertical
  double Scale[3] = { 1.0, 1.0, 1.0 }; ///< factors on red, green and blue, 0 or more
};

/// A piece of a swath: azimuths (radians, clockwise from grid north) and the weight that the light
/// has there, linear from `begin` to `end`.
struct SwathPiece
{
  double Begin = 0.0, End = 0.0;
  double WeightAtBegin = 1.0, WeightAtEnd = 1.0;
};

/// What a swath of a light map sends to a plane of slopes ge, gn (rise per metre to the east and
/// north) from above an elevation e. The plane's normal is nz (-ge, -gn, 1), and the light, summed
/// over the swath's azimuths a and the elevations u from e to the zenith, is
///   nz [ Z(e) - ge X(e) - gn Y(e) ],    Z = Int Int L sin u cos u,  X = Int Int L cos^2 u sin a,
///                                       Y = Int Int L cos^2 u cos a.
/// These three integrals a colour replace the paper's table over (normal angle, horizon angle): the
/// plane's limits only move e. Inside a row of the map, where L does not change with u,
///   Z(e) = Z0 + Z1 cos^2 e,   X(e) = X0 + X1 D(e),   Y(e) = Y0 + Y1 D(e),
///   D(e) = (pi/2 - e) - sin e cos e,
/// so with a line of coefficients for each row the light is exact at every elevation, and a disc of
/// any size keeps its edge. Pixels that the swath cuts count by the part inside.
class SKYLINECORE_EXPORT LightTable
{
public:
  /// Floats of a line: Z0, Z1, X0, X1, Y0, Y1 with four floats each (red, green, blue, nothing).
  static constexpr std::ptrdiff_t LineSize = 24;

  /// Fills the table. The pieces may reach over any number of turns; `piecesEnd` is past the last.
  void Build(
    const TurnedLightMap& light, const SwathPiece* piecesBegin, const SwathPiece* piecesEnd);

  /// Lines from the zenith down to the one that holds the horizon.
  std::ptrdiff_t LineCount() const { return this->Count; }
  /// Lines in a radian of zenith angle: the line of a zenith angle z is floor(z LinesPerRadian()).
  double LinesPerRadian() const { return this->PerRadian; }
  const float* Lines() const { return this->Values.data(); }

  /// No light anywhere: the swath can be left out.
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
