// SPDX-License-Identifier: BSD-3-Clause
// The sun over a whole height field: its direction differs from post to post.
#ifndef skyline_SunField_h
#define skyline_SunField_h

#include "Geo/Georeference.h"
#include "SkylineCoreModule.h" // for the export macro
#include "Sun/RefinedLattice.h"
#include "Sun/UtcTime.h"

#include <cstddef>

namespace skyline
{

/// Interpolation of the sun between nodes may add this many degrees; the disc is a hundred times as
/// wide.
constexpr double SunFieldTolerance = 0.002;

/// The sun at a post, on the axes of the computation.
struct GridSun
{
  double Azimuth = 0.0;   ///< degrees, 0 up to 360, as Georeference::AxisAzimuthAt counts
  double Elevation = 0.0; ///< degrees, apparent (lifted by the air)
  double Radius = 0.0;    ///< degrees, of the disc
};

/// A direction on the axes of the computation: Georeference::AxisAzimuthAt counts from y towards x; z is
/// up.
struct SunVector
{
  double X = 0.0, Y = 0.0, Z = 1.0;
};

SunVector Mix(const SunVector& a, const SunVector& b, double fraction);

/// Sun directions of a height field at one time. They are computed at the nodes of a lattice of its
/// own, which is refined until interpolation keeps SunFieldTolerance, and interpolated between:
/// hundredths of a microsecond a post instead of microseconds.
class SKYLINECORE_EXPORT SunField
{
public:
  /// `time`: UTC. `meanHeight`: metres; its standard air refracts everywhere (a kilometre higher
  /// there is a tenth less of it, 0.01 degrees for a sun at 10 degrees), and the parallax is taken
  /// there. `ut1MinusUtc`: see SunEphemeris. The disc's radius is the one at the centre post.
  /// Throws std::invalid_argument without a place on a body or on another body than the Earth, and
  /// what SunEphemeris throws.
  SunField(
    const Georeference& place, const UtcTime& time, double meanHeight, double ut1MinusUtc = 0.0);

  /// The same sun over every post: azimuth from the image's +y axis (any number of turns), apparent
  /// elevation (-90 to 90) and the disc's radius (0 up to 90), degrees. Throws std::out_of_range.
  static SunField Constant(double azimuth, double elevation, double radius);

  /// The sun in one direction on the image. Where the directions over `place` are counted on the ground
  /// (Georeference::GroundAxes), that is another one at every post; elsewhere it is Constant's. Degrees,
  /// ranges and std::out_of_range as Constant; std::invalid_argument as Georeference::LonLatAt.
  static SunField OnImage(
    const Georeference& place, double azimuth, double elevation, double radius);

  /// The sun has one direction everywhere.
  bool Same() const { return this->Lattice.Nodes.size() == 1; }

  /// The sun at a post; fractions are allowed, posts beyond the edge get the edge's sun.
  GridSun At(double column, double row) const;

  /// Unit vectors to the sun, components as in SunVector, of the `count` posts
  /// (columnBegin + i, row).
  void Row(std::ptrdiff_t row, std::ptrdiff_t columnBegin, std::ptrdiff_t count, float* x, float* y,
    float* z) const;

  /// Degrees, of the disc.
  double Radius() const { return this->DiscRadius; }

  /// The narrowest arc that holds the azimuths of all posts: 0 <= first < 360, first <= last,
  /// degrees; `last` passes 360 where the arc crosses north. The full circle, 0 to 360, where the
  /// sun stands in the zenith of some post.
  void AzimuthBounds(double& first, double& last) const;

  /// Least and greatest apparent elevation (degrees) at the lattice's nodes.
  void ElevationBounds(double& least, double& greatest) const;

  /// Degrees: the greatest error of interpolation found when the lattice was made; below
  /// SunFieldTolerance unless the height field spans a large part of the globe.
  double InterpolationError() const { return this->Lattice.Error; }

private:
  SunField() = default;
  template <typename SunAt>
  void Fill(const Georeference& place, const SunAt& vectorAt);

  RefinedLattice<SunVector> Lattice; ///< one node: the same sun everywhere
  double DiscRadius = 0.0;           ///< degrees
};

} // namespace skyline

#endif
