// SPDX-License-Identifier: BSD-3-Clause
// Horizons from rays cast at a triangle mesh with Intel Embree, on one thread.
#ifndef skyline_EmbreeCaster_h
#define skyline_EmbreeCaster_h

#include "Reference/Oracle.h"

#if SKYLINE_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <array>
#include <cstddef>

namespace skyline
{
namespace benchmark
{

/// The mesh has both triangles of each complete cell, with the diagonals of Surface::Triangles.
class EmbreeCaster
{
public:
  /// Throws std::runtime_error if Embree fails. The field must outlive the caster.
  explicit EmbreeCaster(const oracle::OracleField& field);
  ~EmbreeCaster();
  EmbreeCaster(const EmbreeCaster&) = delete;
  EmbreeCaster& operator=(const EmbreeCaster&) = delete;

  /// The horizon in degrees, or -90 if no ray meets terrain. `before`: the elevation at which the
  /// search starts, the horizon of the previous azimuth. `accuracy`: the greatest error of the
  /// result in degrees, which is half of the last bracket.
  double Horizon(
    std::ptrdiff_t post, const oracle::Direction& direction, double before, double accuracy) const;

  /// True if terrain stops the ray from a post along a unit vector (east, north, up) within `end`
  /// metres.
  bool Stops(std::ptrdiff_t post, const std::array<double, 3>& direction, double end) const;

private:
  std::array<float, 3> Place(std::ptrdiff_t post) const;
  void FillPosts(RTCGeometry geometry) const;
  void FillTriangles(RTCGeometry geometry) const;
  RTCRay RayFrom(std::ptrdiff_t post) const;
  bool Occluded(RTCRay ray, const oracle::Direction& direction, double elevation) const;
  bool Occluded(RTCRay& ray) const;

  const oracle::OracleField& Field;
  double Base = 0.0; // metres, halfway between the lowest and the highest post
  RTCDevice Device;
  RTCScene Mesh;
};

} // namespace benchmark
} // namespace skyline

#endif
