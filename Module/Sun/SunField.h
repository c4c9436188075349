// SPDX-License-Identifier: BSD-3-Clause
// The sun over a whole height field, where its direction differs from post to post.
#ifndef skyline_SunField_h
#define skyline_SunField_h

#include "Geo/Georeference.h"
#include "SkylineCoreModule.h" // for the export macro
#include "Sun/RefinedLattice.h"
#include "Sun/UtcTime.h"

#include <cstddef>

namespace skyline
{

/// Largest error in degrees that interpolation of the sun between nodes may cause. The disc is a
/// hundred times as wide.
constexpr double SunFieldTolerance = 0.002;

/// The sun at a post, on the axes of the computations.
struct GridSun
{
  double Azimuth = 0.0;   ///< degrees, from 0 to below 360, see Georeference::AxisAzimuthAt
  double Elevation = 0.0; ///< degrees, apparent (lifted by the air)
  double Radius = 0.0;    ///< degrees, angular radius of the disc
};

/// A direction on the axes of the computations: x and y are horizontal, Georeference::AxisAzimuthAt
/// counts azimuths from y towards x, and z points up.
struct SunVector
{
  double X = 0.0, Y = 0.0, Z = 1.0;
};

SunVector Mix(const SunVector& a, const SunVector& b, double fraction);

/// Directions to the sun over a height field at one time. They are computed at the nodes of a
/// lattice, which is refined until interpolation keeps SunFieldTolerance, and interpolated in
/// between. This takes hundredths of a microsecond per post instead of microseconds.
class SKYLINECORE_EXPORT SunField
{
public:
  /// `time`: UTC. `meanHeight`: metres; the standard air and the parallax at this height are used
  /// everywhere (a kilometre higher, refraction is a tenth less: 0.01 degrees for a sun at 10
  /// degrees). `ut1MinusUtc`: see SunEphemeris. The radius of the disc is that at the centre
  /// post. Throws std::invalid_argument without a place on a body or on a body other than the
  /// Earth, and what SunEphemeris throws.
  SunField(
    const Georeference& place, const UtcTime& time, double meanHeight, double ut1MinusUtc = 0.0);

  /// The same sun at all posts, in degrees: azimuth from the +y axis of the image (any number of
  /// turns), apparent elevation (-90 to 90) and radius of the disc (0 to below 90). Throws
  /// std::out_of_range for other values.
  static SunField Constant(double azimuth, double elevation, double radius);

  /// The sun in one direction on the image. If azimuths over `place` are counted on the ground
  /// (Georeference::GroundAxes), its azimuth differs from post to post; otherwise the result is
  /// that of Constant. Units, ranges and std::out_of_range as for Constant; std::invalid_argument
  /// as for Georeference::LonLatAt.
  static SunField OnImage(
    const Georeference& place, double azimuth, double elevation, double radius);

  /// Returns true if the sun has the same direction at all posts.
  bool Same() const { return this->Lattice.Nodes.size() == 1; }

  /// The sun at a post. Fractions are allowed. Posts beyond the edge get the sun at the edge.
  GridSun At(double column, double row) const;

  /// Unit vectors to the sun, with the components of SunVector, for the `count` posts
  /// (columnBegin + i, row).
  void Row(std::ptrdiff_t row, std::ptrdiff_t columnBegin, std::ptrdiff_t count, float* x, float* y,
    float* z) const;

  /// Angular radius of the disc, degrees.
  double Radius() const { return this->DiscRadius; }

  /// The narrowest arc that contains the azimuths at all posts, in degrees: 0 <= first < 360, first
  /// <= last. `last` exceeds 360 if the arc crosses north. The result is the full circle, 0 to 360,
  /// if the sun stands in the zenith of some post.
  void AzimuthBounds(double& first, double& last) const;

  /// Least and greatest apparent elevation (degrees) at the nodes of the lattice.
  void ElevationBounds(double& least, double& greatest) const;

  /// The greatest error of interpolation, in degrees, that was found when the lattice was made. It
  /// is below SunFieldTolerance unless the height field covers a large part of the globe.
  double InterpolationError() const { return this->Lattice.Error; }

private:
  SunField() = default;
  template <typename SunAt>
  void Fill(const Georeference& place, const SunAt& vectorAt);

  RefinedLattice<SunVector> Lattice; ///< one node: the same sun at all posts
  double DiscRadius = 0.0;           ///< degrees
};

} // namespace skyline

#endif
