// SPDX-License-Identifier: BSD-3-Clause
// What a post sees of the sky as spherical harmonics, summed azimuth by azimuth: Snyder &
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

/// What counts as sky where no horizon hides it.
enum class SkyPart
{
  Upper, ///< above max(horizon, 0): skies and environments
  Sphere ///< above the horizon, however low: lamps, and furnaces
};

/// The sums to make. A post's coefficients lie side by side, bands * bands of them, post (column, row)
/// from Values[(row * Columns + column) * bands^2] on: tuples of a VTK array.
struct HarmonicBuffers
{
  std::ptrdiff_t Columns = 0, Rows = 0;
  int Bands = DefaultHarmonicBands; ///< 1 to 8
  float* Values = nullptr;          ///< Columns * Rows * bands^2 floats; need not be set
  SkyPart Sky = SkyPart::Upper;
};

/// The azimuths that wait until there are enough of them: every pass over the sums takes this many.
constexpr int WedgeGroup = 4;

/// Weights of one azimuth's integrals in the coefficients of order m and -m: the factor of the
/// azimuth averaged over the swath, times its width. East and North: likewise with the sine and the
/// cosine of the azimuth in the mean.
template <typename Real>
struct WedgeWeights
{
  Real Cosine[MaxHarmonicBands], Sine[MaxHarmonicBands];
  Real CosineEast[MaxHarmonicBands], SineEast[MaxHarmonicBands];
  Real CosineNorth[MaxHarmonicBands], SineNorth[MaxHarmonicBands];
};

/// Those of a swath about `azimuth`, radians; width: of the swath.
SKYLINECORE_EXPORT WedgeWeights<double> WeightsOfSwath(int bands, double azimuth, double width);

/// An integral as the vector code takes it.
struct WedgeIntegral
{
  ElevationKind Kind;
  int Terms;
  float Constant;
  float Polynomial[ElevationIntegral::MaxTerms];
};

/// Everything that a pass over some posts reads.
struct WedgePass
{
  int Bands;
  bool Upper, First;
  const WedgeIntegral* Visible;
  const WedgeIntegral* Upward;  ///< null: the visibility alone
  const WedgeIntegral* Forward; ///< likewise
  WedgeWeights<float> Weights[WedgeGroup];
  float SinAzimuth[WedgeGroup], CosAzimuth[WedgeGroup];
};

/// The sky above the horizon, a constant one over the swath of each azimuth, projected: a StepWedge
/// an azimuth. With gradients: the same times the cosine at the post's plane and above that plane, so
/// that irradiance is the dot product with the light's coefficients (SN08's transfer vector). There
/// SN08 multiply two truncated series; here the product is integrated, and only the light is
/// truncated.
///
/// What is summed is what horizons take away, in floats; what is there without them is added in the
/// end, so open level ground comes out exact for any number of azimuths. Until then 16 posts of a row
/// share a block, coefficient by coefficient, which the vectors read from end to end; it lies where
/// their tuples will. A group of azimuths waits in `WedgeGroup - 1` floats a post and is summed in one
/// pass, for the sums are the traffic.
class SKYLINECORE_EXPORT VisibilityAccumulator : public Accumulator
{
public:
  /// east, north: dz/dx and dz/dy of every post (Normals.h), which outlive the accumulator: transfer;
  /// null: visibility. std::invalid_argument for bands out of range.
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
  std::vector<float> Slopes; // [azimuth of the group][post], but for the last
  /// Coefficients without any horizon: of the visibility, or of the transfer for the parts of the
  /// normal up, east and north.
  std::array<std::array<double, HarmonicCount(MaxHarmonicBands)>, 3> Whole{};
};

} // namespace skyline

#endif
