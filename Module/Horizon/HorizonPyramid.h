// SPDX-License-Identifier: BSD-3-Clause
// Horizons from a height pyramid: Snyder & Nowrouzezahrai 2008 (SN08), section 4.
#ifndef skyline_HorizonPyramid_h
#define skyline_HorizonPyramid_h

#include "HeightField/HeightPyramid.h"
#include "Horizon/HorizonMethod.h"
#include "SkylineCoreModule.h" // for the export macro

#include <memory>
#include <vector>

namespace skyline
{

/// The position, relative to the receiver, of the caster that a level uses in an azimuth.
struct PyramidReach
{
  int Level = 0;         ///< level that is read: finer by the offset, clamped to the finest level
  double Distance = 1.0; ///< metres to the caster
  double East = 0.0;     ///< posts to the caster
  double North = 0.0;
};

/// The multi-scale derivative (equation 2) gives one blocking angle per level (3). The horizon is
/// the greatest value, at and halfway between the knots (5), of a cubic B-spline over the levels,
/// that is over the logarithm of distance (4). The time does not depend on the terrain. The horizon
/// is smooth: about a degree off on real terrain, more at walls. The method is made for soft
/// shadows of moving terrain.
///
/// As published, a horizon below the horizontal plane gives 0, and so does the absence of terrain.
/// Missing posts do not occlude. The lines of the frame are rows in every azimuth.
class HorizonPyramid : public HorizonMethod
{
public:
  /// pyramid: a pyramid of the same heights and level step whose rows have all been computed; null:
  /// the method builds its own.
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
  std::shared_ptr<HeightPyramid> Own; // null if the pyramid was given
  std::shared_ptr<const HeightPyramid> Pyramid;
  std::ptrdiff_t Columns, Rows;
  std::ptrdiff_t Pieces = 0; // rows of the own pyramid, computed with the first azimuth
  std::vector<PyramidReach> Reach;
};

/// The positions that the levels of a pyramid read, the coarsest level first. azimuth: degrees
/// clockwise from north. On any grid, the finest caster lies lambda posts away.
SKYLINECORE_EXPORT std::vector<PyramidReach> PyramidReaches(
  const HeightPyramid& pyramid, const PyramidSettings& settings, const Grid& grid, double azimuth);
SKYLINECORE_EXPORT std::vector<PyramidReach> PyramidReaches(const std::vector<PyramidSize>& levels,
  const PyramidSettings& settings, const Grid& grid, double azimuth);

/// Throws std::invalid_argument if the offset or the distance is out of range.
SKYLINECORE_EXPORT void CheckPyramidSettings(const PyramidSettings& settings);

} // namespace skyline

#endif
