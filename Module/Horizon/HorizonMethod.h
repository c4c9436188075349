// SPDX-License-Identifier: BSD-3-Clause
// One interface for every way to find horizons.
#ifndef skyline_HorizonMethod_h
#define skyline_HorizonMethod_h

#include "HeightField/Grid.h"
#include "HeightField/HeightField.h"
#include "Horizon/PyramidSettings.h"
#include "Horizon/RayFrame.h"
#include "Shared/Constants.h"

#include <cstddef>
#include <memory>

namespace skyline
{

class HeightPyramid;

enum class HorizonMethodKind
{
  Exact,  ///< every edge that can matter, the others skipped under bounds
  Fast,   ///< the same search with FastTolerance: never above the horizon, below it by that at most
  Sweep,  ///< the line sweeps of Timonen & Westerholm 2010, sections 4 and 5, as published
  Pyramid ///< the pyramid of Snyder & Nowrouzezahrai 2008, section 4: smooth, off by a degree
};

/// Radians by which Fast may miss, certified for every surface and height: 0.25 degrees. On terrain
/// the rmse stays below 0.03 degrees (Studies/CompareHorizons.cxx prints it).
constexpr double FastTolerance = 0.25 * RadiansPerDegree;

struct HorizonSettings
{
  HorizonMethodKind Method = HorizonMethodKind::Exact;
  Surface Shape = Surface::Triangles; ///< Sweep and Pyramid take Triangles, mean their own samples
  double Sink = 0.0; ///< (1 - k) / 2R in 1/m: how a post sinks with its distance squared; 0 flat
  double Tolerance = 0.0;  ///< radians by which Exact may fall short of the horizon, 0 or more
  PyramidSettings Pyramid; ///< of Pyramid alone
};

/// Finds the slopes (tangents of the elevation) of the horizons of all posts, azimuth by azimuth:
/// SetAzimuth (one thread), Prepare for the whole of [0, PrepareCount()) (any threads, disjoint
/// ranges), then Find for the lines wanted (any threads, disjoint ranges). The same ranges give the
/// same bits, on whatever thread.
class HorizonMethod
{
public:
  virtual ~HorizonMethod() = default;

  /// The azimuth of the calls that follow: degrees clockwise from grid north. grid: the field's
  /// posts, with the spacing that holds where the receivers are.
  virtual void SetAzimuth(const Grid& grid, double azimuth) = 0;

  /// Promises, between SetAzimuth and Prepare, that Find will be asked for no other lines and lanes, so
  /// that less needs to be prepared. Without it for all.
  virtual void SetReceivers(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd,
    std::ptrdiff_t laneBegin, std::ptrdiff_t laneEnd)
  {
    (void)lineBegin;
    (void)lineEnd;
    (void)laneBegin;
    (void)laneEnd;
  }

  /// Independent pieces of the preparation of an azimuth.
  virtual std::ptrdiff_t PrepareCount() const = 0;
  virtual void Prepare(std::ptrdiff_t begin, std::ptrdiff_t end) = 0;

  /// The horizon slopes of lanes [laneBegin, laneEnd) of frame lines [lineBegin, lineEnd), to
  /// slopes[(line - lineBegin) * stride + lane - laneBegin]; lines are those of Frame(). The row of
  /// slopes is written up to a multiple of 32 lanes, so stride is at least that. Where the receiver
  /// is missing, the slope means nothing.
  virtual void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* slopes, std::ptrdiff_t stride) const = 0;

  const RayFrame& Frame() const { return *this->Ray; }

protected:
  std::unique_ptr<RayFrame> Ray;
};

/// The method of the settings over a closed field, which must outlive it and be transposed before an
/// azimuth whose frame takes columns. pyramid: as HorizonPyramid takes it; of Pyramid alone.
/// std::invalid_argument for a surface that the method does not know.
std::unique_ptr<HorizonMethod> MakeHorizonMethod(const HeightField& field,
  const HorizonSettings& settings, std::shared_ptr<const HeightPyramid> pyramid = nullptr);

} // namespace skyline

#endif
