// SPDX-License-Identifier: BSD-3-Clause
// Random fields, azimuths and lights, for which certain properties must hold. A failure prints the
// smallest field that rapidcheck finds, and the seed that repeats it (RC_PARAMS).
#include "FloatGuard.h"
#include "HeightField/Normals.h"
#include "HorizonBounds.h"
#include "Reference/VisibilityWedge.h"
#include "Sky/SkyAccumulator.h"
#include "Sun/SunAccumulator.h"
#include "Sun/SunDisc.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

using oracle::OracleField;

// The fields are the same in each run, so that a change cannot fail by chance. The nightly build
// tries other ones each time. The environment variable RC_PARAMS takes precedence.
#ifdef SKYLINE_NIGHTLY
constexpr const char* Parameters = "max_success=5000";
#else
constexpr const char* Parameters = "seed=20260621 max_success=300";
#endif
const int ParametersAreSet = setenv("RC_PARAMS", Parameters, 0);

/// A number whose decimal exponent is uniformly distributed in [from, to].
rc::Gen<double> Magnitude(int from, int to)
{
  return rc::gen::map(rc::gen::inRange(1000 * from, 1000 * to),
    [](int thousandths) { return std::pow(10.0, thousandths / 1000.0); });
}

/// Azimuths of more than one turn. Half of them are multiples of 45 degrees or slightly beside one
/// (by more than the oracle's PostSnap).
rc::Gen<double> AnyAzimuth()
{
  return rc::gen::oneOf(rc::gen::map(rc::gen::inRange(-16, 16), [](int k) { return 45.0 * k; }),
    rc::gen::map(rc::gen::inRange(-16, 16), [](int k) { return 45.0 * k + 1.0e-3; }),
    rc::gen::map(rc::gen::inRange(0, 36000), [](int k) { return k * 1.0e-2; }),
    rc::gen::map(rc::gen::inRange(0, 36000), [](int k) { return k * 1.0e-2; }));
}

/// Fields with 2 to 39 posts per side, any spacing, and a relief of 1e-6 to 1e6 spacings. Heights
/// have few different values, so that walls and terraces are common. One of three has holes.
OracleField AnyField()
{
  const auto columns = *rc::gen::inRange<std::ptrdiff_t>(2, 40);
  const auto rows = *rc::gen::inRange<std::ptrdiff_t>(2, 40);
  const double spacing = *Magnitude(-6, 6);
  const double aspect = *rc::gen::element(1.0, 1.0, 1.0, 3.3, 7.0, 1000.0);
  const bool wide = *rc::gen::arbitrary<bool>();
  const double relief = spacing * *Magnitude(-4, 4);
  const int levels = *rc::gen::element(2, 4, 1000);
  const bool holes = *rc::gen::inRange(0, 3) == 0;
  const bool rough = *rc::gen::arbitrary<bool>();
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  OracleField field = shapes::Fractal(columns, rows, spacing, 1.0, seed, 0.55);
  (wide ? field.SpacingX : field.SpacingY) *= aspect;
  shapes::Random random(seed);
  for (double& height : field.Heights)
  {
    const double share = rough ? random() : height;
    height = relief * std::floor(share * levels) / levels;
    height = holes && random() < 0.15 ? std::nan("") : height;
  }
  field.At(0, 0) = std::isfinite(field.At(0, 0)) ? field.At(0, 0) : 0.0; // at least one post exists
  field.At(0, 0) += *rc::gen::element(0.0, 0.0, 1.0e4) * spacing;        // sometimes a spike
  return field;
}

std::vector<float> FindSlopes(
  const OracleField& field, double azimuth, const HorizonSettings& asked = HorizonSettings())
{
  HorizonSettings settings = asked;
  settings.CurvatureDrop = field.CurvatureDrop;
  settings.Shape = field.Through;
  const HeightField posts = FieldOf(field);
  return Slopes(*MakeHorizonMethod(posts, settings), GridOf(field), azimuth);
}

/// Checks that `a` equals `b` at the mapped posts, up to twice the rounding.
void ExpectAlike(const OracleField& field, const std::vector<float>& a, const std::vector<float>& b,
  const std::function<std::size_t(std::ptrdiff_t, std::ptrdiff_t)>& there)
{
  for (std::ptrdiff_t j = 0; j < field.Rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < field.Columns; ++i)
    {
      if (field.HasPost(i, j))
      {
        const float one = a[field.Index(i, j)], other = b[there(i, j)];
        RC_ASSERT(
          std::abs(Elevation(one) - Elevation(other)) <= 2.0 * ElevationRounding(field, one));
      }
    }
  }
}

