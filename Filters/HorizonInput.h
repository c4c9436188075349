// SPDX-License-Identifier: BSD-3-Clause
// The input of a filter, checked and turned into a height field on the ground.
#ifndef skyline_HorizonInput_h
#define skyline_HorizonInput_h

#include "Geo/Georeference.h"
#include "Geo/GroundMetric.h"
#include "Geo/RowBands.h"
#include "HeightField/HeightField.h"
#include "Shared/Doubt.h"
#include "SkylineFiltersModule.h" // for the export macro

#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <cstdint>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// The same posts with the lengths of another place of the raster.
SKYLINEFILTERS_EXPORT Grid WithSpacing(Grid posts, const PostMetric& metric);
SKYLINEFILTERS_EXPORT Grid WithSpacing(Grid posts, const RowBand& band);

/// The heights, the place and the lengths of a raster, ready for the methods that find horizons.
class SKYLINEFILTERS_EXPORT HorizonInput
{
public:
  /// Throws std::invalid_argument, with a reason of one line, if the image has no surface, and
  /// std::runtime_error if there is not enough memory for its heights. Image and heights must
  /// outlive this.
  HorizonInput(vtkImageData* image, vtkDataArray* heights);

  /// The prepared heights, in metres above BaseHeight.
  const HeightField& Field() const { return this->Heights; }
  const Grid& Posts() const { return this->Heights.Posts(); }
  double BaseHeight() const { return this->Base; } ///< in metres; see BaseHeight.h

  /// Prepares the field for rays that run along its rows.
  void Transpose() { this->Heights.Transpose(); }

  /// Returns the checksum of the heights (HeightChecksum). It is computed at the first call.
  std::uint64_t Checksum();

  const Georeference& Place() const { return this->Where; }

  /// Lengths and angles at each post, those in the middle, and bands of rows with one spacing each.
  const GroundMetric& Ground() const { return this->Metric; }
  PostMetric CentreMetric() const;
  const std::vector<RowBand>& Bands() const { return this->RowsOfOneSpacing; }

  /// Returns (1 - refraction) / 2R in the middle of the raster, in 1/m: terrain appears lower by
  /// this times the square of its distance. 0 without a body. Refraction is used on the Earth only.
  double CurvatureDrop(double refraction) const;

  /// Writes dz/dx and dz/dy on the ground for each post, row by row.
  void FillGradients(float* east, float* north) const;

  /// Returns a warning if rays bend on the map more than can be ignored.
  std::optional<Doubt> BendingDoubt() const;

  /// Returns a warning if `what` uses the metric `used` everywhere and the raster needs more than
  /// one.
  std::optional<Doubt> OneMetricDoubt(const std::string& what, const PostMetric& used) const;

private:
  vtkDataArray* Values;
  Georeference Where;
  GroundMetric Metric;
  HeightField Heights;
  std::vector<RowBand> RowsOfOneSpacing;
  double Base = 0.0;
  std::uint64_t Sum = 0; ///< 0: not computed yet
};

} // namespace skyline

#endif
