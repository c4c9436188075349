// SPDX-License-Identifier: BSD-3-Clause
// Skies whose radiance depends only on elevation.
#ifndef skyline_ZonalSky_h
#define skyline_ZonalSky_h

#include "Horizon/Accumulator.h"
#include "SkylineCoreModule.h" // for the export macro

#include <array>
#include <cstddef>

namespace skyline
{

/// A sky with the same radiance in all azimuths, prepared to compute its light on slopes above
/// horizons.
class SKYLINECORE_EXPORT ZonalSky
{
public:
  /// The skies of CIE S 011/E:2003 that do not depend on the sun, by their numbers in the standard:
  /// 1 (overcast, steep gradation), 3 (overcast, moderate gradation), 5 (uniform) and 16
  /// (traditional overcast sky, Moon and Spencer 1942). Throws std::invalid_argument for other
  /// numbers.
  explicit ZonalSky(int cieType);

  /// Returns true if the type is one of these.
  static bool Knows(int cieType);

  /// Radiance at an elevation with the sine `sine` (0 to 1), divided by that at the zenith: CieSky
  /// of SkyModel.h. Throws std::invalid_argument for other types.
  static double Radiance(int cieType, double sine);

  /// The light that the part of the sky above elevation t in one azimuth sends to a plane, per
  /// radian of azimuth, divided by the irradiance of open level ground. `rise`: rise of the plane
  /// per metre in this azimuth; `sine`: sin t, 0 to 1, not below the plane. The z component of the
  /// normal is left out. The result is
  ///   Int_t^90 L(e) (sin e - rise cos e) cos e de / Int Int_0^90 L sin e cos e de da,
  /// linearly interpolated between Nodes sines, with an error below 1e-5 for rises up to 1.
  float Light(float sine, float rise) const
  {
    const float place = sine * (Nodes - 1);
    const int node = place < Nodes - 2 ? static_cast<int>(place) : Nodes - 2;
    const float weight = place - static_cast<float>(node);
    const Node& a = this->Table[static_cast<std::size_t>(node)];
    const Node& b = this->Table[static_cast<std::size_t>(node) + 1];
    return a.Level + weight * (b.Level - a.Level) -
      rise * (a.Upright + weight * (b.Upright - a.Upright));
  }

private:
  static constexpr int Nodes = 1025;
  struct Node
  {
    float Level = 0.0f;   ///< on a level plane
    float Upright = 0.0f; ///< on a vertical plane that faces the azimuth
  };
  std::array<Node, Nodes> Table;
};

/// Sums the light of a zonal sky over azimuths whose swaths form a full circle: irradiance of the
/// tilted surface at each post, divided by that of open level ground under the same sky.
class SKYLINECORE_EXPORT ZonalSkyAccumulator : public Accumulator
{
public:
  /// east, north: dz/dx and dz/dy of every post, row by row from the south (Normals.h). share: the
  /// results, in the same order. All must outlive the accumulator. NaN in east or north gives NaN.
  ZonalSkyAccumulator(const ZonalSky& sky, std::ptrdiff_t columns, const float* east,
    const float* north, float* share);

  void Begin(double azimuth, double width) override;
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override;
  void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) override;

private:
  const ZonalSky& Sky;
  std::ptrdiff_t Columns;
  const float* East;
  const float* North;
  float* Share;
  bool First = true;
  float SinAzimuth = 0.0f, CosAzimuth = 1.0f;
  float Width = 0.0f;
};

} // namespace skyline

#endif
