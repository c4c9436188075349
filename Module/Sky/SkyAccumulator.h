// SPDX-License-Identifier: BSD-3-Clause
// What a post sees of the sky, summed azimuth by azimuth.
#ifndef skyline_SkyAccumulator_h
#define skyline_SkyAccumulator_h

#include "Horizon/Accumulator.h"
#include "Horizon/PostBuffer.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>

namespace skyline
{

struct SkyAzimuth;

/// The quantities wanted. The buffers hold the running sums until Finish; nothing else is stored.
/// The sky is what lies above max(horizon, 0) and, on the tilted surface, above its plane; the
/// horizon stands for the whole swath of its azimuth.
struct SkyBuffers
{
  PostBuffer SkyViewFactor; ///< irradiance / pi of a sky of radiance 1 on the tilted surface
  PostBuffer SkyViewFactorHorizontal; ///< the same on a level surface: 1 - mean(sin^2 h)
  PostBuffer VisibleSkyFraction;      ///< solid angle of sky / 2 pi: 1 - mean(sin h)
  PostBuffer PositiveOpenness;        ///< degrees: mean(90 - horizon), horizons below 0 as they are
  /// Timonen & Westerholm 2010, equation 5, with radiance 1: as SkyViewFactor, but down to the
  /// horizon itself where it is below 0, and with the cosine averaged over the swath.
  PostBuffer UniformAmbient;
};

/// Sums the sky over azimuths whose swaths make up a circle.
class SKYLINECORE_EXPORT SkyAccumulator : public Accumulator
{
public:
  /// east, north: dz/dx and dz/dy of every post, row by row from the south (Normals.h); they must
  /// outlive the accumulator and are read only if SkyViewFactor or UniformAmbient is wanted, else
  /// null will do. NaN there gives NaN in these two.
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
  bool Strided = false; ///< some buffer's posts do not lie side by side
  bool First = true;    ///< the azimuth is the first: sums start, whatever the buffers held
  float SinAzimuth = 0.0f, CosAzimuth = 1.0f;
  float AmbientWeight = 0.0f; ///< of the azimuth's cosines in UniformAmbient
  double Weight = 0.0;        ///< of the azimuth, in a circle
  double Total = 0.0;         ///< of all weights so far
};

} // namespace skyline

#endif
