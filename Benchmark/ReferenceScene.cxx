// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceScene.h"

#include "ClearSky.h"

#include "Azimuths.h"
#include "Reference/LampOracle.h"
#include "Reference/LightOracle.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace skyline
{
namespace benchmark
{

namespace
{

constexpr std::uint64_t Seed = 1;
constexpr int SkySteps = 200;        // elevations of the reference of the sky view
constexpr int LampSide = 32;         // rays of the reference of a lamp, squared
constexpr std::ptrdiff_t Side = 128; // side of the window for suns

// The horizon between two azimuths of a reference, interpolated linearly in elevation; radians.
double HorizonAt(const ReferenceHorizons& truth, std::size_t post, double azimuth)
{
  const auto count = static_cast<double>(truth.Azimuths.size());
  double place = azimuth / (2.0 * Pi) * count;
  place -= count * std::floor(place / count);
  const auto before = static_cast<std::size_t>(place) % truth.Azimuths.size();
  const auto after = (before + 1) % truth.Azimuths.size();
  const double f = place - std::floor(place);
  return RadiansPerDegree *
    ((1.0 - f) * truth.Elevation(before, post) + f * truth.Elevation(after, post));
}

void GradientOf(const oracle::OracleField& field, std::ptrdiff_t post, double& east, double& north)
{
  oracle::Gradient(field, post % field.Columns, post / field.Columns, east, north);
}

void FindMean(ReferenceLight& truth)
{
  truth.Mean = std::accumulate(truth.Light.begin(), truth.Light.end(), 0.0) /
    static_cast<double>(truth.Light.size());
}

} // namespace

ReferenceScene::ReferenceScene(benchmark::Scene scene, const Effort& effort, WantsToStop stop)
  : Scene(std::move(scene))
  , Work(effort)
  , Stop(std::move(stop))
{
}

const ReferenceHorizons& ReferenceScene::Horizons()
{
  if (!this->Sparse)
  {
    this->Sparse = std::make_unique<ReferenceHorizons>(
      this->Scene, this->Work.Posts, EvenDegrees(this->Work.Azimuths), Seed, this->Stop);
  }
  return *this->Sparse;
}

const ReferenceHorizons& ReferenceScene::SkyHorizons()
{
  if (!this->Dense)
  {
    this->Dense = std::make_unique<ReferenceHorizons>(
      this->Scene, this->Work.SkyPosts, EvenDegrees(this->Work.SkyAzimuths), Seed, this->Stop);
  }
  return *this->Dense;
}

const std::vector<double>& ReferenceScene::SkyView()
{
  if (this->Sky.empty())
  {
    const ReferenceHorizons& truth = this->SkyHorizons();
    this->Sky.resize(truth.Posts.size());
    ForAll(
      truth.Posts.size(),
      [&](std::size_t post)
      {
        std::vector<double> slopes;
        for (std::size_t azimuth = 0; azimuth < truth.Azimuths.size(); ++azimuth)
        {
          slopes.push_back(std::tan(truth.Elevation(azimuth, post) * RadiansPerDegree));
        }
        double east = 0.0, north = 0.0;
        GradientOf(this->Scene.Field, truth.Posts[post], east, north);
        this->Sky[post] = oracle::SkyFromHorizons(slopes, east, north, SkySteps).SkyViewFactor;
      },
      this->Stop);
  }
  return this->Sky;
}

const ReferenceLight& ReferenceScene::ClearSky()
{
  if (!this->Clear)
  {
    const ReferenceHorizons& truth = this->SkyHorizons();
    const auto sky = MakeClearSky();
    const LightMap map = sky->GetLightMap().Map;
    testing::OwnedMap pixels(map.Columns, map.Rows);
    for (std::ptrdiff_t row = 0; row < map.Rows; ++row)
    {
      std::copy_n(map.Pixel(row, 0), 3 * map.Columns, pixels.At(0, row));
    }
    this->Clear = std::make_unique<ReferenceLight>();
    this->Clear->Posts = truth.Posts;
    this->Clear->Light.resize(truth.Posts.size());
    ForAll(
      truth.Posts.size(),
      [&](std::size_t post)
      {
        double east = 0.0, north = 0.0;
        GradientOf(this->Scene.Field, truth.Posts[post], east, north);
        const testing::Color light = testing::BruteLight(
          pixels, 0.0, [&](double azimuth) { return HorizonAt(truth, post, azimuth); }, east, north,
          static_cast<int>(map.Columns));
        this->Clear->Light[post] = light[0] + light[1] + light[2];
      },
      this->Stop);
    FindMean(*this->Clear);
  }
  return *this->Clear;
}

std::ptrdiff_t ReferenceScene::WindowSide() const
{
  const oracle::OracleField& field = this->Scene.Field;
  return std::min(Side, std::min(field.Columns, field.Rows) - 2);
}

const ReferenceHorizons& ReferenceScene::SunHorizons()
{
  if (!this->Window)
  {
    const oracle::OracleField& field = this->Scene.Field;
    const std::ptrdiff_t side = this->WindowSide();
    const std::ptrdiff_t west = (field.Columns - side) / 2, south = (field.Rows - side) / 2;
    std::vector<std::ptrdiff_t> posts;
    for (std::ptrdiff_t row = south; row < south + side; ++row)
    {
      for (std::ptrdiff_t column = west; column < west + side; ++column)
      {
        posts.push_back(row * field.Columns + column);
      }
    }
    std::vector<double> azimuths;
    azimuths.reserve(Suns.size());
    for (const SunAt& sun : Suns)
    {
      azimuths.push_back(sun.Azimuth);
    }
    this->Window = std::make_unique<ReferenceHorizons>(
      this->Scene, std::move(posts), std::move(azimuths), this->Stop);
  }
  return *this->Window;
}

LampAt ReferenceScene::Lamp() const
{
  const oracle::OracleField& field = this->Scene.Field;
  const std::ptrdiff_t column = field.Columns / 2, row = field.Rows / 2;
  double low = 1e30, high = -1e30;
  for (const double height : field.Heights)
  {
    low = std::isfinite(height) ? std::min(low, height) : low;
    high = std::isfinite(height) ? std::max(high, height) : high;
  }
  const double side = static_cast<double>(std::min(field.Columns, field.Rows)) * field.SpacingX;
  const double ground = field.At(column, row);
  return { static_cast<double>(column) * field.SpacingX, static_cast<double>(row) * field.SpacingY,
    (std::isfinite(ground) ? ground : high) + 0.25 * (high - low) + 0.02 * side, 0.01 * side };
}

const ReferenceLight& ReferenceScene::LampLight()
{
  if (!this->Lit)
  {
    const ReferenceHorizons& truth = this->Horizons(); // for its posts, drawn at random
    this->Lit = std::make_unique<ReferenceLight>();
    this->Lit->Posts.assign(truth.Posts.begin(),
      truth.Posts.begin() + std::min<std::ptrdiff_t>(this->Work.SkyPosts, this->Work.Posts));
    this->Lit->Light.resize(this->Lit->Posts.size());
    const LampAt lamp = this->Lamp();
    const oracle::OracleField& field = this->Scene.Field;
    ForAll(
      this->Lit->Posts.size(),
      [&](std::size_t i)
      {
        const std::ptrdiff_t post = this->Lit->Posts[i];
        double east = 0.0, north = 0.0;
        GradientOf(field, post, east, north);
        this->Lit->Light[i] = 3.0 *
          oracle::BallIrradiance(field, post % field.Columns, post / field.Columns,
            oracle::Unit({ -east, -north, 1.0 }), { { lamp.X, lamp.Y, lamp.Z }, lamp.Radius },
            LampSide);
      },
      this->Stop);
    FindMean(*this->Lit);
  }
  return *this->Lit;
}

} // namespace benchmark
} // namespace skyline
