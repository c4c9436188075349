// SPDX-License-Identifier: BSD-3-Clause
// Wedges of visible sky between two azimuths as spherical harmonics: Snyder & Nowrouzezahrai 2008
// (SN08), section 5. Coefficients as in SphericalHarmonics.h, azimuths in radians clockwise from
// north, horizons in radians of elevation.
#ifndef skyline_VisibilityWedge_h
#define skyline_VisibilityWedge_h

#include "Harmonics/ElevationIntegral.h"
#include "Harmonics/SwathMean.h"

#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace skyline
{

/// The sky above a horizon of one elevation over a swath about `azimuth`, `width` wide: closed form,
/// exact for any width. `wedge` gets bands * bands coefficients. 1 to 8 bands.
///
/// This is what the accumulators sum: no neighbour, no table, and on real terrain closer to the truth
/// than SN08's linear wedge from 5 azimuths on (Documentation/sn08.md).
void StepWedge(int bands, double azimuth, double width, double horizon, double* wedge);

/// SN08's wedge, equation 8: the horizon goes linearly from `from` at `azimuth` to `to` at azimuth +
/// width. Closed form over elevation, Gauss-Legendre over azimuth in panels of half a radian: errs by
/// less than 1e-12, found against four times as many panels. width: 0 to 2 pi.
void LinearWedge(int bands, double azimuth, double width, double from, double to, double* wedge);

/// SN08's tables of linear wedges of one width, from azimuth 0 on: horizons of 0 to 90 degrees, 256
/// of them, bilinear between.
class WedgeTable
{
public:
  static constexpr int Elevations = 256;

  /// bands: 1 to 8; width: radians between azimuths.
  WedgeTable(int bands, double width);

  int Bands() const { return this->Count; }
  double Width() const { return this->Extent; }

  /// Adds the wedge between the azimuths `azimuth` and azimuth + width to bands * bands sums.
  void AddInterior(double azimuth, double from, double to, double* sums) const;

  /// Adds the half wedges at the ends of a partial swath: before the first azimuth the horizon comes
  /// down from the zenith over half a width, after the last it goes up to it.
  void AddStart(double azimuth, double horizon, double* sums) const;
  void AddEnd(double azimuth, double horizon, double* sums) const;

private:
  void AddTurned(double azimuth, const double* wedge, double* sums) const;

  int Count;
  double Extent;
  std::vector<float> Interior;   // [from][to][coefficient]
  std::vector<float> Start, End; // [horizon][coefficient], from azimuth 0 on
};

/// The tables made so far, by bands and width; not for many threads at a time.
class WedgeTables
{
public:
  std::shared_ptr<const WedgeTable> Get(int bands, double width);
  std::size_t Made() const { return this->Tables.size(); }

private:
  std::map<std::pair<int, double>, std::shared_ptr<const WedgeTable>> Tables;
};

} // namespace skyline

#endif
