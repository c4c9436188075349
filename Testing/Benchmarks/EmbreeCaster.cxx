// SPDX-License-Identifier: BSD-3-Clause
#include "EmbreeCaster.h"

#include "Measure.h"
#include "Shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#if defined(SKYLINE_EMBREE) && SKYLINE_EMBREE >= 4
#include <embree4/rtcore.h>
#elif defined(SKYLINE_EMBREE)
#include <embree3/rtcore.h>
#endif

namespace skyline
{
namespace benchmark
{

#ifndef SKYLINE_EMBREE

std::string EmbreeVersion()
{
  return "not built in";
}

Result MeasureEmbree(const Scene&, const Truth&, double, int)
{
  throw std::runtime_error("not built in");
}

#else

namespace
{

// The receiver above its post, in spacings: a ray that starts on the very post and dives under its
// own triangles would hit nothing. It lowers a horizon by 0.01 degrees at most.
constexpr double Raise = 1.0e-4;

// First step from the horizon of the azimuth before, at least: the quickest of 0.12 to 2.
constexpr double FirstStep = 0.25; // degrees

// No bracket leaves these elevations; below the lowest lies no terrain.
constexpr double Lowest = -89.9, Highest = 89.9;

class Caster
{
public:
  explicit Caster(const oracle::OracleField& field)
    : Field(field)
  {
    this->Device = rtcNewDevice("threads=1,set_affinity=0");
    this->Mesh = rtcNewScene(this->Device);
    rtcSetSceneFlags(this->Mesh, RTC_SCENE_FLAG_ROBUST); // no ray slips between two triangles
    RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    this->FillPosts(geometry);
    this->FillTriangles(geometry);
    rtcSetGeometryMask(geometry, 0xFFFFFFFFu);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->Mesh, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(this->Mesh);
    if (rtcGetDeviceError(this->Device) != RTC_ERROR_NONE)
    {
      throw std::runtime_error("Embree could not build the mesh");
    }
  }
  ~Caster()
  {
    rtcReleaseScene(this->Mesh);
    rtcReleaseDevice(this->Device);
  }
  Caster(const Caster&) = delete;
  Caster& operator=(const Caster&) = delete;

  /// Degrees; before: the horizon to start from.
  double Horizon(std::ptrdiff_t post, const oracle::Direction& direction, double before,
    double accuracy) const
  {
    RTCRay ray = this->RayFrom(post);
    const auto occluded = [&](double elevation) { return this->Occluded(ray, direction, elevation); };
    double step = std::max(FirstStep, 2.0 * accuracy);
    double free = std::clamp(before, Lowest, Highest);
    double blocked = free;
    if (occluded(free))
    {
      for (; free < Highest; step *= 2.0)
      {
        free = std::min(blocked + step, Highest);
        if (!occluded(free))
        {
          break;
        }
        blocked = free;
      }
    }
    else
    {
      for (; blocked > Lowest; step *= 2.0)
      {
        blocked = std::max(free - step, Lowest);
        if (occluded(blocked))
        {
          break;
        }
        free = blocked;
      }
      if (free <= Lowest)
      {
        return -90.0;
      }
    }
    while (free - blocked > 2.0 * accuracy)
    {
      const double middle = 0.5 * (free + blocked);
      (occluded(middle) ? blocked : free) = middle;
    }
    return 0.5 * (free + blocked);
  }

private:
  const oracle::OracleField& Field;
  RTCDevice Device;
  RTCScene Mesh;

  // Metres from the middle of the data, where floats are finest.
  std::array<float, 3> Place(std::ptrdiff_t post) const
  {
    const oracle::OracleField& field = this->Field;
    const double column = static_cast<double>(post % field.Columns - field.Columns / 2);
    const double row = static_cast<double>(post / field.Columns - field.Rows / 2);
    return { static_cast<float>(column * field.SpacingX), static_cast<float>(row * field.SpacingY),
      static_cast<float>(field.Heights[static_cast<std::size_t>(post)] - this->Base) };
  }

  void FillPosts(RTCGeometry geometry)
  {
    const oracle::OracleField& field = this->Field;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double height : field.Heights)
    {
      low = std::isfinite(height) ? std::min(low, height) : low;
      high = std::isfinite(height) ? std::max(high, height) : high;
    }
    this->Base = low + 0.5 * (high - low);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
      RTC_FORMAT_FLOAT3, 3 * sizeof(float), field.Heights.size()));
    for (std::size_t post = 0; post < field.Heights.size(); ++post)
    {
      const std::array<float, 3> place = this->Place(static_cast<std::ptrdiff_t>(post));
      for (std::size_t k = 0; k < 3; ++k)
      {
        vertices[3 * post + k] = std::isfinite(place[k]) ? place[k] : 0.0f; // in no triangle
      }
    }
  }

