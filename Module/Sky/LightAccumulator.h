// SPDX-License-Identifier: BSD-3-Clause
// Irradiance of light maps, summed azimuth by azimuth.
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

/// How the horizons of single azimuths stand for all those between them.
enum class SwathQuadrature
{
  Constant, ///< each for its swath, halfway to the neighbours: Timonen & Westerholm 2010
  Blend,    ///< light between two azimuths is what both let pass, each weighted by its nearness
  Linear    ///< horizons linear between two azimuths, cut into parts that are constant
};

/// Sums what light maps send to every post. Light is what comes from above max(horizon, the
/// post's own plane, 0).
class SKYLINECORE_EXPORT LightAccumulator : public Accumulator
{
public:
  struct Options
  {
    SwathQuadrature Quadrature = SwathQuadrature::Constant;
    /// Linear: parts of an interval between neighbouring azimuths.
    int Parts = 2;
  };

  /// azimuths: rising, radians clockwise from grid north, over less than a turn; the last neighbours
  /// the first. They must be fed in this order, with Linear the first once more at the end
  /// (FedAzimuths). Widths of Begin are ignored.
  /// east, north: dz/dx and dz/dy of every post, row by row from the south (Normals.h), or null for
  /// level receivers; irradiance: three floats a post. All, and the maps' pixels, must outlive it.
  LightAccumulator(std::ptrdiff_t columns, std::ptrdiff_t rows,
    const std::vector<TurnedLightMap>& maps, const std::vector<double>& azimuths,
    const Options& options, const float* east, const float* north, float* irradiance);

  /// The azimuths in the order in which they are to be fed.
  std::vector<double> FedAzimuths() const;

  void Begin(double azimuth, double width) override;
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override;
  void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) override;

private:
  double Neighbour(std::ptrdiff_t k) const;
  void BuildTables(const SwathPiece* begin, const SwathPiece* end, double middle, float place);

  struct Part
  {
    std::vector<LightTable> Tables; ///< one a map
    float Sin = 0.0f, Cos = 1.0f;   ///< of the part's middle
    float Place = 1.0f;             ///< of the middle: 0 at the azimuth before, 1 at this one
  };

  std::ptrdiff_t Columns, Rows;
  std::vector<TurnedLightMap> Maps;
  std::vector<double> Azimuths;
  Options Settings;
  const float* East;
  const float* North;
  float* Irradiance;
  std::unique_ptr<float[]> Previous; ///< slopes of the azimuth before, for Linear
  std::vector<Part> Parts;
  std::size_t UsedParts = 0;
  std::ptrdiff_t Fed = -1; ///< number of the current azimuth
};

} // namespace skyline

#endif
