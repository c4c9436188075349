// SPDX-License-Identifier: BSD-3-Clause
// Sky view factors and other measures of the visible sky, summed azimuth by azimuth.
#ifndef skyline_SkyAccumulator_h
#define skyline_SkyAccumulator_h

#include "Horizon/Accumulator.h"
#include "Horizon/PostBuffer.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>

namespace skyline
{

struct SkyAzimuth;

/// The quantities to compute. The buffers hold the running sums until Finish; no other memory is
/// used. The sky is what lies above max(horizon, 0) and, on the tilted surface, above its plane.
/// The horizon of an azimuth counts for its whole swath.
struct SkyBuffers
{
  PostBuffer SkyViewFactor; ///< irradiance / pi of a sky of radiance 1 on the tilted surface
  PostBuffer SkyViewFactorHorizontal; ///< the same on a level surface: 1 - mean(sin^2 h)
  PostBuffer VisibleSkyFraction;      ///< solid angle of sky / 2 pi: 1 - mean(sin h)
  PostBuffer PositiveOpenness;        ///< degrees: mean(90 - horizon), with horizons below 0
  /// Timonen & Westerholm 2010, equation 5, with radiance 1: like SkyViewFactor, but the light
  /// reaches down to the horizon itself if that is below 0, and the cosine is averaged over the
  /// swath.
  PostBuffer UniformAmbient;
};

/// Sums the sky over azimuths whose swaths form a full circle.
class SKYLINECORE_EXPORT SkyAccumulator : public Accumulator
{
public:
  /// east, north: dz/dx and dz/dy of every post, row by row from the south (Normals.h). They must
  /// outlive the accumulator. They are read only for SkyViewFactor and UniformAmbient; otherwise
  /// they may be null. NaN gives NaN in these two.
  SkyAccumulator(
    std::ptrdiff_t columns, const SkyBuffers& buffers, const float* east, const float* north);

  void Begin(double azimuth, double width) override;
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override;
  void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) override;

private:
  void AddStrided(std::ptrdiff_t post, std::ptrdiff_t count, const float* slopes);
  SkyAzimuth Azimuth() const;

  std::ptrdiff_t Columns;
  SkyBuffers Buffers;
  const float* East;
  const float* North;
  bool Strided = false; ///< some buffer is not contiguous
  bool First = true;    ///< at the first azimuth, sums start whatever the buffers contain
  float SinAzimuth = 0.0f, CosAzimuth = 1.0f;
  float AmbientWeight = 0.0f; ///< weight of the cosines of the azimuth in UniformAmbient
  double Weight = 0.0;        ///< weight of the azimuth, as a share of the circle
  double Total = 0.0;         ///< sum of all weights so far
};

} // namespace skyline

#endif