RC_GTEST_PROP(HorizonProperty, EveryMethodKeepsItsPromise, ())
{
  OracleField field = AnyField();
  double azimuth = *AnyAzimuth();
  // Rays that pass exactly through posts, but not on each line, touch some cells at only one
  // corner, where rounding decides what counts. Along the axes and the diagonals of squares there
  // is no rounding.
  const bool diagonal = std::abs(std::remainder(azimuth, 90.0)) == 45.0;
  azimuth += diagonal && field.SpacingX != field.SpacingY ? 0.0137 : 0.0;
  const double drop = *rc::gen::element(0.0, 0.0, 1.0e-7, 1.0e-3);
  field.CurvatureDrop = drop / std::max(field.SpacingX, field.SpacingY);
  const bool bilinear = *rc::gen::inRange(0, 4) == 0;
  field.Through = bilinear ? Surface::Bilinear : Surface::Triangles;
  const std::vector<double> truth = oracle::HorizonSlopes(field, azimuth);
  for (const TestedMethod& tested : TestedMethods())
  {
    if (bilinear && tested.Tolerance < 0.0)
    {
      continue; // only for triangles
    }
    HorizonSettings settings;
    settings.Method = tested.Kind;
    settings.Tolerance = tested.Kind == HorizonMethodKind::Exact ? tested.Tolerance : 0.0;
    const FloatGuard guard;
    const std::vector<float> found = FindSlopes(field, azimuth, settings);
    RC_ASSERT(tested.Name + (": " + guard.Raised()) == std::string(tested.Name) + ": ");
    RC_ASSERT(FirstComplaint(field, tested, found, truth) == "");
  }
}

RC_GTEST_PROP(HorizonProperty, ShiftsAndScalesChangeNothing, ())
{
  const OracleField field = AnyField();
  const double azimuth = *AnyAzimuth();
  const std::vector<float> slopes = FindSlopes(field, azimuth);
  const auto here = [&](std::ptrdiff_t i, std::ptrdiff_t j) { return field.Index(i, j); };
  OracleField changed = field;
  // A shift by half of the relief, which heights in doubles represent as exactly as floats need.
  const double shift = *rc::gen::element(-7.0, 0.5, 100.0) * ReliefOf(field);
  const double scale = *rc::gen::element(1.0e-3, 0.5, 3.0, 1.0e3);
  for (double& height : changed.Heights)
  {
    height = scale * (height + shift);
  }
  changed.SpacingX *= scale;
  changed.SpacingY *= scale;
  ExpectAlike(field, slopes, FindSlopes(changed, azimuth), here);
  // A full turn more gives the same direction.
  ExpectAlike(field, slopes, FindSlopes(field, azimuth + 360.0), here);
}

RC_GTEST_PROP(HorizonProperty, TransposedAxesAndMirrorsTurnTheAzimuth, ())
{
  OracleField field = AnyField();
  const double azimuth = *AnyAzimuth();
  OracleField swapped(field.Rows, field.Columns, field.SpacingY, field.SpacingX);
  OracleField mirrored = field; // along a vertical and a horizontal line, which keeps the diagonals
  for (std::ptrdiff_t j = 0; j < field.Rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < field.Columns; ++i)
    {
      swapped.At(j, i) = field.At(i, j);
      mirrored.At(field.Columns - 1 - i, field.Rows - 1 - j) = field.At(i, j);
    }
  }
  const std::vector<float> slopes = FindSlopes(field, azimuth);
  ExpectAlike(field, slopes, FindSlopes(swapped, 90.0 - azimuth),
    [&](std::ptrdiff_t i, std::ptrdiff_t j) { return swapped.Index(j, i); });
  ExpectAlike(field, slopes, FindSlopes(mirrored, azimuth + 180.0),
    [&](std::ptrdiff_t i, std::ptrdiff_t j)
    { return field.Index(field.Columns - 1 - i, field.Rows - 1 - j); });
}

// More terrain can raise horizons, but not lower them.
RC_GTEST_PROP(HorizonProperty, HigherTerrainHidesNoLess, ())
{
  const OracleField field = AnyField();
  const double azimuth = *AnyAzimuth();
  OracleField raised = field;
  const auto column = *rc::gen::inRange<std::ptrdiff_t>(0, field.Columns);
  const auto row = *rc::gen::inRange<std::ptrdiff_t>(0, field.Rows);
  raised.At(column, row) += (ReliefOf(field) + field.SpacingX) * *Magnitude(-2, 2);
  const std::vector<float> before = FindSlopes(field, azimuth), after = FindSlopes(raised, azimuth);
  for (std::size_t post = 0; post < before.size(); ++post)
  {
    if (std::isfinite(field.Heights[post]) && post != field.Index(column, row))
    {
      RC_ASSERT(Elevation(after[post]) >=
        Elevation(before[post]) - 2.0 * ElevationRounding(raised, before[post]));
    }
  }
}

/// Slopes of horizons from -90 to +90 degrees, including both ends.
rc::Gen<float> AnySlope()
{
  return rc::gen::oneOf(rc::gen::element(NoTerrainSlope, 0.0f, -0.0f, 1.0e12f, -1.0e12f, 1.0e-30f),
    rc::gen::map(rc::gen::inRange(-89999, 90000),
      [](int k) { return static_cast<float>(std::tan(k * 1.0e-3 * RadiansPerDegree)); }));
}

