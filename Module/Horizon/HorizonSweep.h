// SPDX-License-Identifier: BSD-3-Clause
// The line sweeps of Timonen & Westerholm 2010 (TW10), sections 4 and 5, as published.
#ifndef skyline_HorizonSweep_h
#define skyline_HorizonSweep_h

#include "Horizon/HorizonMethod.h"
#include "SkylineCoreModule.h" // for the export macro

#include <vector>

namespace skyline
{

/// The lattice of samples of an azimuth. In posts, that is columns and rows: sample 0 of line 0, and
/// how far the next sample and the next line are. Metres: from the origin to sample 0 towards the
/// azimuth, and between samples. sink as in HorizonSettings.
struct SweepLines
{
  std::ptrdiff_t Lines, Samples;
  double Origin[2], PerSample[2], PerLine[2];
  double Begin, Step, Sink;
};

/// Parallel lines a post apart march over the field, sample it a post apart by bilinear filtering,
/// and keep the convex hull of the samples passed: O(1) for a sample, whatever the terrain. The
/// horizons found on the rotated lattice of samples are filtered back to the posts, and that
/// resampling costs about a degree: kept for comparison, not for measurement. Missing posts and their
/// cells neither occlude nor receive.
class SKYLINECORE_EXPORT HorizonSweep : public HorizonMethod
{
public:
  HorizonSweep(const HeightField& field, const HorizonSettings& settings);

  void SetAzimuth(const Grid& grid, double azimuth) override;
  std::ptrdiff_t PrepareCount() const override { return this->LineCount; }
  void Prepare(std::ptrdiff_t begin, std::ptrdiff_t end) override;
  void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* slopes, std::ptrdiff_t stride) const override;

protected:
  /// The lattice of SetAzimuth's azimuth: for another processor that fills Slopes.
  SweepLines LinesOfSweep() const;

  std::vector<float> Slopes; // [line][sample], NaN outside the data

private:
  const HeightField& Field;
  HorizonSettings Settings;
  Direction Along{ 0, 1 }; // towards the azimuth, in posts; the lines lie side by side to its right
  double Step = 1.0;       // metres between samples, which are a post apart
  double AlongBegin = 0.0,
         AcrossBegin = 0.0; // posts from post (0, 0) to the first sample and line
  std::ptrdiff_t LineCount = 0, Samples = 0;
};

} // namespace skyline

#endif
