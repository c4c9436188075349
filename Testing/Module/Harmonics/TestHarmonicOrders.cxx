// SPDX-License-Identifier: BSD-3-Clause
// Compares the irradiance by spherical harmonics of 2 to 8 bands with direct integration over the
// same horizons, and wedges with the horizons between azimuths. Prints the tables of
// Documentation/sn08.md.
#include "Harmonics/HarmonicProduct.h"
#include "Harmonics/LightFit.h"
#include "Harmonics/VisibilityAccumulator.h"
#include "HeightField/Normals.h"
#include "Reference/OracleTerrain.h"
#include "Reference/VisibilityWedge.h"
#include "Testing/Module/RealTerrain.h"
#include "WedgeTesting.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <map>
#include <string>

namespace skyline
{
namespace testing
{
namespace
{

constexpr int Azimuths = 64;
constexpr int Elevations = 180; // of the direct integration

/// Percent of the irradiance: the error that LightFitRidge causes where the series could be exact.
constexpr double RidgeError = 0.02;

/// Some posts of a scene, with their horizons.
struct Posts
{
  std::vector<std::vector<float>> Slopes; ///< [azimuth][post]
  std::vector<float> East, North;         ///< gradients
};

Posts PostsOf(const oracle::OracleField& field, int azimuths, std::size_t step)
{
  const Grid grid = GridOf(field);
  std::vector<float> east(field.Heights.size()), north(field.Heights.size());
  Gradients(grid, PostView<double>{ field.Heights.data(), 1, field.Columns }, 0, field.Rows,
    east.data(), north.data());
  const HeightField heights = FieldOf(field);
  const auto method = MakeHorizonMethod(heights, HorizonSettings());
  Posts posts;
  for (int k = 0; k < azimuths; ++k)
  {
    const std::vector<float> slopes = Slopes(*method, grid, 360.0 * k / azimuths);
    posts.Slopes.emplace_back();
    for (std::size_t post = 0; post < slopes.size(); post += step)
    {
      posts.Slopes.back().push_back(slopes[post]);
    }
  }
  for (std::size_t post = 0; post < east.size(); post += step)
  {
    posts.East.push_back(east[post]);
    posts.North.push_back(north[post]);
  }
  return posts;
}

std::vector<float> Accumulate(const Posts& posts, int bands, bool transfer)
{
  const auto count = static_cast<std::ptrdiff_t>(posts.East.size());
  std::vector<float> values(posts.East.size() * static_cast<std::size_t>(HarmonicCount(bands)));
  VisibilityAccumulator sums({ count, 1, bands, values.data(), SkyPart::Upper },
    transfer ? posts.East.data() : nullptr, transfer ? posts.North.data() : nullptr);
  const auto azimuths = static_cast<double>(posts.Slopes.size());
  for (std::size_t k = 0; k < posts.Slopes.size(); ++k)
  {
    sums.Begin(2.0 * Pi * static_cast<double>(k) / azimuths, 2.0 * Pi / azimuths);
    sums.Add(0, 0, count, posts.Slopes[k].data());
  }
  sums.Finish(0, 1);
  return values;
}

/// The irradiance of each post by direct integration of the sky above the horizon in each azimuth.
std::vector<double> Direct(const Posts& posts, const Radiance& light)
{
  std::vector<double> irradiance(posts.East.size(), 0.0);
  const double width = 2.0 * Pi / Azimuths, step = 0.5 * Pi / Elevations;
  for (int k = 0; k < Azimuths; ++k)
  {
    for (int e = 0; e < Elevations; ++e)
    {
      const double elevation = (e + 0.5) * step;
      const Vector d = DirectionOf(k * width, elevation);
      const double flux = light(d) * width * step * std::cos(elevation);
      for (std::size_t post = 0; post < irradiance.size(); ++post)
      {
        const double horizon =
          std::atan(static_cast<double>(posts.Slopes[static_cast<std::size_t>(k)][post]));
        const double visible =
          std::clamp(e + 1.0 - horizon / step, 0.0, 1.0); // part of the cell above the horizon
        const Vector n =
          NormalOf(static_cast<double>(posts.East[post]), static_cast<double>(posts.North[post]));
        irradiance[post] += visible * flux * std::max(0.0, n.X * d.X + n.Y * d.Y + n.Z * d.Z);
      }
    }
  }
  return irradiance;
}

double Angle(const Vector& a, const Vector& b)
{
  return std::acos(std::clamp(a.X * b.X + a.Y * b.Y + a.Z * b.Z, -1.0, 1.0));
}

/// A sky: its radiance above the horizontal plane.
struct NamedLight
{
  const char* Name;
  Radiance Light;
};

const std::vector<NamedLight>& Lights()
{
  static const Vector sun = DirectionOf(2.3, 0.7);
  static const std::vector<NamedLight> lights{
    // Moon & Spencer (1942).
    { "overcast", [](const Vector& d) { return (1.0 + 2.0 * d.Z) / 3.0; } },
    // A bright rim and a glow around the sun, as in clear skies (the shape of CIE type 12).
    { "clear",
      [](const Vector& d)
      {
        const double gamma = Angle(d, sun);
        return (1.0 - std::exp(-0.32 / std::max(d.Z, 0.01))) *
          (0.91 + 10.0 * std::exp(-3.0 * gamma) + 0.45 * std::pow(std::cos(gamma), 2.0));
      } },
    { "disc of 10 degrees",
      [](const Vector& d) { return Angle(d, sun) < 10.0 * RadiansPerDegree ? 1.0 : 0.0; } },
  };
  return lights;
}

/// The coefficients of a light on the whole sphere, which below the horizontal plane is either dark
/// or mirrored.
std::vector<double> Coefficients(const Radiance& light, bool mirrored)
{
  return Project(
    8, 0.0, 2.0 * Pi, 360, 720, [](double) { return -0.5 * Pi; },
    [&](const Vector& d)
    {
      const Vector above{ d.X, d.Y, std::abs(d.Z) };
      return d.Z > 0.0 || mirrored ? light(above) : 0.0;
    });
}

/// The root mean square of the differences, in percent of the mean of the reference.
double Percent(const std::vector<double>& found, const std::vector<double>& truth)
{
  double squares = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    squares += (found[i] - truth[i]) * (found[i] - truth[i]);
    sum += truth[i];
  }
  const auto count = static_cast<double>(truth.size());
  return 100.0 * std::sqrt(squares / count) / (sum / count);
}

std::vector<double> Lit(
  const std::vector<float>& transfer, int bands, const std::vector<double>& light)
{
  const auto count = static_cast<std::size_t>(HarmonicCount(bands));
  std::vector<double> irradiance;
  for (std::size_t post = 0; post < transfer.size() / count; ++post)
  {
    double sum = 0.0;
    for (std::size_t c = 0; c < count; ++c)
    {
      sum += static_cast<double>(transfer[post * count + c]) * light[c];
    }
    irradiance.push_back(sum);
  }
  return irradiance;
}

/// The transfer vectors of SN08: products of two truncated series.
std::vector<float> Products(const Posts& posts, const std::vector<float>& visibility, int bands)
{
  const auto count = static_cast<std::size_t>(HarmonicCount(bands));
  std::vector<float> transfer(visibility.size());
  double zonal[8];
  for (int l = 0; l < bands; ++l)
  {
    zonal[l] = ClampedCosineZonal(l);
  }
  for (std::size_t post = 0; post < posts.East.size(); ++post)
  {
    const Vector n =
      NormalOf(static_cast<double>(posts.East[post]), static_cast<double>(posts.North[post]));
    double cosine[64], sky[64], product[64];
    RotateZonal(bands, zonal, n.X, n.Y, n.Z, cosine);
    std::copy_n(visibility.begin() + static_cast<std::ptrdiff_t>(post * count), count, sky);
    HarmonicProduct::ForBands(bands).Product(cosine, sky, product);
    for (std::size_t c = 0; c < count; ++c)
    {
      transfer[post * count + c] = static_cast<float>(product[c]);
    }
  }
  return transfer;
}

struct NamedScene
{
  const char* Name;
  oracle::OracleField Field;
};

/// The scenes of the papers (moving ones at one moment) and real terrain.
std::vector<NamedScene> Scenes()
{
  return {
    { "St Helens", SaintHelens() },
    { "mountain", shapes::Fractal(160, 160, 30.0, 300.0, 1) },
    { "egg tray", shapes::EggTray(128, 128, 10.0, 80.0, 320.0) },
    { "cone", shapes::Cone(129, 129, 1.0, 40.0, 40.0) },
    { "cones v1", shapes::ConesInRows(128, 128, 2.0, 22.0, 40.0) },
    { "cones v2", shapes::ConesOnCircle(128, 128, 2.0, 24.0, 36.0) },
    { "grating", shapes::SineGrating(128, 128, 1.0, 6.0, 32.0) },
    { "city", shapes::City(160, 160, 1.0, 20, 12, 30.0, 3) },
    { "teddy", shapes::Teddy(128, 128, 2.0, 40.0) },
    { "waves", shapes::Waves(128, 128, 2.0, 6.0, 40.0, 0.4) },
    { "landslide", shapes::Landslide(128, 128, 10.0, 0.5, 150.0, 0.7) },
  };
}

TEST(HarmonicOrders, IrradianceAgainstDirectIntegration)
{
  std::map<std::string, std::array<std::vector<double>, 2>> lights; // dark and mirrored
  for (const NamedLight& light : Lights())
  {
    lights[light.Name] = { Coefficients(light.Light, false), Coefficients(light.Light, true) };
  }
  std::printf("%-10s %-19s %5s  %9s %9s %9s %9s   rmse of irradiance, %% of its mean\n", "scene",
    "light", "bands", "fitted", "mirrored", "dark", "product");
  std::map<std::string, std::array<double, 9>> errors; // of the transfer, by light and bands
  std::map<std::string, std::array<double, 9>> products;
  const auto scenes = Scenes();
  for (const NamedScene& scene : scenes)
  {
    ASSERT_GT(scene.Field.Columns, 0) << scene.Name;
    const Posts posts = PostsOf(scene.Field, Azimuths, 149);
    std::map<std::string, std::vector<double>> truth;
    for (const NamedLight& light : Lights())
    {
      truth[light.Name] = Direct(posts, light.Light);
    }
    for (int bands = 2; bands <= 8; ++bands)
    {
      const std::vector<float> transfer = Accumulate(posts, bands, true);
      const std::vector<float> product = Products(posts, Accumulate(posts, bands, false), bands);
      for (const NamedLight& light : Lights())
      {
        const auto& [dark, mirrored] = lights[light.Name];
        std::vector<double> fitted(static_cast<std::size_t>(HarmonicCount(bands)));
        FitLight(Swath(), bands, dark.data(), fitted.data());
        const auto percent = [&](const std::vector<float>& vectors, const std::vector<double>& l)
        { return Percent(Lit(vectors, bands, l), truth[light.Name]); };
        const double error = percent(transfer, fitted);
        const double paper = percent(product, mirrored);
        std::printf("%-10s %-19s %5d  %9.3f %9.3f %9.3f %9.3f\n", scene.Name, light.Name, bands,
          error, percent(transfer, mirrored), percent(transfer, dark), paper);
        const auto index = static_cast<std::size_t>(bands);
        errors[light.Name][index] = std::max(errors[light.Name][index], error);
        products[light.Name][index] = std::max(products[light.Name][index], paper);
      }
    }
  }
  // The greatest error of all scenes decreases with the order, and each order is sufficient for its
  // purpose. No order can represent a disc.
  for (const auto& [name, error] : errors)
  {
    EXPECT_LT(error[4], std::max(error[2], RidgeError)) << name;
    EXPECT_LT(error[8], std::max(error[4], RidgeError)) << name;
    EXPECT_LT(error[4], products[name][4]) << name;
  }
  EXPECT_LT(errors["overcast"][4], 0.05);
  EXPECT_LT(errors["clear"][4], 2.0);
}

// Compares horizons that are constant over a swath with horizons that are linear between azimuths,
// as in SN08, both against 360 azimuths of the real terrain.
TEST(HarmonicOrders, StepWedgesAgainstLinearOnes)
{
  const Posts fine = PostsOf(SaintHelens(), 360, 149);
  const std::size_t posts = fine.East.size();
  const std::vector<float> truth = Accumulate(fine, 4, false);
  std::printf("%8s  %9s %9s %9s   rms of the error of VisibilitySH, order 4, St Helens\n",
    "azimuths", "step", "linear", "table");
  for (const std::size_t n : { 3u, 4u, 5u, 6u, 8u, 12u, 18u, 36u, 72u })
  {
    Posts coarse = fine;
    coarse.Slopes.clear();
    for (std::size_t k = 0; k < n; ++k)
    {
      coarse.Slopes.push_back(fine.Slopes[k * 360 / n]);
    }
    const std::vector<float> step = Accumulate(coarse, 4, false);
    const double width = 2.0 * Pi / static_cast<double>(n);
    const WedgeTable table(4, width);
    double squares[3] = {};
    for (std::size_t post = 0; post < posts; ++post)
    {
      double linear[16] = {}, tabled[16] = {}, wedge[16];
      for (std::size_t k = 0; k < n; ++k)
      {
        const double from = std::max(0.0, std::atan(static_cast<double>(coarse.Slopes[k][post])));
        const double to =
          std::max(0.0, std::atan(static_cast<double>(coarse.Slopes[(k + 1) % n][post])));
        const double azimuth = static_cast<double>(k) * width;
        LinearWedge(4, azimuth, width, from, to, wedge);
        table.AddInterior(azimuth, from, to, tabled);
        for (int c = 0; c < 16; ++c)
        {
          linear[c] += wedge[c];
        }
      }
      for (std::size_t c = 0; c < 16; ++c)
      {
        const auto right = static_cast<double>(truth[post * 16 + c]);
        squares[0] += std::pow(static_cast<double>(step[post * 16 + c]) - right, 2.0);
        squares[1] += std::pow(linear[c] - right, 2.0);
        squares[2] += std::pow(tabled[c] - right, 2.0);
      }
    }
    double rms[3];
    for (int k = 0; k < 3; ++k)
    {
      rms[k] = std::sqrt(squares[k] / static_cast<double>(posts));
    }
    std::printf("%8zu  %9.5f %9.5f %9.5f\n", n, rms[0], rms[1], rms[2]);
    if (n >= 5)
    {
      EXPECT_LT(rms[0], rms[1]) << n;
    }
    EXPECT_NEAR(rms[1], rms[2], 0.01 * rms[1]) << n; // the error that the table adds
  }
}

} // namespace
} // namespace testing
} // namespace skyline
