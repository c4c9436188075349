// SPDX-License-Identifier: BSD-3-Clause
// Figures 3, 4, 6, 9 and 10 of Snyder & Nowrouzezahrai (2008), SN08.
#include "KeyShading.h"
#include "Reconstruction.h"
#include "Sheet.h"
#include "Studio.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace skyline
{
namespace gallery
{

namespace
{

constexpr double Degree = RadiansPerDegree;

/// The light comes from the left of the picture. A swath of 20 degrees is that of SN08's figure 4
/// (section 5).
constexpr double LightAzimuth = 270.0 * Degree;
constexpr double LightElevation = 35.0 * Degree;
constexpr double LightSwath = 20.0 * Degree;

constexpr int KeyAzimuths = 3; // SN08, table 1
constexpr int DirectAzimuths = 64;

/// The ends of the colour scales of errors and of creases, relative to the open light.
constexpr double FullScale = 0.25;
constexpr double FullCrease = 0.005;

constexpr double Metres = 256.0; // width of the scenes
constexpr int PictureWidth = 200, PictureHeight = 150;

std::string Text(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

/// The cone of the paper, with its shadow to the right.
oracle::OracleField ConeScene(std::ptrdiff_t columns)
{
  const double spacing = Metres / static_cast<double>(columns);
  oracle::OracleField field(columns, columns * 3 / 4, spacing, spacing);
  shapes::AddCone(field, 0.27 * static_cast<double>(columns),
    0.5 * static_cast<double>(field.Rows - 1), 28.0, 70.0);
  return field;
}

oracle::OracleField Hills(std::ptrdiff_t columns)
{
  return shapes::Fractal(
    columns, columns * 3 / 4, Metres / static_cast<double>(columns), 60.0, 4, 0.42);
}

/// Level posts whose neighbours within three posts are level too, so that the foot of the cone has
/// no effect.
std::vector<std::size_t> LevelPosts(const oracle::OracleField& field)
{
  constexpr std::ptrdiff_t reach = 3;
  std::vector<std::size_t> posts;
  for (std::ptrdiff_t row = reach; row + reach < field.Rows; ++row)
  {
    for (std::ptrdiff_t column = reach; column + reach < field.Columns; ++column)
    {
      double highest = 0.0;
      for (std::ptrdiff_t j = row - reach; j <= row + reach; ++j)
      {
        for (std::ptrdiff_t i = column - reach; i <= column + reach; ++i)
        {
          highest = std::max(highest, field.At(i, j));
        }
      }
      if (highest <= 0.0)
      {
        posts.push_back(field.Index(column, row));
      }
    }
  }
  return posts;
}

/// The sum of the second differences in both directions, one post apart, where the ground is level;
/// 0 elsewhere. They are visible as lines (Mach bands).
std::vector<float> Creases(const oracle::OracleField& field, const std::vector<float>& light)
{
  const auto columns = static_cast<std::size_t>(field.Columns);
  std::vector<float> creases(light.size(), 0.0f);
  for (const std::size_t post : LevelPosts(field))
  {
    creases[post] = light[post - 1] + light[post + 1] + light[post - columns] +
      light[post + columns] - 4.0f * light[post];
  }
  return creases;
}

/// The greatest change of the light from south to north on level ground, relative to the open
/// light, per metre.
double SteepestEdge(const oracle::OracleField& field, const std::vector<float>& light)
{
  const auto columns = static_cast<std::size_t>(field.Columns);
  double steepest = 0.0;
  for (const std::size_t post : LevelPosts(field))
  {
    steepest = std::max(steepest,
      std::abs(static_cast<double>(light[post + columns]) - static_cast<double>(light[post])));
  }
  return steepest / field.SpacingY;
}

std::vector<float> CutOff(std::vector<float> light)
{
  for (float& value : light)
  {
    value = std::max(value, 0.0f);
  }
  return light;
}

/// A reference for a panel, and the row of its map.
struct ReferenceResult
{
  const char* Name;
  const std::vector<float>& Light;
  std::size_t Row;
};

/// Fills a figure of one scene, one panel after the other: each has a view and maps below it.
class Study
{
public:
  Study(Studio& studio, const Scale& scale, Figure& figure, const Scene& scene)
    : Painter(studio)
    , Sheet(figure)
    , Terrain(scene)
  {
    this->View.Width = scale.Pixels(PictureWidth);
    this->View.Height = scale.Pixels(PictureHeight);
    this->View.From.Azimuth = 192.0;
    this->View.From.Elevation = 48.0;
    this->View.From.Filled = 0.99;
  }

  /// light: in units of the open light.
  void Add(const std::string& setting, const std::vector<float>& light,
    const std::vector<ReferenceResult>& truths)
  {
    this->Sheet.Rows[0].Panels.push_back({ setting, this->Draw(light) });
    for (const ReferenceResult& truth : truths)
    {
      const Errors errors = ErrorsOf(light, truth.Light);
      this->Sheet.Table.push_back({ setting, truth.Name, errors });
      std::vector<float> error(light);
      for (std::size_t k = 0; k < error.size(); ++k)
      {
        error[k] -= truth.Light[k];
      }
      this->AddMap(truth.Row,
        Text("rms %.1f %%", 100.0 * errors.Rms) + Text(", largest %.0f %%", 100.0 * errors.Largest),
        error, FullScale);
    }
  }

  void AddCreases(std::size_t row, const std::string& setting, const std::vector<float>& light)
  {
    const std::vector<float> creases = Creases(this->Terrain.Heights, light);
    const Errors size = ErrorsOf(creases, std::vector<float>(creases.size(), 0.0f));
    this->Sheet.Numbers.push_back(
      { setting, "largest crease, % of the open light", 100.0 * size.Largest });
    this->AddMap(row, Text("largest %.2f %%", 100.0 * size.Largest), creases, FullCrease);
  }

private:
  Picture Draw(std::vector<float> light)
  {
    for (float& value : light)
    {
      value *= static_cast<float>(Pi);
    }
    return this->Painter.Draw(this->Terrain.Heights, Grey(light), this->View);
  }

  /// Adds a map below the view that was added last.
  void AddMap(
    std::size_t row, const std::string& caption, const std::vector<float>& values, double full)
  {
    auto& panels = this->Sheet.Rows[row].Panels;
    while (panels.size() + 1 < this->Sheet.Rows[0].Panels.size())
    {
      panels.push_back({ "", Picture(this->View.Width, this->View.Height, 255) });
    }
    panels.push_back({ caption,
      DifferenceMap(values, static_cast<int>(this->Terrain.Posts.Columns),
        static_cast<int>(this->Terrain.Posts.Rows), full, this->View.Width, this->View.Height) });
  }

  Studio& Painter;
  Figure& Sheet;
  const Scene& Terrain;
  Look View;
};

/// A disc, and its shading by the method of the paper and by others. The open light is 1.
class DiscLight
{
public:
  explicit DiscLight(const Scene& scene)
    : Terrain(scene)
    , Disc{ LightAzimuth, LightElevation,
      std::asin(std::sin(0.5 * LightSwath) * std::cos(LightElevation)) }
    , Extent(SwathOf(Disc))
  {
    KeyLightHarmonics(
      this->Disc, this->Extent, 4, this->Projected.data(), KeyLightSeries::Projected);
    this->Projected = PublishedUnit(this->Projected, this->Extent, KeyAzimuths);
    KeyLightHarmonics(this->Disc, this->Extent, 4, this->Fitted.data());
    const double facing = FacingIrradiance(this->Disc);
    for (double& coefficient : this->Fitted)
    {
      coefficient /= facing;
    }
    this->Whole = DirectShading(scene, this->Disc, DirectAzimuths);
    for (float& value : this->Whole)
    {
      value = static_cast<float>(static_cast<double>(value) / facing);
    }
    this->Exact = this->Published(ExactHorizons(scene));
  }

  std::vector<float> Published(const HorizonsAt& horizons) const
  {
    return CutOff(PublishedShading(this->Terrain,
      PublishedVisibility(this->Terrain.East.size(), horizons, this->Extent, KeyAzimuths),
      this->Projected));
  }
  std::vector<float> Ours() const
  {
    return CutOff(TransferShading(
      this->Terrain, ExactHorizons(this->Terrain), this->Extent, KeyAzimuths, this->Fitted));
  }
  std::vector<ReferenceResult> ReferenceResults() const
  {
    return { { "exact horizons", this->Exact, 1 }, { "direct", this->Whole, 2 } };
  }

  /// Adds the last panels of each figure: exact horizons (the part of the error that is not
  /// theirs), Skyline's default, and the reference.
  void AddLimits(Study& study, bool creases) const
  {
    study.Add("exact horizons", this->Exact, { { "direct", this->Whole, 2 } });
    if (creases)
    {
      study.AddCreases(3, "exact horizons", this->Exact);
    }
    study.Add("Skyline's default", this->Ours(), { { "direct", this->Whole, 2 } });
    study.Add("direct integration", this->Whole, {});
  }

private:
  const Scene& Terrain;
  KeyLight Disc;
  Swath Extent;
  Light16 Projected{}, Fitted{};
  std::vector<float> Whole, Exact;
};

/// A setting of a figure whose panels differ only in their horizons.
struct Setting
{
  std::string Name;
  HorizonsAt Horizons;
};

Figure Compare(Studio& studio, const Scale& scale, const Scene& scene, const std::string& title,
  const std::vector<Setting>& settings, bool creases = false)
{
  Figure figure;
  figure.Title = title;
  figure.Rows = { PanelRow{ "irradiance", {} },
    PanelRow{ "difference from the same shading above exact horizons (map): red brighter, blue "
              "darker; full colour at 25 % of the open light",
      {} },
    PanelRow{ "error against direct integration (map), same scale", {} } };
  if (creases)
  {
    figure.Rows.push_back({ "creases on level ground (map): sum of second differences of the "
                            "irradiance, one post apart; full colour at 0.5 % of the open light",
      {} });
  }
  Study study(studio, scale, figure, scene);
  const DiscLight light(scene);
  for (const Setting& setting : settings)
  {
    const std::vector<float> shading = light.Published(setting.Horizons);
    study.Add(setting.Name, shading, light.ReferenceResults());
    if (creases)
    {
      study.AddCreases(3, setting.Name, shading);
    }
  }
  light.AddLimits(study, creases);
  return figure;
}

Figure LevelSteps(Studio& studio, const Scale& scale)
{
  const Scene scene(ConeScene(scale.Posts(256)));
  std::vector<Setting> settings;
  for (const int k : { 1, 2, 3, 4 })
  {
    settings.push_back({ Text("k = %.0f", k), PyramidHorizons(scene, k, 2.0) });
  }
  return Compare(studio, scale, scene, "SN08, figure 3: levels per octave k of the pyramid (o = 2)",
    settings, true);
}

Figure LevelOffsets(Studio& studio, const Scale& scale)
{
  const Scene scene(ConeScene(scale.Posts(256)));
  std::vector<Setting> settings;
  for (const int o : { 0, 1, 2, 3, 4 })
  {
    settings.push_back({ Text("o = %.0f", o), PyramidHorizons(scene, 4.0, o) });
  }
  return Compare(studio, scale, scene, "SN08, figure 4: level offset o (k = 4)", settings);
}

Figure Reconstructions(Studio& studio, const Scale& scale)
{
  const Scene scene(ConeScene(scale.Posts(256)));
  const auto horizons = [&](Along along, Across across)
  { return ReconstructedHorizons(scene, 4.0, 1.0, along, across); };
  return Compare(studio, scale, scene,
    "SN08, figure 9: reconstruction along the levels (1D) and between samples (2D) (k = 4, o = 1)",
    { { "linear 1D, bilinear 2D", horizons(Along::Linear, Across::Bilinear) },
      { "b-spline 1D, bilinear 2D", horizons(Along::Spline, Across::Bilinear) },
      { "linear 1D, b-spline 2D", horizons(Along::Linear, Across::Spline) },
      { "b-spline 1D and 2D", horizons(Along::Spline, Across::Spline) } },
    true);
}

Figure Convergence(Studio& studio, const Scale& scale)
{
  const Scene scene(Hills(scale.Posts(512)));
  std::vector<Setting> settings;
  for (const int k : { 1, 2, 4, 8 })
  {
    settings.push_back({ Text("k = o = %.0f", k), PyramidHorizons(scene, k, k) });
  }
  return Compare(studio, scale, scene,
    "SN08, figure 10: towards the ground truth, 512 x 384 posts of fractal terrain", settings);
}

Figure Swaths(Studio& studio, const Scale& scale)
{
  const Scene scene(ConeScene(scale.Posts(256)));
  constexpr int azimuths = 32;
  Figure figure;
  figure.Title =
    "SN08, figure 6: swath of the most concentrated light of order 4 (k = 4, o = 2, 32 azimuths)";
  figure.Rows = { PanelRow{ "irradiance", {} },
    PanelRow{ "error against direct integration of the same light (map): red too bright, blue too "
              "dark; full colour at 25 % of the open light",
      {} } };
  Study study(studio, scale, figure, scene);
  const Light16 peak = PeakLight(LightAzimuth, LightElevation);
  std::vector<float> narrowest;
  for (const double degrees : { 360.0, 90.0, 45.0, 22.5, 11.25 })
  {
    const Swath swath{ LightAzimuth, degrees * Degree };
    const auto truth = CutOff(
      TransferShading(scene, ExactHorizons(scene), swath, 2 * azimuths, TransferUnit(peak, swath)));
    const auto shading = CutOff(PublishedShading(scene,
      PublishedVisibility(scene.East.size(), PyramidHorizons(scene, 4.0, 2.0), swath, azimuths),
      PublishedUnit(peak, swath, azimuths)));
    study.Add(Text("swath %g degrees", degrees), shading, { { "direct", truth, 1 } });
    figure.Numbers.push_back(
      { Text("swath %g degrees", degrees), "steepest edge, % of the open light per metre",
        100.0 * SteepestEdge(scene.Heights, shading) });
    narrowest = truth;
  }
  study.Add("direct, 11.25 degrees", narrowest, {});
  return figure;
}

} // namespace

std::vector<FigureMaker> KeyFigures()
{
  return { { "sn08-3", LevelSteps }, { "sn08-4", LevelOffsets }, { "sn08-6", Swaths },
    { "sn08-9", Reconstructions }, { "sn08-10", Convergence } };
}

} // namespace gallery
} // namespace skyline
