// SPDX-License-Identifier: BSD-3-Clause
// The sun as a disc on the sphere, cut azimuth by azimuth.
#ifndef skyline_SunDisc_h
#define skyline_SunDisc_h

#include "SkylineCoreModule.h" // for the export macro

#include <vector>

namespace skyline
{

/// Limb darkening of a grey atmosphere in Eddington's approximation: the intensity at the angle
/// with cosine mu on the sun's surface is (2 + 3 mu) / 5 = 1 - u (1 - mu) of the centre's, u = 3/5.
constexpr double EddingtonLimbDarkening = 0.6;

/// A sun; radians.
struct SunDisc
{
  double Azimuth = 0.0;   ///< of the centre, clockwise from grid north
  double Elevation = 0.0; ///< of the centre, -pi/2 to pi/2
  double Radius = 0.0;    ///< angular, 0 up to pi/2
};

/// Half the width of the azimuths that a disc covers: asin(sin radius / cos elevation), or pi if
/// the zenith or the nadir lies inside it. Radians.
SKYLINECORE_EXPORT double HalfSwath(double elevation, double radius);

/// What a disc covers of the half circle from nadir to zenith in one azimuth. Elevations here are
/// less that of the disc's centre, so that the smallest disc keeps its digits. Radians.
struct DiscChord
{
  double Middle = 0.0; ///< of the chord of the whole great circle, which may reach over the zenith
  double Half = 0.0;   ///< half its length
  double Low = 0.0;    ///< ends on this side of zenith and nadir; empty unless Low < High
  double High = 0.0;
};

/// The chord of a disc at an azimuth, given from that of its centre.
SKYLINECORE_EXPORT DiscChord ChordOfDisc(const SunDisc& disc, double azimuthFromCentre);

/// The part of a disc between two azimuths as a sum of chords, and what a horizon hides of it.
class SKYLINECORE_EXPORT DiscSlice
{
public:
  /// The azimuths [from, to], radians from the centre's azimuth, at most half a turn; the parts
  /// beyond the disc are left out. limbDarkening: u of the intensity 1 - u (1 - mu), 0 to 1; its
  /// integrals are exact but for terms in radius^2.
  void Set(const SunDisc& disc, double from, double to, double limbDarkening);

  /// All light of the slice.
  double Whole() const { return this->Light; }

  /// The light hidden by a horizon that rises linearly from `first` at azimuth `from` to `last` at
  /// `to`: radians above the disc's centre. Exactly 0 if no chord is cut, Whole() if all are
  /// covered.
  double Hidden(double first, double last) const;

private:
  struct Sample
  {
    DiscChord Chord;
    double Place;  ///< of its azimuth, 0 at `from`, 1 at `to`
    double Weight; ///< width of azimuths it stands for, radians
    double Light;  ///< of the whole chord
  };
  double Rise(double angle) const;
  double LightBelow(const DiscChord& chord, double angle) const;

  std::vector<Sample> Samples;
  double SinElevation = 0.0, CosElevation = 1.0;
  double Radius = 0.0;
  double LimbDarkening = 0.0;
  double Light = 0.0;
};

/// The azimuths (rising, radians clockwise from grid north) whose horizons a SunAccumulator needs
/// for suns with centres between the given azimuths (azimuthMin <= azimuthMax, any turn) and
/// elevations, and one radius: nodes a quarter of the disc's half swath apart, over all swaths,
/// both ends included. One sun: 9 nodes, or 25 around the circle if its disc holds the zenith or
/// nadir, or its azimuth alone if the radius is 0. With many suns the nodes are no closer than a
/// quarter of the mean sun's radius.
SKYLINECORE_EXPORT std::vector<double> SunAzimuths(
  double azimuthMin, double azimuthMax, double elevationMin, double elevationMax, double radius);

} // namespace skyline

#endif
