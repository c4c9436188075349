// SPDX-License-Identifier: BSD-3-Clause
// Wedges of visible sky between two azimuths as spherical harmonics: Snyder & Nowrouzezahrai
// (2008), SN08 for short, section 5. Coefficients are those of SphericalHarmonics.h. Azimuths are
// in radians clockwise from north; horizons are elevations in radians.
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

/// The sky above a horizon of constant elevation in a swath of the width `width`, centred at
/// `azimuth`. Closed form, exact for any width. `wedge` receives bands * bands coefficients; bands:
/// 1 to 8.
///
/// The accumulators sum these wedges. They need no neighbour and no table, and on real terrain they
/// are closer to the true visibility than the linear wedge of SN08 if there are 5 azimuths or more
/// (Documentation/sn08.md).
void StepWedge(int bands, double azimuth, double width, double horizon, double* wedge);

/// The wedge of SN08, equation 8: the horizon varies linearly from `from` at `azimuth` to `to` at
/// azimuth + width. Closed form over elevation, Gauss-Legendre quadrature over azimuth in panels of
/// half a radian. The error is less than 1e-12, measured against four times as many panels. width:
/// 0 to 2 pi.
void LinearWedge(int bands, double azimuth, double width, double from, double to, double* wedge);

/// The tables of SN08: linear wedges of one width from azimuth 0 on, for 256 horizons from 0 to 90
/// degrees, with bilinear interpolation.
class WedgeTable
{
public:
  static constexpr int Elevations = 256;

  /// bands: 1 to 8. width: radians between azimuths.
  WedgeTable(int bands, double width);

  int Bands() const { return this->Count; }
  double Width() const { return this->Extent; }

  /// Adds the wedge between the azimuths `azimuth` and azimuth + width to bands * bands sums.
  void AddInterior(double azimuth, double from, double to, double* sums) const;

  /// Adds the half wedges at the ends of a partial swath: before the first azimuth the horizon
  /// falls from the zenith within half a width, and after the last azimuth it rises to the zenith.
  void AddStart(double azimuth, double horizon, double* sums) const;
  void AddEnd(double azimuth, double horizon, double* sums) const;

private:
  void AddTurned(double azimuth, const double* wedge, double* sums) const;

  int Count;
  double Extent;
  std::vector<float> Interior;   // [from][to][coefficient]
  std::vector<float> Start, End; // [horizon][coefficient], from azimuth 0 on
};

/// The tables made so far, by bands and width. Not thread-safe.
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
