// SPDX-License-Identifier: BSD-3-Clause
// The loop over azimuths: it finds the horizons of a height field and feeds them to what consumes them.
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

/// How the azimuths of a run count, clockwise from the image's +y axis: on the ground, as sums over the
/// sky need them, or on the image (Georeference::GridAzimuthAt), as the arrays of horizons have them.
enum class AzimuthAxes
{
  Ground,
  Image
};

/// Azimuths are radians. Nothing here depends on the number of threads.
class SKYLINEFILTERS_EXPORT HorizonDriver
{
public:
  /// settings: how horizons are found; Sink belongs to the input (HorizonInput::Sink). pyramids: keeps
  /// the pyramid of the method of that name; null: one is built for each run. Input and pyramids must
  /// outlive the driver.
  HorizonDriver(
    HorizonInput& input, const HorizonSettings& settings, PyramidCache* pyramids = nullptr);

  HorizonInput& Input() { return this->Surface; }
  const HorizonInput& Input() const { return this->Surface; }
  const HorizonSettings& UsedSettings() const { return this->Settings; }

  /// Told the part done, 0 to 1; returns false to stop.
  std::function<bool(double)> Progress;

  /// Feeds the consumer every azimuth, each standing for `width` radians. On a distorted map exact and
  /// fast take the metric of every post (GroundMetric.h), the others that of the centre, or of bands of
  /// rows. False if stopped.
  bool Run(const std::vector<double>& azimuths, double width, Accumulator& consumer,
    AzimuthAxes axes = AzimuthAxes::Ground);

  /// The same with a method over Input().Field() other than that of the settings, which has one metric or
  /// that of bands of rows.
  bool Run(HorizonMethod& method, const std::vector<double>& azimuths, double width,
    Accumulator& consumer, AzimuthAxes axes = AzimuthAxes::Ground);

  /// std::runtime_error if the machine has no memory for what a filter is about to allocate: `floats`
  /// a post, and the columns that azimuths need. what: the subject of its sentence.
  void DemandFloats(
    const char* what, std::ptrdiff_t floats, const std::vector<double>& azimuths) const;

  /// Doubts to be raised when the filter is done, each of them once.
  const std::vector<Doubt>& Doubts() const { return this->Found; }
  void AddDoubt(const Doubt& doubt);

  /// Adds HorizonInput::OneMetricDoubt, if there is one.
  void DoubtOneMetric(const std::string& what, const PostMetric& used);

  double PrepareSeconds = 0.0, SearchSeconds = 0.0; ///< of all runs
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
