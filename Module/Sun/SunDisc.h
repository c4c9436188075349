// SPDX-License-Identifier: BSD-3-Clause
// The sun as a disc on the sphere, divided by azimuth.
#ifndef skyline_SunDisc_h
#define skyline_SunDisc_h

#include "SkylineCoreModule.h" // for the export macro

#include <vector>

namespace skyline
{

/// Limb darkening of a grey atmosphere in Eddington's approximation: at the angle with the cosine
/// mu on the surface of the sun, the intensity relative to the centre is
///   (2 + 3 mu) / 5 = 1 - u (1 - mu),  u = 3/5.
constexpr double EddingtonLimbDarkening = 0.6;

/// The disc of a sun. Angles in radians.
struct SunDisc
{
  double Azimuth = 0.0;   ///< of the centre, clockwise from grid north
  double Elevation = 0.0; ///< of the centre, -pi/2 to pi/2
  double Radius = 0.0;    ///< angular, 0 to pi/2
};

/// Half the width of the range of azimuths that a disc covers: asin(sin radius / cos elevation), or
/// pi if the zenith or the nadir lies inside the disc. Radians.
SKYLINECORE_EXPORT double HalfSwath(double elevation, double radius);

/// The part of the half circle from nadir to zenith that a disc covers in one azimuth. Elevations
/// are relative to that of the centre of the disc, so that they are accurate for the smallest disc.
/// Radians.
struct DiscChord
{
  double Middle = 0.0; ///< middle of the chord of the whole great circle, which may extend beyond
                       ///< the zenith
  double Half = 0.0;   ///< half the length of that chord
  double Low = 0.0;    ///< ends on this side of zenith and nadir; empty unless Low < High
  double High = 0.0;
};

/// The chord of a disc at an azimuth, which is relative to that of the centre.
SKYLINECORE_EXPORT DiscChord ChordOfDisc(const SunDisc& disc, double azimuthFromCentre);

/// The part of a disc between two azimuths, as a sum of chords. Computes what a horizon hides of
/// it.
class SKYLINECORE_EXPORT DiscSlice
{
public:
  /// Sets the azimuths [from, to], in radians relative to the azimuth of the centre, at most half a
  /// turn. Parts beyond the disc are left out. limbDarkening: u of the intensity 1 - u (1 - mu), 0
  /// to 1. The integrals are exact except for terms in radius^2.
  void Set(const SunDisc& disc, double from, double to, double limbDarkening);

  /// All light of the slice, without a horizon.
  double Whole() const { return this->Light; }

  /// The light hidden by a horizon that rises linearly from `first` at azimuth `from` to `last` at
  /// `to`, both in radians above the centre of the disc. Exactly 0 if no chord is cut, and Whole()
  /// if all chords are covered.
  double Hidden(double first, double last) const;

private:
  struct Sample
  {
    DiscChord Chord;
    double Place;  ///< position of its azimuth: 0 at `from`, 1 at `to`
    double Weight; ///< width of the azimuths that it represents, radians
    double Light;  ///< light of the whole chord
  };
  double Rise(double angle) const;
  double LightBelow(const DiscChord& chord, double angle) const;

  std::vector<Sample> Samples;
  double SinElevation = 0.0, CosElevation = 1.0;
  double Radius = 0.0;
  double LimbDarkening = 0.0;
  double Light = 0.0;
};

/// The azimuths (rising, in radians clockwise from grid north) whose horizons a SunAccumulator
/// needs, for suns of one radius whose centres lie between the given azimuths (azimuthMin <=
/// azimuthMax, any turn) and elevations: nodes an eighth of the half swath apart, over all swaths,
/// both ends included. One sun needs 17 nodes, or 25 around the circle if its disc contains the
/// zenith or the nadir, or only its azimuth if the radius is 0. With many suns, the nodes are at
/// least an eighth of MeanSunRadius apart.
SKYLINECORE_EXPORT std::vector<double> SunAzimuths(
  double azimuthMin, double azimuthMax, double elevationMin, double elevationMax, double radius);

} // namespace skyline

#endif