  // Both triangles of every complete cell, split from its south-west to its north-east post.
  void FillTriangles(RTCGeometry geometry)
  {
    const oracle::OracleField& field = this->Field;
    std::vector<unsigned> corners;
    for (std::ptrdiff_t row = 0; row + 1 < field.Rows; ++row)
    {
      for (std::ptrdiff_t column = 0; column + 1 < field.Columns; ++column)
      {
        if (field.HasCell(column, row))
        {
          const auto a = static_cast<unsigned>(field.Index(column, row));
          const auto b = a + 1;
          const auto c = static_cast<unsigned>(field.Index(column, row + 1));
          const auto d = c + 1;
          corners.insert(corners.end(), { a, b, d, a, d, c });
        }
      }
    }
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
      RTC_FORMAT_UINT3, 3 * sizeof(unsigned), corners.size() / 3));
    std::copy(corners.begin(), corners.end(), indices);
  }

  RTCRay RayFrom(std::ptrdiff_t post) const
  {
    const std::array<float, 3> place = this->Place(post);
    RTCRay ray{};
    ray.org_x = place[0];
    ray.org_y = place[1];
    ray.org_z =
      place[2] + static_cast<float>(Raise * std::min(this->Field.SpacingX, this->Field.SpacingY));
    ray.mask = 0xFFFFFFFFu;
    return ray;
  }

  bool Occluded(RTCRay ray, const oracle::Direction& direction, double elevation) const
  {
    const double level = std::cos(elevation * RadiansPerDegree);
    ray.dir_x = static_cast<float>(level * direction.East);
    ray.dir_y = static_cast<float>(level * direction.North);
    ray.dir_z = static_cast<float>(std::sin(elevation * RadiansPerDegree));
    ray.tfar = std::numeric_limits<float>::infinity();
#if SKYLINE_EMBREE >= 4
    rtcOccluded1(this->Mesh, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(this->Mesh, &context, &ray);
#endif
    return ray.tfar < 0.0f;
  }

  double Base = 0.0;
};

// Runs of adjacent posts that exist, at random places.
std::vector<std::ptrdiff_t> RunsOfPosts(const oracle::OracleField& field, std::size_t count)
{
  constexpr std::ptrdiff_t length = 64;
  shapes::Random random(7);
  std::vector<std::ptrdiff_t> posts;
  while (posts.size() < count)
  {
    const std::ptrdiff_t first = random.Below(field.Columns * field.Rows);
    const std::ptrdiff_t end = std::min((first / field.Columns + 1) * field.Columns, first + length);
    for (std::ptrdiff_t post = first; post < end; ++post)
    {
      if (std::isfinite(field.Heights[static_cast<std::size_t>(post)]))
      {
        posts.push_back(post);
      }
    }
  }
  return posts;
}

} // namespace

std::string EmbreeVersion()
{
  return RTC_VERSION_STRING;
}

Result MeasureEmbree(const Scene& scene, const Truth& truth, double accuracy, int repeats)
{
  const PeakMemory memory;
  const double start = ProcessCpu();
  const Caster caster(scene.Field);
  Result result;
  result.BuildSeconds = ProcessCpu() - start;
  const auto posts = static_cast<double>(scene.Field.Heights.size());
  result.FloatsPerPost = memory.FloatsPerPost(posts);

  std::vector<oracle::Direction> directions;
  for (const double azimuth : truth.Azimuths)
  {
    directions.push_back(oracle::DirectionOfAzimuth(azimuth));
  }
  const std::vector<std::ptrdiff_t> runs = RunsOfPosts(scene.Field, truth.Posts.size());
  Laps laps;
  volatile double last = 0.0; // keeps the results wanted
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    laps.NextRepeat();
    laps.Search([&] {
      for (const std::ptrdiff_t post : runs)
      {
        double horizon = 0.0;
        for (const oracle::Direction& direction : directions)
        {
          horizon = caster.Horizon(post, direction, horizon, accuracy);
        }
        last = horizon;
      }
    });
  }
  laps.Report(result, static_cast<double>(runs.size() * directions.size()));

  ErrorSum errors;
  for (std::size_t post = 0; post < truth.Posts.size(); ++post)
  {
    double horizon = 0.0;
    for (std::size_t azimuth = 0; azimuth < directions.size(); ++azimuth)
    {
      horizon = caster.Horizon(truth.Posts[post], directions[azimuth], horizon, accuracy);
      errors.Add(horizon, truth.Elevation(azimuth, post));
    }
  }
  result.Error = errors.Get();
  result.Ran = true;
  return result;
}

#endif

} // namespace benchmark
} // namespace skyline
