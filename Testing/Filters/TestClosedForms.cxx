// SPDX-License-Identifier: BSD-3-Clause
// All 129 closed-form results of Testing/Data/closed-form. A receiver is given by its horizon as a
// continuous function of azimuth and by its plane; the accumulators sum over 1440 azimuths. The
// remaining error is that of the midpoint rule. It is greatest where the horizon has a kink or
// falls within a quarter of a degree: see the bounds.
#include "Lamps/LampIrradiance.h"
#include "Reference/OracleTerrain.h"
#include "Sky/SkyAccumulator.h"
#include "Sun/SunDisc.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

constexpr int AzimuthCount = 1440;
constexpr double QuadratureBound = 2.0e-4; // of a factor between 0 and 1
constexpr double AngleBound = 1.0e-5;      // degrees: float elevations
constexpr double LampBound = 1.0e-6;       // of an irradiance below 1: float gradients and results

struct Row
{
  std::string Case, Parameters, Where, Quantity;
  double Value = 0.0;
};

// How ctest prints a row.
void PrintTo(const Row& row, std::ostream* out)
{
  *out << row.Case << ": " << row.Quantity;
}

std::vector<std::string> SplitCsv(const std::string& line)
{
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line)
  {
    if (c == '"')
    {
      quoted = !quoted;
    }
    else if (c == ',' && !quoted)
    {
      cells.emplace_back();
    }
    else
    {
      cells.back() += c;
    }
  }
  return cells;
}

std::vector<Row> ReadRows()
{
  std::ifstream file(SKYLINE_TEST_DATA "/closed-form/analytic_horizon_svf_shadow_cases.csv");
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);)
  {
    const std::vector<std::string> cells = SplitCsv(line);
    if (line[0] != '#' && cells[0] != "case")
    {
      rows.push_back({ cells[0], cells[1], cells[2], cells[3], std::stod(cells[5]) });
    }
  }
  return rows;
}

// The numbers in a text, in order of appearance.
std::vector<double> Numbers(const std::string& text)
{
  static const std::regex number("-?[0-9]+(\\.[0-9]+)?");
  std::vector<double> values;
  for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it)
  {
    values.push_back(std::stod(it->str()));
  }
  return values;
}

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// A receiver: the slope of its horizon in an azimuth (radians), and its gradient.
struct Receiver
{
  std::function<double(double)> Slope;
  double East = 0.0, North = 0.0;
};

/// A quantity of a receiver by SkyAccumulator.
double Sky(const Receiver& receiver, const std::string& quantity)
{
  float tilted = 0.0f;
  float level = 0.0f;
  float solid = 0.0f;
  SkyBuffers buffers;
  buffers.SkyViewFactor.Values = &tilted;
  buffers.SkyViewFactorHorizontal.Values = &level;
  buffers.VisibleSkyFraction.Values = &solid;
  const float east = static_cast<float>(receiver.East);
  const float north = static_cast<float>(receiver.North);
  SkyAccumulator sky(1, buffers, &east, &north);
  for (int k = 0; k < AzimuthCount; ++k)
  {
    const double azimuth = 2.0 * Pi * (k + 0.5) / AzimuthCount;
    const float slope = static_cast<float>(receiver.Slope(azimuth));
    sky.Begin(azimuth, 2.0 * Pi / AzimuthCount);
    sky.Add(0, 0, 1, &slope);
  }
  sky.Finish(0, 1);
  return Has(quantity, "tilted") ? tilted : Has(quantity, "horizontal") ? level : solid;
}

/// Two straight walls along y with the height `height`, `west` and `east` metres away. Infinite: no
/// wall.
Receiver Canyon(double height, double west, double east)
{
  return { [=](double azimuth)
    {
      const double across = std::sin(azimuth);
      return height * std::abs(across) / (across < 0.0 ? west : east);
    } };
}

/// A pit with the given radius and depth, `place` metres east of its axis.
Receiver Pit(double radius, double depth, double place)
{
  return { [=](double azimuth)
    {
      const double along = place * std::sin(azimuth);
      const double rim =
        -along + std::sqrt(std::max(0.0, radius * radius - place * place + along * along));
      return depth / rim;
    } };
}

Receiver Level(double elevationDegrees)
{
  return { [=](double) { return std::tan(elevationDegrees * RadiansPerDegree); } };
}

