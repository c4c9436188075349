// SPDX-License-Identifier: BSD-3-Clause
#include "EmbreeCaster.h"

#include "Reference/OracleTerrain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace skyline
{
namespace benchmark
{

namespace
{

// Height of the start of a ray above its post, in spacings. A ray that starts exactly at the post
// and goes below the adjacent triangles would hit nothing. The raised start lowers a horizon by
// 0.01 degrees at most.
constexpr double Raise = 1.0e-4;

// The smallest first step from the horizon of the previous azimuth. Of the values from 0.12 to 2,
// this one was fastest.
constexpr double FirstStep = 0.25; // degrees

// The limits of the search, in degrees. No terrain lies below the lower one.
constexpr double Lowest = -89.9, Highest = 89.9;

constexpr unsigned EveryRay = 0xFFFFFFFFu;

} // namespace

EmbreeCaster::EmbreeCaster(const oracle::OracleField& field)
  : Field(field)
  , Base(testing::BaseOf(field))
  , Device(rtcNewDevice("threads=1,set_affinity=0"))
  , Mesh(rtcNewScene(this->Device))
{
  rtcSetSceneFlags(this->Mesh, RTC_SCENE_FLAG_ROBUST); // no ray passes between two triangles
  RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
  this->FillPosts(geometry);
  this->FillTriangles(geometry);
  rtcSetGeometryMask(geometry, EveryRay);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(this->Mesh, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(this->Mesh);
  if (rtcGetDeviceError(this->Device) != RTC_ERROR_NONE)
  {
    throw std::runtime_error("Embree could not build the mesh");
  }
}

EmbreeCaster::~EmbreeCaster()
{
  rtcReleaseScene(this->Mesh);
  rtcReleaseDevice(this->Device);
}

double EmbreeCaster::Horizon(
  std::ptrdiff_t post, const oracle::Direction& direction, double before, double accuracy) const
{
  const RTCRay ray = this->RayFrom(post);
  const auto occluded = [&](double elevation) { return this->Occluded(ray, direction, elevation); };
  double step = std::max(FirstStep, 2.0 * accuracy);
  double free = std::clamp(before, Lowest, Highest);
  double blocked = free;
  if (occluded(free))
  {
    while (free < Highest)
    {
      free = std::min(blocked + step, Highest);
      if (!occluded(free))
      {
        break;
      }
      blocked = free;
      step *= 2.0;
    }
  }
  else
  {
    while (blocked > Lowest)
    {
      blocked = std::max(free - step, Lowest);
      if (occluded(blocked))
      {
        break;
      }
      free = blocked;
      step *= 2.0;
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

// Coordinates in metres from the centre of the data, where floats have the finest steps.
std::array<float, 3> EmbreeCaster::Place(std::ptrdiff_t post) const
{
  const oracle::OracleField& field = this->Field;
  const std::ptrdiff_t east = post % field.Columns - field.Columns / 2;
  const std::ptrdiff_t north = post / field.Columns - field.Rows / 2;
  const auto column = static_cast<double>(east);
  const auto row = static_cast<double>(north);
  return { static_cast<float>(column * field.SpacingX), static_cast<float>(row * field.SpacingY),
    static_cast<float>(field.Heights[static_cast<std::size_t>(post)] - this->Base) };
}

void EmbreeCaster::FillPosts(RTCGeometry geometry) const
{
  const std::size_t count = this->Field.Heights.size();
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
    geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), count));
  for (std::size_t post = 0; post < count; ++post)
  {
    for (const float coordinate : this->Place(static_cast<std::ptrdiff_t>(post)))
    {
      *vertices++ = std::isfinite(coordinate) ? coordinate : 0.0f; // 0: used by no triangle
    }
  }
}

void EmbreeCaster::FillTriangles(RTCGeometry geometry) const
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
        const auto c = static_cast<unsigned>(field.Index(column, row + 1));
        corners.insert(corners.end(), { a, a + 1, c + 1, a, c + 1, c });
      }
    }
  }
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
    RTC_FORMAT_UINT3, 3 * sizeof(unsigned), corners.size() / 3));
  std::copy(corners.begin(), corners.end(), indices);
}

RTCRay EmbreeCaster::RayFrom(std::ptrdiff_t post) const
{
  const std::array<float, 3> place = this->Place(post);
  const double spacing = std::min(this->Field.SpacingX, this->Field.SpacingY);
  RTCRay ray{};
  ray.org_x = place[0];
  ray.org_y = place[1];
  ray.org_z = place[2] + static_cast<float>(Raise * spacing);
  ray.mask = EveryRay;
  return ray;
}

bool EmbreeCaster::Occluded(RTCRay ray, const oracle::Direction& direction, double elevation) const
{
  const double level = std::cos(elevation * RadiansPerDegree);
  ray.dir_x = static_cast<float>(level * direction.East);
  ray.dir_y = static_cast<float>(level * direction.North);
  ray.dir_z = static_cast<float>(std::sin(elevation * RadiansPerDegree));
  ray.tfar = std::numeric_limits<float>::infinity();
  return this->Occluded(ray);
}

bool EmbreeCaster::Stops(
  std::ptrdiff_t post, const std::array<double, 3>& direction, double end) const
{
  RTCRay ray = this->RayFrom(post);
  ray.dir_x = static_cast<float>(direction[0]);
  ray.dir_y = static_cast<float>(direction[1]);
  ray.dir_z = static_cast<float>(direction[2]);
  ray.tfar = static_cast<float>(end);
  return this->Occluded(ray);
}

bool EmbreeCaster::Occluded(RTCRay& ray) const
{
#if SKYLINE_EMBREE >= 4
  rtcOccluded1(this->Mesh, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(this->Mesh, &context, &ray);
#endif
  return ray.tfar < 0.0f;
}

} // namespace benchmark
} // namespace skyline
