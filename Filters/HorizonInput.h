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

/// The posts with the lengths of another place of the raster.
SKYLINEFILTERS_EXPORT Grid WithSpacing(Grid posts, const PostMetric& metric);
SKYLINEFILTERS_EXPORT Grid WithSpacing(Grid posts, const RowBand& band);

/// Heights, place and lengths of a raster, ready for the methods that find horizons.
class SKYLINEFILTERS_EXPORT HorizonInput
{
public:
  /// Throws std::invalid_argument with a one-line reason if the image carries no surface, and
  /// std::runtime_error if there is no memory for its heights. Image and heights must outlive it.
  HorizonInput(vtkImageData* image, vtkDataArray* heights);

  /// The prepared heights, metres above BaseHeight.
  const HeightField& Field() const { return this->Heights; }
  const Grid& Posts() const { return this->Heights.Posts(); }
  double BaseHeight() const { return this->Base; } ///< metres: BaseHeight.h

  /// Prepares the field for rays that run along its rows.
  void Transpose() { this->Heights.Transpose(); }

  /// Names the heights (HeightChecksum). Computed when it is first asked for.
  std::uint64_t Checksum();

  const Georeference& Place() const { return this->Where; }

  /// Lengths and angles of the posts, that of the posts in the middle, and bands of rows that have one
  /// spacing each.
  const GroundMetric& Ground() const { return this->Metric; }
  PostMetric CentreMetric() const;
  const std::vector<RowBand>& Bands() const { return this->RowsOfOneSpacing; }

  /// (1 - refraction) / 2R in the middle of the raster, 1/m: how a post sinks with its distance squared. 0
  /// without a body. Refraction counts on the Earth alone.
  double Sink(double refraction) const;

  /// dz/dx and dz/dy of every post on the ground, row by row.
  void FillGradients(float* east, float* north) const;

  /// Says if rays bend on the map by more than can be passed over.
  std::optional<Doubt> BendingDoubt() const;

  /// Says if `what` takes the metric `used` everywhere and the raster needs more than that.
  std::optional<Doubt> OneMetricDoubt(const std::string& what, const PostMetric& used) const;

private:
  vtkDataArray* Values;
  Georeference Where;
  GroundMetric Metric;
  HeightField Heights;
  std::vector<RowBand> RowsOfOneSpacing;
  double Base = 0.0;
  std::uint64_t Sum = 0; ///< 0: not yet computed
};

} // namespace skyline

#endif
