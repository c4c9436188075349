// SPDX-License-Identifier: BSD-3-Clause
// Horizons from a pyramid of smoothed heights: Snyder & Nowrouzezahrai 2008 (SN08), section 4.
#ifndef skyline_HorizonPyramid_h
#define skyline_HorizonPyramid_h

#include "HeightField/HeightPyramid.h"
#include "Horizon/HorizonMethod.h"
#include "SkylineCoreModule.h" // for the export macro

#include <memory>
#include <vector>

namespace skyline
{

/// What a level asks of an azimuth: where its caster lies from a receiver.
struct PyramidReach
{
  int Level = 0;         ///< read from: sharper by the offset, clamped to the finest
  double Distance = 1.0; ///< metres to the caster
  double East = 0.0;     ///< posts to the caster
  double North = 0.0;
};

/// The multi-scale derivative (equation 2) gives a blocking angle a level (3); a cubic b-spline over
/// the levels, which is over log distance (4), is asked for its greatest value at and halfway between
/// its knots (5). The time does not depend on the terrain, the horizon is a smooth one: about a degree
/// off on real terrain, more at walls. Kept for what it was made for, soft shadows of moving terrain.
///
/// As published, a horizon below the horizontal comes out as 0, and so does one where no terrain lies.
/// Missing posts do not occlude. Every row is a line of the frame, whatever the azimuth.
class HorizonPyramid : public HorizonMethod
{
public:
  /// pyramid: one of the same heights and level step with all of its rows built; null: one is built.
  HorizonPyramid(const HeightField& field, const HorizonSettings& settings,
    std::shared_ptr<const HeightPyramid> pyramid = nullptr);

  void SetAzimuth(const Grid& grid, double azimuth) override;
  std::ptrdiff_t PrepareCount() const override { return this->Pieces; }
  void Prepare(std::ptrdiff_t begin, std::ptrdiff_t end) override;
  void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* slopes, std::ptrdiff_t stride) const override;

  const HeightPyramid& Heights() const { return *this->Pyramid; }

private:
  HorizonSettings Settings;
  std::shared_ptr<HeightPyramid> Own; // null: somebody else's
  std::shared_ptr<const HeightPyramid> Pyramid;
  std::ptrdiff_t Columns, Rows;
  std::ptrdiff_t Pieces = 0; // the own pyramid's rows, for the first azimuth alone
  std::vector<PyramidReach> Reach;
};

/// Where the levels of a pyramid read: the coarsest first. azimuth: degrees clockwise from north.
/// Distances are measured so that on any grid the finest caster lies lambda posts away.
SKYLINECORE_EXPORT std::vector<PyramidReach> PyramidReaches(
  const HeightPyramid& pyramid, const PyramidSettings& settings, const Grid& grid, double azimuth);
SKYLINECORE_EXPORT std::vector<PyramidReach> PyramidReaches(const std::vector<PyramidSize>& levels,
  const PyramidSettings& settings, const Grid& grid, double azimuth);

/// std::invalid_argument for an offset or a distance out of range.
SKYLINECORE_EXPORT void CheckPyramidSettings(const PyramidSettings& settings);

} // namespace skyline

#endif
