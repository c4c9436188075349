// SPDX-License-Identifier: BSD-3-Clause
// Irradiance from light maps, summed azimuth by azimuth.
#ifndef skyline_LightAccumulator_h
#define skyline_LightAccumulator_h

#include "Horizon/Accumulator.h"
#include "Sky/LightTable.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <memory>
#include <vector>

namespace skyline
{

/// How the horizons of single azimuths represent all azimuths in between.
enum class SwathQuadrature
{
  Constant, ///< each for its swath, halfway to its neighbours: Timonen & Westerholm 2010
  Blend,    ///< between two azimuths, the light that each lets pass, weighted by nearness
  Linear    ///< horizons linear between two azimuths, divided into parts with constant ones
};

/// Sums the light from light maps at each post. Light comes from directions above max(horizon,
/// plane at the post, horizontal plane).
class SKYLINECORE_EXPORT LightAccumulator : public Accumulator
{
public:
  struct Options
  {
    SwathQuadrature Quadrature = SwathQuadrature::Constant;
    /// For Linear: number of parts of an interval between neighbouring azimuths.
    int Parts = 2;
  };

  /// azimuths: rising, in radians clockwise from grid north, over less than a full turn; the last
  /// one is a neighbour of the first. They must be added in this order, for Linear with the first
  /// one again at the end (HorizonAzimuths). The widths passed to Begin are ignored.
  /// east, north: dz/dx and dz/dy of every post, row by row from the south (Normals.h), or null for
  /// level receivers. irradiance: three floats per post. All of these, and the pixels of the maps,
  /// must outlive the accumulator.
  LightAccumulator(std::ptrdiff_t columns, std::ptrdiff_t rows,
    const std::vector<TurnedLightMap>& maps, const std::vector<double>& azimuths,
    const Options& options, const float* east, const float* north, float* irradiance);

  /// The azimuths in the order in which they must be added.
  std::vector<double> HorizonAzimuths() const;

  void Begin(double azimuth, double width) override;
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override;
  void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) override;

private:
  double Neighbour(std::ptrdiff_t k) const;
  void BuildTables(const SwathPiece* begin, const SwathPiece* end, double middle, float place);

  struct Part
  {
    std::vector<LightTable> Tables; ///< one per map
    float Sin = 0.0f, Cos = 1.0f;   ///< of the azimuth at the centre of the part
    float Place = 1.0f;             ///< position of the centre: 0 at the previous azimuth, 1 at
                                    ///< this one
  };

  std::ptrdiff_t Columns, Rows;
  std::vector<TurnedLightMap> Maps;
  std::vector<double> Azimuths;
  Options Settings;
  const float* East;
  const float* North;
  float* Irradiance;
  std::unique_ptr<float[]> Previous; ///< slopes in the previous azimuth, for Linear
  std::vector<Part> Parts;
  std::size_t UsedParts = 0;
  std::ptrdiff_t Fed = -1; ///< index of the current azimuth
};

} // namespace skyline

#endif
