// SPDX-License-Identifier: BSD-3-Clause
#include "EmbreeLight.h"

#include <stdexcept>

#ifdef SKYLINE_EMBREE
#include "EmbreeCaster.h"

#include "Reference/LampOracle.h"
#include "Reference/Shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>
#endif

namespace skyline
{
namespace benchmark
{

#ifndef SKYLINE_EMBREE

Result MeasureEmbreeSun(ReferenceScene&, SunScore::Kind)
{
  throw std::runtime_error("not built in");
}

Result MeasureEmbreeLamp(ReferenceScene&, int)
{
  throw std::runtime_error("not built in");
}

#else

namespace
{

oracle::Vector3 NormalOf(const oracle::OracleField& field, std::ptrdiff_t post)
{
  double east = 0.0, north = 0.0;
  oracle::Gradient(field, post % field.Columns, post / field.Columns, east, north);
  return oracle::Unit({ -east, -north, 1.0 });
}

// The irradiance of a post from a ball of unit radiance, from rays in cells of equal solid angle.
double BallLight(const EmbreeCaster& caster, const oracle::OracleField& field, std::ptrdiff_t post,
  const oracle::Vector3& normal, const LampAt& lamp, int side, shapes::Random& random)
{
  using namespace oracle;
  const Vector3 to =
    Vector3{ lamp.X, lamp.Y, lamp.Z } - PlaceOf(field, post % field.Columns, post / field.Columns);
  const double distance = std::sqrt(Dot(to, to));
  const Vector3 axis = (1.0 / distance) * to;
  const Vector3 right =
    Unit(Cross(std::abs(axis.X) < 0.5 ? Vector3{ 1.0, 0.0, 0.0 } : Vector3{ 0.0, 1.0, 0.0 }, axis));
  const Vector3 up = Cross(axis, right);
  const double sine = lamp.Radius / distance;
  const double depth = 1.0 - std::sqrt(1.0 - sine * sine); // 1 - cos(angular radius of the ball)
  double sum = 0.0;
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const double cosine = 1.0 - depth * (i + random()) / side;
      const double turn = 2.0 * Pi * (j + random()) / side;
      const double across = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
      const Vector3 ray =
        cosine * axis + across * std::cos(turn) * right + across * std::sin(turn) * up;
      const double facing = Dot(normal, ray);
      const double inside = sine * sine - across * across;
      const double end = distance * (cosine - std::sqrt(std::max(0.0, inside)));
      sum += facing > 0.0 && !caster.Stops(post, { ray.X, ray.Y, ray.Z }, end) ? facing : 0.0;
    }
  }
  return 2.0 * Pi * depth * sum / (static_cast<double>(side) * side);
}

} // namespace

Result MeasureEmbreeSun(ReferenceScene& reference, SunScore::Kind kind)
{
  const oracle::OracleField& field = reference.Scene.Field;
  const auto posts = static_cast<std::ptrdiff_t>(field.Heights.size());
  const PeakMemory memory;
  Result result;
  const double start = ProcessCpu();
  const EmbreeCaster caster(field);
  result.BuildSeconds = ProcessCpu() - start;
  std::vector<oracle::Vector3> rays;
  for (const SunAt& sun : Suns)
  {
    const oracle::Direction direction = oracle::DirectionOfAzimuth(sun.Azimuth);
    const double level = std::cos(sun.Elevation * RadiansPerDegree);
    rays.push_back({ level * direction.East, level * direction.North,
      std::sin(sun.Elevation * RadiansPerDegree) });
  }
  // As in our filters, the planes of the posts are computed only if the irradiance is wanted.
  std::vector<std::vector<float>> light(Suns.size(), std::vector<float>(field.Heights.size()));
  RepeatTimer timer;
  while (timer.Next(reference.Work.Repeats, reference.Work.Seconds))
  {
    timer.Search(
      [&]
      {
        for (std::size_t sun = 0; sun < rays.size(); ++sun)
        {
          for (std::ptrdiff_t post = 0; post < posts; ++post)
          {
            const oracle::Vector3& ray = rays[sun];
            const double facing =
              kind == SunScore::Kind::Lit ? 1.0 : oracle::Dot(NormalOf(field, post), ray);
            const bool lit = facing > 0.0 &&
              !caster.Stops(post, { ray.X, ray.Y, ray.Z }, std::numeric_limits<float>::max());
            light[sun][static_cast<std::size_t>(post)] = lit ? static_cast<float>(facing) : 0.0f;
          }
        }
      });
  }
  timer.Report(result, static_cast<double>(posts) * static_cast<double>(Suns.size()));
  result.FloatsPerPost = memory.FloatsPerPost(static_cast<double>(posts));
  SunScore score(reference, kind);
  for (std::size_t sun = 0; sun < Suns.size(); ++sun)
  {
    score.Add(sun, [&](std::size_t post) { return static_cast<double>(light[sun][post]); });
  }
  score.Report(result);
  return result;
}

Result MeasureEmbreeLamp(ReferenceScene& reference, int side)
{
  const oracle::OracleField& field = reference.Scene.Field;
  const ReferenceLight& truth = reference.LampLight();
  const LampAt lamp = reference.Lamp();
  const PeakMemory memory;
  Result result;
  const double start = ProcessCpu();
  const EmbreeCaster caster(field);
  result.BuildSeconds = ProcessCpu() - start;
  std::vector<double> light(truth.Posts.size());
  RepeatTimer timer;
  while (timer.Next(reference.Work.Repeats, reference.Work.Seconds))
  {
    timer.Search(
      [&]
      {
        shapes::Random random(11); // other rays than those of the reference
        for (std::size_t i = 0; i < truth.Posts.size(); ++i)
        {
          const std::ptrdiff_t post = truth.Posts[i];
          light[i] =
            3.0 * BallLight(caster, field, post, NormalOf(field, post), lamp, side, random);
        }
      });
  }
  timer.Report(result, static_cast<double>(truth.Posts.size()));
  result.FloatsPerPost = memory.FloatsPerPost(static_cast<double>(field.Heights.size()));
  result.PrepareNs = result.SearchNs = NotMeasured;
  ErrorSum errors;
  for (std::size_t i = 0; i < light.size(); ++i)
  {
    errors.Add(100.0 * light[i] / truth.Mean, 100.0 * truth.Light[i] / truth.Mean);
  }
  result.Error = errors.Get();
  result.Ran = true;
  return result;
}

#endif

} // namespace benchmark
} // namespace skyline
