// SPDX-License-Identifier: BSD-3-Clause
#include "GrassHorizon.h"

#include "GrassLocation.h"
#include "Measure.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace skyline
{
namespace benchmark
{

std::string GrassVersion()
{
  const std::string line = FirstLine("grass --version 2>&1");
  const std::string name = "GRASS GIS ";
  return line.rfind(name, 0) == 0 ? line.substr(name.size()) : "not installed";
}

Result MeasureGrass(const Scene& scene, const ReferenceHorizons& truth, int azimuths)
{
  const std::string base = FirstLine("grass --config path 2>/dev/null");
  if (base.empty() || !std::filesystem::exists(base + "/bin/r.horizon"))
  {
    throw std::runtime_error("not installed");
  }
  const oracle::OracleField& field = scene.Field;
  const GrassLocation location(field, base);
  location.Import("heights", field.Heights);

  Cost sum;
  ErrorSum errors;
  for (int k = 0; k < azimuths; ++k)
  {
    // The azimuths are spread over the circle and, if there are enough, avoid the axes and
    // diagonals.
    const std::size_t count = truth.Azimuths.size();
    const std::size_t azimuth = (count * static_cast<std::size_t>(8 * k + 3)) /
      static_cast<std::size_t>(8 * azimuths) % count;
    // In GRASS, angles count anticlockwise from east.
    const double angle = std::fmod(450.0 - truth.Azimuths[azimuth], 360.0);
    sum += location.Run("r.horizon",
      { "-d", "elevation=heights", "direction=" + std::to_string(angle), "output=horizon" });

    const std::vector<float> found = location.Take("horizon");
    for (std::size_t i = 0; i < truth.Posts.size(); ++i)
    {
      const std::ptrdiff_t row = field.Rows - 1 - truth.Posts[i] / field.Columns;
      const std::ptrdiff_t post = row * field.Columns + truth.Posts[i] % field.Columns;
      const float value = found[static_cast<std::size_t>(post)];
      if (value != GrassLocation::Null)
      {
        errors.Add(value, truth.Elevation(azimuth, i));
      }
    }
  }
  Result result;
  RepeatTimer timer;
  timer.Add({}, { sum.Cpu, sum.Wall });
  timer.Report(result, static_cast<double>(field.Heights.size()) * azimuths);
  result.FloatsPerPost = FloatsPerPost(sum, field);
  result.PrepareNs = NotMeasured;
  result.SearchNs = NotMeasured;
  result.Error = errors.Get();
  std::snprintf(result.Reason, sizeof result.Reason, "%d azimuths, with start and files", azimuths);
  result.Ran = true;
  return result;
}

} // namespace benchmark
} // namespace skyline