RC_GTEST_PROP(SkyProperty, LiesBetweenNothingAndAll, ())
{
  const auto count = *rc::gen::inRange(1, 40);
  float values[5] = {};
  SkyBuffers buffers;
  buffers.SkyViewFactor.Values = &values[0];
  buffers.SkyViewFactorHorizontal.Values = &values[1];
  buffers.VisibleSkyFraction.Values = &values[2];
  buffers.PositiveOpenness.Values = &values[3];
  buffers.UniformAmbient.Values = &values[4];
  const float steep = static_cast<float>(*Magnitude(-6, 6));
  const float east = *rc::gen::element(0.0f, -1.0f, 1.0f) * steep;
  const float north = *rc::gen::element(0.0f, -1.0f, 1.0f) * steep;
  const FloatGuard guard;
  SkyAccumulator sky(1, buffers, &east, &north);
  for (int k = 0; k < count; ++k)
  {
    const float slope = *AnySlope();
    sky.Begin(2.0 * Pi * k / count, 2.0 * Pi / count);
    sky.Add(0, 0, 1, &slope);
  }
  sky.Finish(0, 1);
  RC_ASSERT(guard.Raised() == "");
  constexpr float sums = 1.0e-5f; // of 39 floats
  RC_ASSERT(values[1] >= -sums && values[1] <= 1.0f + sums);
  RC_ASSERT(values[2] >= -sums && values[2] <= 1.0f + sums);
  RC_ASSERT(values[3] >= -1.0e-3f && values[3] <= 180.001f);
  // A tilted plane can get more than half of the sky from a single azimuth that represents all of
  // them.
  RC_ASSERT(values[0] >= -sums && (count < 8 || values[0] <= 1.06f));
  RC_ASSERT(std::isfinite(values[4]));
}

float LitBy(const SunDisc& sun, const std::vector<float>& slopes)
{
  float lit = 0.0f;
  PostBuffer buffer;
  buffer.Values = &lit;
  SunAccumulator accumulator(1, 1, sun, buffer);
  const std::vector<double> azimuths =
    SunAzimuths(sun.Azimuth, sun.Azimuth, sun.Elevation, sun.Elevation, sun.Radius);
  for (std::size_t k = 0; k < azimuths.size(); ++k)
  {
    accumulator.Begin(azimuths[k], 0.0);
    accumulator.Add(0, 0, 1, &slopes[k % slopes.size()]);
  }
  accumulator.Finish(0, 1);
  return lit;
}

RC_GTEST_PROP(SunProperty, LiesBetweenDarkAndLitAndFallsWithTheHorizon, ())
{
  SunDisc sun;
  sun.Azimuth = *AnyAzimuth() * RadiansPerDegree;
  sun.Elevation = *rc::gen::element(-90, -1, 0, 1, 30, 89, 90) * RadiansPerDegree;
  sun.Radius = *rc::gen::element(0.0, 1.0e-9, 0.26645, 5.0, 60.0) * RadiansPerDegree;
  std::vector<float> slopes(25);
  for (float& slope : slopes)
  {
    slope = *AnySlope();
  }
  std::vector<float> higher = slopes;
  higher[static_cast<std::size_t>(*rc::gen::inRange(0, 25))] +=
    static_cast<float>(*Magnitude(-4, 3));
  const FloatGuard guard;
  const float lit = LitBy(sun, slopes), less = LitBy(sun, higher);
  RC_ASSERT(guard.Raised() == "");
  RC_ASSERT(lit >= 0.0f && lit <= 1.0f);
  constexpr float sums = 2.0e-6f; // of the light of two dozen slices
  RC_ASSERT(less >= 0.0f && less <= lit + sums);
  if (sun.Elevation + sun.Radius <= 0.0)
  {
    RC_ASSERT(lit == 0.0f);
  }
}

RC_GTEST_PROP(WedgeProperty, HoldsNoMoreThanItsFunction, ())
{
  const int bands = *rc::gen::inRange(1, 9);
  const double azimuth = *AnyAzimuth() * RadiansPerDegree;
  const double width = *rc::gen::element(0.05, 1.0, 45.0, 180.0, 360.0) * RadiansPerDegree;
  const double horizon = *rc::gen::inRange(-90, 91) * RadiansPerDegree;
  std::vector<double> wedge(static_cast<std::size_t>(bands * bands));
  const FloatGuard guard;
  StepWedge(bands, azimuth, width, horizon, wedge.data());
  RC_ASSERT(guard.Raised() == "");
  double energy = 0.0;
  for (const double coefficient : wedge)
  {
    energy += coefficient * coefficient;
  }
  // Bessel's inequality: at most the solid angle above the horizon in the swath.
  RC_ASSERT(energy <= width * (1.0 - std::sin(horizon)) * (1.0 + 1e-9) + 1e-12);
}

} // namespace
} // namespace testing
} // namespace skyline
