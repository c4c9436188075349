// SPDX-License-Identifier: BSD-3-Clause
// Figures 6.1 to 6.5 of the thesis on local lights (THESIS).
#include "Environment.h"
#include "LampShading.h"
#include "Reference/ThesisScenes.h"
#include "Sheet.h"
#include "Studio.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace skyline
{
namespace gallery
{

namespace
{

constexpr int Posts = 256;        // THESIS, figures 6.3 to 6.5
constexpr int SwathCount = 32;    // as in these figures
constexpr double LevelStep = 4.0; // as in these figures
constexpr int PictureWidth = 204, PictureHeight = 166;

/// So many azimuths that more of them make no difference.
constexpr int ManyAzimuths = 128;

/// The ends of the colour scales of errors, and of differences from more azimuths or levels.
/// Relative to the root mean square irradiance of the scene.
constexpr double FullScale = 0.25;
constexpr double FullRest = 0.03;

/// The irradiance of the sky at dusk, relative to that of a bright post under the lamps.
constexpr double SkyPart = 0.35;

/// Without lamps: the irradiance that appears white, relative to that of level open ground.
constexpr double SkyAlone = 2.5;

constexpr std::array<float, 3> Colors[] = { { { 1.0f, 0.80f, 0.55f } }, { { 0.70f, 0.88f, 1.0f } },
  { { 1.0f, 0.62f, 0.50f } } };

using Region = std::array<double, 4>; // as in Look

std::string Percent(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f %%", 100.0 * value);
  return text;
}

testing::ThesisScene SceneCalled(const std::string& name, const Scale& scale)
{
  for (testing::ThesisScene& scene : testing::ThesisScenes(scale.Posts(Posts)))
  {
    if (name == scene.Name)
    {
      return scene;
    }
  }
  return {};
}

std::vector<ColoredLamp> Colored(const std::vector<oracle::Ball>& balls, std::size_t count)
{
  std::vector<ColoredLamp> lamps;
  for (std::size_t k = 0; k < std::min(count, balls.size()); ++k)
  {
    lamps.push_back({ balls[k], Colors[k % 3] });
  }
  return lamps;
}

double RootMeanSquare(const std::vector<float>& values)
{
  double squares = 0.0;
  for (const float value : values)
  {
    squares += static_cast<double>(value) * static_cast<double>(value);
  }
  return std::sqrt(squares / static_cast<double>(values.size()));
}

/// The 90th percentile of the values.
double Bright(std::vector<float> values)
{
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 9 / 10);
  std::nth_element(values.begin(), place, values.end());
  return static_cast<double>(*place);
}

/// A region of posts.
struct Part
{
  std::ptrdiff_t West, East, South, North; // East and North: one past the last post

  Part(const Grid& posts, const Region& region)
    : West(0)
    , East(posts.Columns)
    , South(0)
    , North(posts.Rows)
  {
    if (region[0] < region[1])
    {
      this->West = static_cast<std::ptrdiff_t>(region[0] / posts.SpacingX);
      this->East =
        std::min(this->East, static_cast<std::ptrdiff_t>(region[1] / posts.SpacingX) + 1);
      this->South = static_cast<std::ptrdiff_t>(region[2] / posts.SpacingY);
      this->North =
        std::min(this->North, static_cast<std::ptrdiff_t>(region[3] / posts.SpacingY) + 1);
    }
  }
  std::vector<float> Of(const std::vector<float>& values, std::ptrdiff_t columns) const
  {
    std::vector<float> part;
    for (std::ptrdiff_t row = this->South; row < this->North; ++row)
    {
      const auto line = values.begin() + row * columns;
      part.insert(part.end(), line + this->West, line + this->East);
    }
    return part;
  }
};

/// The errors in one region of a scene, and a map of them.
struct Comparison
{
  Errors Error;
  Picture Map;
};

/// found, truth: RGB. The errors of their luminances are in units of `unit`.
Comparison Compare(const Scene& scene, const Region& region, const std::vector<float>& found,
  const std::vector<float>& truth, double unit, double full, int side)
{
  const Part part(scene.Posts, region);
  const std::vector<float> light = part.Of(LuminanceOf(found), scene.Posts.Columns);
  const std::vector<float> right = part.Of(LuminanceOf(truth), scene.Posts.Columns);
  std::vector<float> error(light);
  for (std::size_t k = 0; k < error.size(); ++k)
  {
    error[k] -= right[k];
  }
  return { ErrorsOf(light, right, unit),
    DifferenceMap(error, static_cast<int>(part.East - part.West),
      static_cast<int>(part.North - part.South), full * unit, side, side) };
}

const char* const MapLabel =
  "error against direct integration (map): red too bright, blue too dark; "
  "full colour at 25 % of the rms irradiance";

/// The scene of figures 6.1 and 6.2: the second largest cone of cones v2, from above, with its
/// shadow away from the lamp.
class ConeDetail
{
public:
  /// limit: the name of the result to which the panels converge.
  ConeDetail(Studio& studio, const Scale& scale, Figure& figure, const char* limit)
    : Painter(studio)
    , Sheet(figure)
    , Source(SceneCalled("cones v2", scale))
    , Terrain(Source.Field)
    , Lamps(Colored(Source.Lamps, 1))
    , LimitName(limit)
  {
    this->Lamps[0].Radiance = { { 1.0f, 1.0f, 1.0f } };
    this->Direct = DirectLamps(this->Terrain, this->Lamps);
    this->View.Width = this->View.Height = scale.Pixels(PictureWidth);
    this->View.From.Elevation = 90.0;
    this->View.From.Filled = 1.0;
    this->View.Region = Cone;
    // Brighter than the whole scene requires, because the shadows are shown.
    this->View.Exposure = std::log2(2.0 * Pi / Bright(LuminanceOf(this->Direct)));
    this->Sheet.Rows = { PanelRow{ "irradiance, seen from above", {} },
      PanelRow{ std::string("difference from ") + limit +
          " (map): red brighter, blue darker; full colour at 3 % of the rms irradiance",
        {} },
      PanelRow{ MapLabel, {} } };
  }

  std::vector<float> Harmonics(int azimuths, double levelStep) const
  {
    return HarmonicLamps(this->Terrain, this->Lamps, azimuths, levelStep);
  }

  void Add(
    const std::string& setting, const std::vector<float>& rgb, const std::vector<float>& limit)
  {
    this->Sheet.Rows[0].Panels.push_back(
      { setting, this->Painter.Draw(this->Terrain.Heights, rgb, this->View) });
    this->AddMap(1, setting, this->LimitName, rgb, limit, FullRest);
    this->AddMap(2, setting, "direct", rgb, this->Direct, FullScale);
  }
  void AddReference()
  {
    this->Sheet.Rows[0].Panels.push_back({ "direct integration",
      this->Painter.Draw(this->Terrain.Heights, this->Direct, this->View) });
  }

private:
  void AddMap(std::size_t row, const std::string& setting, const char* against,
    const std::vector<float>& rgb, const std::vector<float>& truth, double full)
  {
    const double unit = RootMeanSquare(LuminanceOf(this->Direct));
    Comparison found =
      Compare(this->Terrain, this->View.Region, rgb, truth, unit, full, this->View.Width);
    this->Sheet.Table.push_back({ setting, against, found.Error });
    this->Sheet.Rows[row].Panels.push_back(
      { "rms " + Percent(found.Error.Rms), std::move(found.Map) });
  }

  static constexpr Region Cone{ { 32.0, 122.0, 160.0, 250.0 } };

  Studio& Painter;
  Figure& Sheet;
  testing::ThesisScene Source;
  Scene Terrain;
  std::vector<ColoredLamp> Lamps;
  const char* LimitName;
  std::vector<float> Direct;
  Look View;
};

Figure Azimuths(Studio& studio, const Scale& scale)
{
  Figure figure;
  figure.Title = "THESIS, figure 6.1: number of azimuths (order 4, 4 levels per octave)";
  ConeDetail detail(studio, scale, figure, "128 azimuths");
  const std::vector<float> many = detail.Harmonics(ManyAzimuths, LevelStep);
  for (const int azimuths : { 4, 8, 16, 32 })
  {
    detail.Add(std::to_string(azimuths) + " azimuths", detail.Harmonics(azimuths, LevelStep), many);
  }
  detail.AddReference();
  return figure;
}

Figure Steps(Studio& studio, const Scale& scale)
{
  Figure figure;
  figure.Title = "THESIS, figure 6.2: levels per octave (order 4, 32 azimuths, level offset 4)";
  ConeDetail detail(studio, scale, figure, "exact horizons");
  const std::vector<float> exact = detail.Harmonics(SwathCount, 0.0);
  for (const int step : { 1, 2, 3, 4 })
  {
    detail.Add("ls = " + std::to_string(step), detail.Harmonics(SwathCount, step), exact);
  }
  detail.AddReference();
  return figure;
}

/// A picture of the figures 6.3 to 6.5.
struct Shot
{
  const char* Caption;
  std::string Scene;
  std::size_t Lamps;
  bool Sky;
  Standpoint From;
  Region Part;
};

Standpoint From(double azimuth, double elevation)
{
  Standpoint from;
  from.Azimuth = azimuth;
  from.Elevation = elevation;
  return from;
}

/// A scene with its light.
struct LitScene
{
  explicit LitScene(const testing::ThesisScene& source)
    : Terrain(source.Field)
  {
  }
  Scene Terrain;
  std::vector<ColoredLamp> Lamps;
  std::vector<float> Found, Direct; // RGB: by the method of the thesis, and by direct integration
  std::vector<float> Transferred;   // RGB of a sky alone, by Skyline's method
  double Level = 1.0;               // the irradiance of a bright post
};

std::unique_ptr<LitScene> Light(const Scale& scale, const Shot& shot)
{
  testing::ThesisScene source = SceneCalled(shot.Scene, scale);
  if (shot.Scene == "cones v1") // figure 6.3d has a third lamp
  {
    source.Lamps.push_back({ { 96.0, 160.0, 24.0 }, 6.0 });
  }
  auto lit = std::make_unique<LitScene>(source);
  const Scene& scene = lit->Terrain;
  lit->Lamps = Colored(source.Lamps, shot.Lamps);
  lit->Direct = DirectLamps(scene, lit->Lamps);
  lit->Found = HarmonicLamps(scene, lit->Lamps, SwathCount, LevelStep);
  const double lampLight = lit->Lamps.empty() ? 0.0 : Bright(LuminanceOf(lit->Direct));
  lit->Level = lampLight;
  if (shot.Sky)
  {
    const double brightness = lit->Lamps.empty() ? 1.0 : SkyPart * lampLight;
    lit->Level += lit->Lamps.empty() ? SkyAlone * brightness : brightness;
    const Environment sky(brightness);
    const std::vector<float> direct = sky.Direct(scene);
    const std::vector<float> published =
      sky.Published(scene, PyramidHorizons(scene, LevelStep, 4.0));
    for (std::size_t k = 0; k < direct.size(); ++k)
    {
      lit->Direct[k] += direct[k];
      lit->Found[k] += std::max(0.0f, published[k]);
    }
    if (lit->Lamps.empty())
    {
      lit->Transferred = sky.Transferred(scene);
    }
  }
  return lit;
}

void Take(Studio& studio, const Scale& scale, const Shot& shot, const LitScene& lit, Figure& figure)
{
  Look look;
  look.Width = scale.Pixels(PictureWidth);
  look.Height = scale.Pixels(PictureHeight);
  look.From = shot.From;
  look.Region = shot.Part;
  look.Exposure = std::log2(Pi / lit.Level);
  for (const ColoredLamp& lamp : lit.Lamps)
  {
    look.Bulbs.push_back({ lamp.Ball,
      { { static_cast<double>(lamp.Radiance[0]), static_cast<double>(lamp.Radiance[1]),
        static_cast<double>(lamp.Radiance[2]) } } });
  }
  const double unit = RootMeanSquare(LuminanceOf(lit.Direct));
  const Comparison found =
    Compare(lit.Terrain, shot.Part, lit.Found, lit.Direct, unit, FullScale, look.Height);
  figure.Table.push_back({ shot.Caption, "direct", found.Error });
  if (!lit.Transferred.empty())
  {
    figure.Table.push_back({ std::string(shot.Caption) + ", Skyline's default", "direct",
      Compare(lit.Terrain, shot.Part, lit.Transferred, lit.Direct, unit, FullScale, look.Height)
        .Error });
  }
  figure.Rows[0].Panels.push_back(
    { shot.Caption, studio.Draw(lit.Terrain.Heights, lit.Found, look) });
  figure.Rows[1].Panels.push_back({ "", studio.Draw(lit.Terrain.Heights, lit.Direct, look) });
  Picture wide(look.Width, look.Height, 255); // as wide as the pictures above it
  Paste(wide, found.Map, (look.Width - found.Map.Width) / 2, 0);
  figure.Rows[2].Panels.push_back({ "rms " + Percent(found.Error.Rms), std::move(wide) });
}

Figure Album(
  Studio& studio, const Scale& scale, const std::string& title, const std::vector<Shot>& shots)
{
  Figure figure;
  figure.Title = title;
  figure.Rows = { PanelRow{ "as in the thesis: order 4, ls = 4, lo = 4, 32 azimuths", {} },
    PanelRow{ "direct integration", {} }, PanelRow{ MapLabel, {} } };
  std::unique_ptr<LitScene> lit;
  const Shot* before = nullptr;
  for (const Shot& shot : shots)
  {
    if (!before || before->Scene != shot.Scene || before->Lamps != shot.Lamps ||
      before->Sky != shot.Sky)
    {
      lit = Light(scale, shot);
    }
    before = &shot;
    Take(studio, scale, shot, *lit, figure);
  }
  return figure;
}

const Region All{ {} };

Figure CityAndCones(Studio& studio, const Scale& scale)
{
  const Region street{ { 30.0, 120.0, 30.0, 120.0 } }, cone{ { 32.0, 122.0, 150.0, 240.0 } };
  return Album(studio, scale, "THESIS, figure 6.3: city, cones v1 and cones v2",
    { { "(a) city, 3 lamps, sky", "city", 3, true, From(200.0, 50.0), All },
      { "(b) detail of (a)", "city", 3, true, From(200.0, 60.0), street },
      { "(c) cones v1, 2 lamps", "cones v1", 2, false, From(200.0, 50.0), All },
      { "(d) cones v1, 3 lamps, sky", "cones v1", 3, true, From(200.0, 50.0), All },
      { "(e) cones v2, 1 lamp", "cones v2", 1, false, From(200.0, 50.0), All },
      { "(f) detail of (e)", "cones v2", 1, false, From(200.0, 50.0), cone } });
}

Figure TrayMountainGrating(Studio& studio, const Scale& scale)
{
  const Region crest{ { 80.0, 180.0, 60.0, 160.0 } };
  return Album(studio, scale, "THESIS, figure 6.4: eggtray, mountain and sine grating",
    { { "(a) eggtray, 1 lamp", "eggtray", 1, false, From(200.0, 50.0), All },
      { "(b) eggtray, 2 lamps", "eggtray", 2, false, From(200.0, 50.0), All },
      { "(c) mountain, sky", "mountain", 0, true, From(200.0, 50.0), All },
      { "(d) mountain, 3 lamps, sky", "mountain", 3, true, From(200.0, 50.0), All },
      { "(e) sine grating, 1 lamp, sky", "sine grating", 1, true, From(215.0, 45.0), All },
      { "(f) detail, 2 lamps", "sine grating", 2, false, From(215.0, 45.0), crest } });
}

Figure TeddyScenes(Studio& studio, const Scale& scale)
{
  const Region head{ { 70.0, 186.0, 130.0, 230.0 } };
  return Album(studio, scale, "THESIS, figure 6.5: teddy",
    { { "(a) teddy, 3 lamps", "teddy", 3, false, From(180.0, 60.0), All },
      { "(b) detail, 1 lamp", "teddy", 1, false, From(180.0, 60.0), head } });
}

} // namespace

std::vector<FigureMaker> LampFigures()
{
  return { { "thesis-6.1", Azimuths }, { "thesis-6.2", Steps }, { "thesis-6.3", CityAndCones },
    { "thesis-6.4", TrayMountainGrating }, { "thesis-6.5", TeddyScenes } };
}

} // namespace gallery
} // namespace skyline
