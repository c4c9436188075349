// SPDX-License-Identifier: BSD-3-Clause
// A height field ready for horizons, and the loop over azimuths that feeds its consumers.
#ifndef skyline_HorizonScene_h
#define skyline_HorizonScene_h

#include "Geo/Georeference.h"
#include "Geo/GroundMetric.h"
#include "Geo/RowSpacing.h"
#include "HeightField/HeightField.h"
#include "Horizon/Accumulator.h"
#include "Horizon/HorizonMethod.h"
#include "Shared/Doubt.h"
#include "SkylineFiltersModule.h" // for the export macro
#include "SlopeSearch.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkFloatArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// A pyramid with all of its rows built, kept between executions as long as the heights are the same.
struct KeptPyramid
{
  std::uint64_t Heights = 0; ///< HorizonScene::Fingerprint
  double LevelStep = 0.0;
  std::shared_ptr<const HeightPyramid> Pyramid;
};

/// How the azimuths of a run count, clockwise from the image's +y axis: on the ground, as sums over the
/// sky need them, or on the image (Georeference::GridAzimuthAt), as the arrays of horizons have them.
enum class AzimuthAxes
{
  Ground,
  Image
};

/// Built from a filter's input; throws std::invalid_argument with a one-line reason if that carries
/// no surface. The image must outlive it.
class SKYLINEFILTERS_EXPORT HorizonScene
{
public:
  struct Options
  {
    HorizonSettings Settings; ///< Sink is set here, from the georeference
    bool Flat = false;
    double Refraction = 0.0;
    KeptPyramid* Kept = nullptr; ///< outlives the scene; null: a pyramid is built for each run
  };
  HorizonScene(vtkImageData* image, vtkDataArray* heights, const Options& options);

  /// Told the part done, 0 to 1; returns false to stop.
  std::function<bool(double)> Progress;

  /// Feeds the consumer every azimuth (degrees), each standing for `width` radians. On a distorted map
  /// exact and fast take the metric of every post (GroundMetric.h), the others that of the centre, or of
  /// bands of rows. False if stopped.
  bool Run(const std::vector<double>& azimuths, double width, Accumulator& consumer,
    AzimuthAxes axes = AzimuthAxes::Ground);

  /// The same with a method over PreparedField() other than that of the options, which has one metric or
  /// that of bands of rows.
  bool Run(HorizonMethod& method, const std::vector<double>& azimuths, double width,
    Accumulator& consumer, AzimuthAxes axes = AzimuthAxes::Ground);

  /// Lengths and angles of the posts.
  const GroundMetric& Ground() const { return this->Metric; }

  /// Doubts to be raised, once, when the filter is done.
  std::vector<Doubt> Doubts;

  /// Adds one where `what` takes `used` everywhere and the raster needs more than that.
  void DoubtOneMetric(const std::string& what, const PostMetric& used);

  /// The metric that Posts() has.
  PostMetric CentreMetric() const;

  /// dz/dx and dz/dy of every post, row by row.
  void FillGradients(float* east, float* north) const;

  /// NaN at the missing posts of all components of an array.
  void BlankMissing(vtkFloatArray* array) const;

  /// Posts with a height at which a component of an array is NaN or infinite.
  std::ptrdiff_t CountNotFinite(vtkFloatArray* array) const;

  /// std::runtime_error if the machine has no memory for what a filter is about to allocate: `floats`
  /// a post, and the columns that azimuths (degrees) need. what: the subject of its sentence.
  void DemandFloats(
    const char* what, std::ptrdiff_t floats, const std::vector<double>& azimuths) const;

  /// A float array of a value a post and component, row by row; not filled. std::runtime_error if it
  /// cannot be had.
  vtkFloatArray* AddArray(vtkImageData* output, const char* name, int components = 1) const;

  /// Prepares PreparedField for frames of columns; Run does it by itself.
  void Transpose() { this->Field.Transpose(); }

  const Grid& Posts() const { return this->Field.Posts(); }
  const Georeference& Place() const { return this->Where; }
  const HeightField& PreparedField() const { return this->Field; } ///< heights above MeanHeight
  /// Names the heights, missing ones included: other heights, another number.
  std::uint64_t Fingerprint();

  const HorizonSettings& UsedSettings() const { return this->Settings; }
  const std::vector<RowBand>& BandsOfRows() const { return this->Bands; } ///< one spacing each
  double MeanHeight() const { return this->Mean; }                        ///< metres: BaseHeight.h

  double PrepareSeconds = 0.0, SearchSeconds = 0.0; ///< of all runs
  int PyramidBuilds = 0;

private:
  void DoubtBending();
  std::shared_ptr<const HeightPyramid> PyramidOfHeights();
  bool TakesColumns(const std::vector<double>& azimuths) const;
  bool FollowsGround() const;
  void Prepare(HorizonMethod& method, const Grid& grid, double azimuth, const PostRegion& region);
  bool RunFans(HorizonMethod& method, const std::vector<double>& azimuths, double width,
    Accumulator& consumer, AzimuthAxes axes);

  vtkDataArray* Heights;
  Georeference Where;
  GroundMetric Metric;
  HeightField Field;
  HorizonSettings Settings;
  std::vector<RowBand> Bands;
  double Mean = 0.0;
  KeptPyramid* Kept = nullptr;
  std::uint64_t Heights64 = 0; // once asked for
};

} // namespace skyline

#endif
