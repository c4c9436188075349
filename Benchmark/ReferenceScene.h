// SPDX-License-Identifier: BSD-3-Clause
// A scene with the reference values for its measurements, each computed when it is first used.
#ifndef skyline_ReferenceScene_h
#define skyline_ReferenceScene_h

#include "ReferenceHorizons.h"
#include "Scenes.h"

#include <array>
#include <memory>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// How much work is done for a scene.
struct Effort
{
  std::ptrdiff_t Size = 384; ///< side of the made scenes, in posts
  int Azimuths = 32;         ///< azimuths of the horizons
  int Posts = 1024;          ///< posts whose horizons are compared
  int SkyPosts = 96;         ///< posts whose light is compared
  int SkyAzimuths = 360;     ///< azimuths of the reference of their light
  int Repeats = 5;           ///< repeats of each measurement, fewer for slow ones
  double Seconds = 0.35;     ///< after this many seconds no repeat begins
};

/// A sun: degrees clockwise from grid north, and degrees above the horizontal plane.
struct SunAt
{
  double Azimuth, Elevation;
};

/// The suns avoid axes and diagonals, stand low and high, and have declinations that r.sun accepts
/// at the equator.
constexpr std::array<SunAt, 3> Suns{ { { 100.0, 10.0 }, { 250.0, 20.0 }, { 77.0, 35.0 } } };

/// A lamp: x and y in metres from post (0, 0), z as the heights.
struct LampAt
{
  double X, Y, Z, Radius;
};

/// The reference irradiance of some posts, with red, green and blue for each.
struct ReferenceLight
{
  std::vector<std::ptrdiff_t> Posts;
  std::vector<double> Light;
  double Mean = 0.0;
};

class ReferenceScene
{
public:
  ReferenceScene(benchmark::Scene scene, const Effort& effort, WantsToStop stop);

  const benchmark::Scene Scene;
  const Effort Work;

  const ReferenceHorizons& Horizons(); ///< Effort::Posts posts, Effort::Azimuths azimuths

  const ReferenceHorizons& SkyHorizons(); ///< Effort::SkyPosts posts, Effort::SkyAzimuths azimuths
  /// Sky view factors of the posts of SkyHorizons.
  const std::vector<double>& SkyView();
  /// Irradiance of the same posts under the sky of ClearSky.h.
  const ReferenceLight& ClearSky();

  /// Horizons towards each sun for a square in the middle of the scene, row by row.
  const ReferenceHorizons& SunHorizons();
  std::ptrdiff_t WindowSide() const;

  LampAt Lamp() const; ///< above the middle of the scene
  const ReferenceLight& LampLight();

private:
  WantsToStop Stop;
  std::unique_ptr<ReferenceHorizons> Sparse, Dense, Window;
  std::vector<double> Sky;
  std::unique_ptr<ReferenceLight> Clear, Lit;
};

} // namespace benchmark
} // namespace skyline

#endif