/// The distance from a straight edge at which the disc kernel finds the visible fraction `fraction`
/// of a sun straight across the edge: the half-lit line, or an end of the penumbra.
double EdgeDistance(double height, double elevation, double radius, double fraction)
{
  double low = 0.01;
  double high = 1000.0;
  for (int k = 0; k < 60; ++k)
  {
    const double middle = 0.5 * (low + high);
    const SunDisc sun{ 0.5 * Pi, elevation * RadiansPerDegree, radius * RadiansPerDegree };
    DiscSlice slice;
    const double half = HalfSwath(sun.Elevation, sun.Radius);
    slice.Set(sun, -half, half, 0.0);
    // For a distant sun the edge is level: it has the same elevation across the disc.
    const double above = std::atan2(height, middle) - sun.Elevation;
    const double lit = 1.0 - slice.Hidden(above, above) / slice.Whole();
    (lit < fraction ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The horizon in degrees of a post `eye` metres above a sphere, by the exact method with posts 1
/// km apart.
double Dip(double eye)
{
  oracle::OracleField field = shapes::Plane(3, 801, 1000.0, 0.0, 0.0);
  field.At(1, 0) = eye;
  field.CurvatureDrop = 0.5 / 6371000.0;
  const HeightField posts = FieldOf(field);
  HorizonSettings settings;
  settings.CurvatureDrop = field.CurvatureDrop;
  return Elevation(Slopes(*MakeHorizonMethod(posts, settings), GridOf(field), 0.0)[1]);
}

class ClosedForm : public ::testing::TestWithParam<Row>
{
};

TEST_P(ClosedForm, Holds)
{
  const Row& row = GetParam();
  const std::vector<double> p = Numbers(row.Parameters);
  const std::vector<double> q = Numbers(row.Quantity);
  const bool angle = Has(row.Quantity, "horizon elevation");

  if (row.Case == "infinite inclined plane")
  {
    const double slope = std::tan(p[0] * RadiansPerDegree);
    if (angle)
    {
      // A height field: the middle post of a plane of 41 x 41 posts, uphill to the east.
      const double azimuth = 90.0 - q[0];
      const oracle::OracleField field = shapes::Plane(41, 41, 10.0, slope, 0.0);
      const HeightField posts = FieldOf(field);
      const auto method = MakeHorizonMethod(posts, HorizonSettings());
      const float found = Slopes(*method, GridOf(field), azimuth)[20 * 41 + 20];
      EXPECT_NEAR(Elevation(found), row.Value, RoundingBound(field));
      return;
    }
    const Receiver plane{ [=](double azimuth) { return slope * std::sin(azimuth); }, slope, 0.0 };
    // Here "horizontal receiver" means the cosine of the plane itself in the integral of Dozier &
    // Frew.
    EXPECT_NEAR(Sky(plane, row.Quantity), row.Value, QuadratureBound);
  }
  else if (Has(row.Case, "V valley"))
  {
    const double slope = std::tan(p[0] * RadiansPerDegree);
    EXPECT_NEAR(
      Sky({ [=](double azimuth) { return slope * std::abs(std::sin(azimuth)); } }, row.Quantity),
      row.Value, QuadratureBound);
  }
  else if (Has(row.Case, "canyon"))
  {
    const double height = p[0];
    const double width = p[1];
    if (Has(row.Where, "mid-height"))
    {
      // A post of a height field cannot be vertical, but it can be steep without limit. Across the
      // street it sees the upper half of the wall; on the other side, its own wall hides
      // everything.
      const double steep = 1.0e5;
      const Receiver wall{ [=](double azimuth)
        {
          const double across = std::sin(azimuth);
          return across > 0.0 ? 0.5 * height * across / width : -steep * across;
        },
        -steep, 0.0 };
      EXPECT_NEAR(Sky(wall, "tilted"), row.Value, QuadratureBound);
      return;
    }
    const double west = Has(row.Where, "centre") ? 0.5 * width
      : Has(row.Where, "W/4")                    ? 0.25 * width
                                                 : 1.0e-6 * width;
    EXPECT_NEAR(Sky(Canyon(height, west, width - west), row.Quantity), row.Value, QuadratureBound);
  }
  else if (Has(row.Case, "straight wall"))
  {
    EXPECT_NEAR(Sky(Canyon(p[0], 1.0e30, p[1]), row.Quantity), row.Value, QuadratureBound);
  }
  else if (Has(row.Case, "cylindrical pit"))
  {
    const double place = Has(row.Where, "centre") ? 0.0 : Numbers(row.Where)[0] * p[0];
    const Receiver pit = Pit(p[0], p[1], place);
    if (angle)
    {
      EXPECT_NEAR(std::atan(pit.Slope(0.3)) * DegreesPerRadian, row.Value, AngleBound);
      return;
    }
    EXPECT_NEAR(Sky(pit, row.Quantity), row.Value, QuadratureBound);
  }
  else if (Has(row.Case, "spherical bowl"))
  {
    // From the bottom, the rim of a cap with the half-angle T stands at T / 2. Half-way up (t = T /
    // 2), the rim is a circle with the radius sin T around the axis, 'rise' above the receiver.
    const double cap = p[0] * RadiansPerDegree;
    if (row.Where == "bottom")
    {
      if (angle)
      {
        EXPECT_NEAR(std::atan((1.0 - std::cos(cap)) / std::sin(cap)) * DegreesPerRadian, row.Value,
          AngleBound);
        return;
      }
      EXPECT_NEAR(Sky(Level(0.5 * p[0]), row.Quantity), row.Value, QuadratureBound);
      return;
    }
    const double t = 0.5 * cap;
    Receiver side = Pit(std::sin(cap), std::cos(t) - std::cos(cap), std::sin(t));
    side.East = std::tan(t);
    EXPECT_NEAR(Sky(side, row.Quantity), row.Value, QuadratureBound);
  }
  else if (row.Case == "conical pit")
  {
    EXPECT_NEAR(Sky(Level(p[0]), row.Quantity), row.Value, QuadratureBound);
  }
  else if (Has(row.Case, "vertical edge"))
  {
    const double elevation = p[1];
    if (Has(row.Quantity, "shadow length"))
    {
      // A large disc is half covered where its centre is, except for the curvature of the sphere of
      // directions.
      EXPECT_NEAR(EdgeDistance(p[0], elevation, 0.01, 0.5), row.Value, 1.0e-4 * row.Value);
      return;
    }
    const double radius = p[2];
    const double width = EdgeDistance(p[0], elevation, radius, 1.0 - 1e-9) -
      EdgeDistance(p[0], elevation, radius, 1e-9);
    // The ends lie where the first and the last chord is cut. The outermost chords of the
    // quadrature end before the rim, by up to 1 % of the disc.
    EXPECT_NEAR(width, row.Value, 0.01 * row.Value);
  }
  else if (Has(row.Case, "solar disc"))
  {
    const double rho = 0.2666 * RadiansPerDegree;
    const SunDisc sun{ 0.0, 20.0 * RadiansPerDegree, rho };
    const double half = HalfSwath(sun.Elevation, sun.Radius);
    DiscSlice slice;
    slice.Set(sun, -half, half, 0.0);
    const double above = p[0] * rho;
    // Two differences: the chords of the disc by Gauss's rule, and a horizon that is level on the
    // sphere, not in the plane of the disc.
    EXPECT_NEAR(1.0 - slice.Hidden(above, above) / slice.Whole(), row.Value, 0.005);
  }
  else if (Has(row.Case, "sphere R="))
  {
    // The ground is a parabola instead of a circle and has posts 1 km apart: errors of 1e-4 of the
    // dip, and a quarter of the curvature drop of one post spacing (0.02 m), over the distance.
    EXPECT_NEAR(Dip(p[0]), row.Value, 1.0e-3 * -row.Value + 0.0002);
  }
  else if (Has(row.Case, "spherical light"))
  {
    // A post of a plane that is tilted by the angle between the normal and the lamp, 1 m from the
    // lamp. The whole lamp lies above the plane of the post.
    const double radius = p[0] * RadiansPerDegree;
    const double tilt = p[1] * RadiansPerDegree;
    const oracle::OracleField field = shapes::Plane(5, 5, 10.0, std::tan(tilt), 0.0);
    const HeightField posts = FieldOf(field);
    const std::vector<float> east(25, static_cast<float>(std::tan(tilt))), north(25, 0.0f);
    Lamp lamp;
    lamp.X = lamp.Y = 20.0;
    lamp.Z = field.At(2, 2) - BaseOf(field) + 1.0;
    lamp.Radius = std::sin(radius);
    std::vector<float> rgb(75, 0.0f);
    AddLampIrradiance(LampTerrain(posts), GridOf(field), east.data(), north.data(), lamp,
      LampSettings(), 0, 5, rgb.data());
    EXPECT_NEAR(rgb[3 * 12], row.Value, LampBound);
  }
  else
  {
    FAIL() << "no test for '" << row.Case << "'";
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, ClosedForm, ::testing::ValuesIn(ReadRows()));

TEST(ClosedForms, AreAllThere)
{
  EXPECT_EQ(ReadRows().size(), 129u);
}

} // namespace
} // namespace testing
} // namespace skyline
