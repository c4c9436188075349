// SPDX-License-Identifier: BSD-3-Clause
// The line sweep of Timonen & Westerholm 2010 (TW10), sections 4 and 5, as published.
#ifndef skyline_HorizonSweep_h
#define skyline_HorizonSweep_h

#include "Horizon/HorizonMethod.h"
#include "SkylineCoreModule.h" // for the export macro

#include <vector>

namespace skyline
{

/// The lattice of samples for one azimuth, in posts (columns and rows): the position of sample 0 of
/// line 0 and the steps to the next sample and to the next line. In metres: the distance of sample
/// 0 from the origin towards the azimuth, and the distance between samples. For the drop see
/// HorizonSettings.
struct SweepLines
{
  std::ptrdiff_t Lines, Samples;
  double Origin[2], PerSample[2], PerLine[2];
  double Begin, Step, CurvatureDrop;
};

/// Parallel lines, one post apart, run over the field. They take bilinear samples one post apart
/// and keep the convex hull of the samples passed, at a cost of O(1) per sample on any terrain. The
/// horizons at the samples of this rotated lattice are then interpolated at the posts, which costs
/// about a degree of accuracy. The method is kept for comparison, not for measurement. Missing
/// posts and their cells neither occlude nor receive.
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
  /// The lattice of the azimuth of SetAzimuth, for another processor that fills Slopes.
  SweepLines LinesOfSweep() const;

  std::vector<float> Slopes; // [line][sample], NaN outside the data

private:
  const HeightField& Field;
  HorizonSettings Settings;
  Direction Along{ 0, 1 }; // towards the azimuth, in posts; the next line lies to its right
  double Step = 1.0;       // metres between samples, which are one post apart
  double AlongBegin = 0.0,
         AcrossBegin = 0.0; // posts from post (0, 0) to the first sample and to the first line
  std::ptrdiff_t LineCount = 0, Samples = 0;
};

} // namespace skyline

#endif
