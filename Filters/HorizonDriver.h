// SPDX-License-Identifier: BSD-3-Clause
// The loop over azimuths: finds the horizons of a height field and passes them to a consumer.
#ifndef skyline_HorizonDriver_h
#define skyline_HorizonDriver_h

#include "Horizon/Accumulator.h"
#include "Horizon/HorizonMethod.h"
#include "HorizonInput.h"
#include "Shared/Doubt.h"
#include "SkylineFiltersModule.h" // for the export macro
#include "SlopeSearch.h"

#include <functional>
#include <string>
#include <vector>

namespace skyline
{

class PyramidCache;
class RayFan;

/// How the azimuths of a run are counted, clockwise from the +y axis of the image: on the ground,
/// as sums over the sky need them, or on the image (Georeference::GridAzimuthAt), as arrays of
/// horizons have them.
enum class AzimuthAxes
{
  Ground,
  Image
};

/// Finds horizons for a list of azimuths, in radians. Results do not depend on the number of
/// threads.
class SKYLINEFILTERS_EXPORT HorizonDriver
{
public:
  /// `settings` says how horizons are found; its CurvatureDrop must be that of the input
  /// (HorizonInput::CurvatureDrop), or 0 for a flat field. `pyramids` keeps the pyramid of the
  /// method Pyramid; null: one is built for each run. `input` and `pyramids` must outlive the
  /// driver.
  HorizonDriver(
    HorizonInput& input, const HorizonSettings& settings, PyramidCache* pyramids = nullptr);

  HorizonInput& Input() { return this->Surface; }
  const HorizonInput& Input() const { return this->Surface; }
  const HorizonSettings& UsedSettings() const { return this->Settings; }

  /// Called with the part done, 0 to 1. Returns false to stop.
  std::function<bool(double)> Progress;

  /// Passes each azimuth to the consumer; each stands for `width` radians. On a distorted map, the
  /// methods exact and fast use the metric of each post (GroundMetric.h); the others use that of
  /// the centre, or those of bands of rows. Returns false if stopped.
  bool Run(const std::vector<double>& azimuths, double width, Accumulator& consumer,
    AzimuthAxes axes = AzimuthAxes::Ground);

  /// The same with another method over Input().Field() than that of the settings. The method has
  /// one metric, or those of bands of rows.
  bool Run(HorizonMethod& method, const std::vector<double>& azimuths, double width,
    Accumulator& consumer, AzimuthAxes axes = AzimuthAxes::Ground);

  /// Throws std::runtime_error if the machine lacks the memory that a filter is about to allocate:
  /// `floats` per post, and the transposed heights if the azimuths need them. `what` is the subject
  /// of the error message.
  void DemandFloats(
    const char* what, std::ptrdiff_t floats, const std::vector<double>& azimuths) const;

  /// The warnings to raise when the filter has finished, each of them once.
  const std::vector<Doubt>& Doubts() const { return this->Found; }
  void AddDoubt(const Doubt& doubt);

  /// Adds the warning of HorizonInput::OneMetricDoubt, if there is one.
  void DoubtOneMetric(const std::string& what, const PostMetric& used);

  double PrepareSeconds = 0.0, SearchSeconds = 0.0; ///< totals of all runs
  int PyramidBuilds = 0;

private:
  bool TakesColumns(const std::vector<double>& azimuths) const;
  bool FollowsGround() const;
  bool Goes(double done) const;
  void Prepare(HorizonMethod& method, const Grid& grid, double azimuth, const PostRegion& region);
  bool RunFans(HorizonMethod& method, const std::vector<double>& azimuths, double width,
    Accumulator& consumer, AzimuthAxes axes);
  void RunRay(HorizonMethod& method, const RayFan& fan, Accumulator& consumer);
  void Finish(Accumulator& consumer) const;

  HorizonInput& Surface;
  HorizonSettings Settings;
  PyramidCache* Pyramids;
  std::vector<Doubt> Found;
};

} // namespace skyline

#endif
