// SPDX-License-Identifier: BSD-3-Clause
// A scene with the truths that measurements on it are compared with, each found when first asked for.
#ifndef skyline_Stage_h
#define skyline_Stage_h

#include "Scenes.h"
#include "Truth.h"

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
  std::ptrdiff_t Size = 384; ///< posts of a side of the made scenes
  int Azimuths = 32;         ///< of horizons
  int Posts = 1024;          ///< whose horizons are compared
  int SkyPosts = 96;         ///< whose light is compared
  int SkyAzimuths = 360;     ///< of the truth of their light
  int Repeats = 5;           ///< of every time, fewer of slow ones
  double Seconds = 0.35;     ///< after which no repeat begins
};

/// A sun, degrees clockwise from grid north and above the horizontal plane.
struct SunAt
{
  double Azimuth, Elevation;
};

/// Off the axes and diagonals, low to high, and where r.sun accepts the declination at the equator.
constexpr std::array<SunAt, 3> Suns{ { { 100.0, 10.0 }, { 250.0, 20.0 }, { 77.0, 35.0 } } };

/// A lamp: x, y in metres from post (0, 0), z as the heights.
struct LampAt
{
  double X, Y, Z, Radius;
};

/// Light of the truth of some posts: RGB together.
struct LightTruth
{
  std::vector<std::ptrdiff_t> Posts;
  std::vector<double> Light;
  double Mean = 0.0;
};

class Stage
{
public:
  Stage(benchmark::Scene scene, const Effort& effort, WantsToStop stop);

  const benchmark::Scene Scene;
  const Effort Work;

  const Truth& Horizons(); ///< Effort::Posts posts, Effort::Azimuths azimuths

  const Truth& DenseHorizons(); ///< Effort::SkyPosts posts, Effort::SkyAzimuths azimuths
  /// Sky view factors of the posts of DenseHorizons.
  const std::vector<double>& SkyView();
  /// Irradiance of them under the sky of ClearSky (Light.h).
  const LightTruth& ClearSky();

  /// A square in the middle of the scene, posts row by row, and who of them sees each sun.
  const Truth& SunHorizons();
  std::ptrdiff_t WindowSide() const;

  LampAt Lamp() const; ///< above the middle
  const LightTruth& LampLight();

private:
  WantsToStop Stop;
  std::unique_ptr<Truth> Sparse, Dense, Window;
  std::vector<double> Sky;
  std::unique_ptr<LightTruth> Clear, Lit;
};

} // namespace benchmark
} // namespace skyline

#endif
