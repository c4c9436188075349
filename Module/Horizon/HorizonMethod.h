// SPDX-License-Identifier: BSD-3-Clause
// The common interface of all methods that find horizons.
#ifndef skyline_HorizonMethod_h
#define skyline_HorizonMethod_h

#include "HeightField/Grid.h"
#include "HeightField/HeightField.h"
#include "Horizon/RayFrame.h"
#include "Shared/Constants.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <memory>

namespace skyline
{

class HeightPyramid;

enum class HorizonMethodKind
{
  Exact,  ///< visits every edge that can matter; bounds exclude the others
  Fast,   ///< the same search with FastTolerance: never above the horizon, and at most that much
          ///< below it
  Sweep,  ///< the line sweep of Timonen & Westerholm 2010, sections 4 and 5, as published
  Pyramid ///< the pyramid of Snyder & Nowrouzezahrai 2008, section 4: smooth, off by about a degree
};

/// Greatest error of Fast in radians, guaranteed for all surfaces and heights: 0.25 degrees. On
/// terrain the root mean square error stays below 0.03 degrees (Studies/CompareHorizons.cxx prints
/// it).
constexpr double FastTolerance = 0.25 * RadiansPerDegree;

/// The parameters of the pyramid of Snyder & Nowrouzezahrai 2008 (SN08). The defaults are those of
/// SN08: k = 4 (section 7), lambda = 1 (section 4), o = 2 (figure 6).
struct PyramidSettings
{
  double LevelStep = 4.0;   ///< k: levels per octave, 1 to 16; more are smoother and slower
  double LevelOffset = 2.0; ///< o: octaves by which finer levels are read, 0 or more
  double Distance = 1.0;    ///< lambda: distance at which a level is read, in its samples; above 0
  /// Use the B-spline over log distance, as for key lights. If false, the greatest angle of all
  /// levels is taken, which is cheaper and good enough for environments (section 6).
  bool Spline = true;
};

struct HorizonSettings
{
  HorizonMethodKind Method = HorizonMethodKind::Exact;
  Surface Shape = Surface::Triangles; ///< Sweep and Pyramid require Triangles and use their own
                                      ///< samples
  double CurvatureDrop =
    0.0; ///< (1 - k) / 2R in 1/m: a post at distance d is lowered by CurvatureDrop d^2; 0: flat
  double Tolerance = 0.0;  ///< radians by which Exact may lie below the horizon, 0 or more
  PyramidSettings Pyramid; ///< for Pyramid only
};

/// Finds the slopes (tangents of the elevation) of the horizons of all posts, azimuth by azimuth.
/// For each azimuth call SetAzimuth (in one thread), then Prepare for all of [0, PrepareCount())
/// (any threads, disjoint ranges), then Find for the lines needed (any threads, disjoint ranges).
/// The same ranges give the same bits on any thread.
class SKYLINECORE_EXPORT HorizonMethod
{
public:
  virtual ~HorizonMethod() = default;

  /// Sets the azimuth of the following calls: radians clockwise from grid north. grid: the posts of
  /// the field, with the spacing that holds at the receivers.
  virtual void SetAzimuth(const Grid& grid, double azimuth) = 0;

  /// Declares, between SetAzimuth and Prepare, that Find will be called only for these lines and
  /// lanes, so that less needs to be prepared. The default is all lines and lanes.
  virtual void SetReceivers(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd,
    std::ptrdiff_t laneBegin, std::ptrdiff_t laneEnd)
  {
    (void)lineBegin;
    (void)lineEnd;
    (void)laneBegin;
    (void)laneEnd;
  }

  /// Number of independent pieces of work to prepare an azimuth.
  virtual std::ptrdiff_t PrepareCount() const = 0;
  virtual void Prepare(std::ptrdiff_t begin, std::ptrdiff_t end) = 0;

  /// Computes the horizon slopes of lanes [laneBegin, laneEnd) of the lines [lineBegin, lineEnd) of
  /// Frame() and writes them to slopes[(line - lineBegin) * stride + lane - laneBegin]. Each row of
  /// slopes is written up to a multiple of 32 lanes, so that stride must be at least that. The
  /// slope of a missing receiver has no meaning.
  virtual void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* slopes, std::ptrdiff_t stride) const = 0;

  const RayFrame& Frame() const { return *this->Ray; }

protected:
  std::unique_ptr<RayFrame> Ray;
};

/// Makes the method of the settings for a closed field. The field must outlive the method, and must
/// be transposed before an azimuth whose frame takes columns. pyramid: see HorizonPyramid; for
/// Pyramid only. Throws std::invalid_argument for a surface that the method does not support.
SKYLINECORE_EXPORT std::unique_ptr<HorizonMethod> MakeHorizonMethod(const HeightField& field,
  const HorizonSettings& settings, std::shared_ptr<const HeightPyramid> pyramid = nullptr);

} // namespace skyline

#endif
