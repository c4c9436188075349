// SPDX-License-Identifier: BSD-3-Clause
// Visibility and transfer as spherical harmonics, summed azimuth by azimuth: Snyder &
// Nowrouzezahrai 2008 (SN08), section 5, without tables.
#ifndef skyline_VisibilityAccumulator_h
#define skyline_VisibilityAccumulator_h

#include "Harmonics/ElevationIntegral.h"
#include "Horizon/Accumulator.h"
#include "SkylineCoreModule.h" // for the export macro

#include <array>
#include <cstddef>
#include <vector>

namespace skyline
{

/// Which part of the sphere counts as sky if no horizon hides it.
enum class SkyPart
{
  Upper, ///< above max(horizon, 0): for skies and environments
  Sphere ///< above the horizon, even below 0: for lamps, and furnace tests
};

/// Where the sums are stored. The bands * bands coefficients of post (column, row) lie side by side
/// from Values[(row * Columns + column) * bands^2] on, as the tuples of a VTK array.
struct HarmonicBuffers
{
  std::ptrdiff_t Columns = 0, Rows = 0;
  int Bands = DefaultHarmonicBands; ///< 1 to 8
  float* Values = nullptr;          ///< Columns * Rows * bands^2 floats; need not be initialised
  SkyPart Sky = SkyPart::Upper;
};

/// Number of azimuths that are collected and then added in one pass over the sums.
constexpr int WedgeGroup = 4;

/// Weights of the integrals of one azimuth in the coefficients of orders m and -m: the mean
/// azimuthal factor over the swath, times its width. East and North: the same with the factor
/// multiplied by the sine or the cosine of the azimuth.
template <typename Real>
struct WedgeWeights
{
  Real Cosine[MaxHarmonicBands], Sine[MaxHarmonicBands];
  Real CosineEast[MaxHarmonicBands], SineEast[MaxHarmonicBands];
  Real CosineNorth[MaxHarmonicBands], SineNorth[MaxHarmonicBands];
};

/// The weights for a swath around `azimuth`; azimuth and width in radians.
SKYLINECORE_EXPORT WedgeWeights<double> WeightsOfSwath(int bands, double azimuth, double width);

/// An integral in the form that the vector code needs.
struct WedgeIntegral
{
  ElevationKind Kind;
  int Terms;
  float Constant;
  float Polynomial[ElevationIntegral::MaxTerms];
};

/// The input of a pass over some posts.
struct WedgePass
{
  int Bands;
  bool Upper, First;
  const WedgeIntegral* Visible;
  const WedgeIntegral* Upward;  ///< null: only the visibility is computed
  const WedgeIntegral* Forward; ///< likewise
  WedgeWeights<float> Weights[WedgeGroup];
  float SinAzimuth[WedgeGroup], CosAzimuth[WedgeGroup];
};

/// Projects the sky above the horizon, which is constant over the swath of each azimuth: one wedge
/// per azimuth. With gradients, the sky is multiplied by the cosine of incidence on the plane at
/// the post and limited to directions above that plane, so that irradiance is the dot product with
/// the coefficients of the light (the transfer vector of SN08). SN08 multiply two truncated series
/// for this; here the product is integrated exactly, and only the light is truncated.
///
/// The sums contain, in floats, what horizons hide; the unobstructed value is added at the end.
/// Open level ground is therefore exact for any number of azimuths. Until the end, 16 posts of a
/// row share a block, coefficient by coefficient, in the memory of their tuples, so that the vector
/// code reads contiguous memory. The azimuths of a group are collected in `WedgeGroup - 1` floats
/// per post and added in one pass, because reading and writing the sums takes most of the time.
class SKYLINECORE_EXPORT VisibilityAccumulator : public Accumulator
{
public:
  /// east, north: dz/dx and dz/dy of every post (Normals.h), which must outlive the accumulator:
  /// computes the transfer. null: computes the visibility. Throws std::invalid_argument if the
  /// number of bands is out of range.
  explicit VisibilityAccumulator(
    const HarmonicBuffers& buffers, const float* east = nullptr, const float* north = nullptr);

  void Begin(double azimuth, double width) override;
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override;
  void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) override;

private:
  void AddWhole(const WedgeWeights<double>& weights);
  void Sum(std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes);
  void FinishBlock(std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t posts) const;

  HarmonicBuffers Buffers;
  const float* East;
  const float* North;
  std::vector<ElevationIntegral> Exact[3]; // by ElevationWeight
  std::vector<WedgeIntegral> Integrals[3];
  WedgePass Pass{};
  int Waiting = -1;          ///< index of the current azimuth in its group
  std::vector<float> Slopes; // [azimuth of the group][post], without the last azimuth
  /// Coefficients without any horizon: of the visibility, or of the transfer for the upward, east
  /// and north components of the normal.
  std::array<std::array<double, HarmonicCount(MaxHarmonicBands)>, 3> Whole{};
};

} // namespace skyline

#endif
