// SPDX-License-Identifier: BSD-3-Clause
#include "Jobs.h"

#include "EmbreeLight.h"
#include "HeightField/Normals.h"
#include "Lamps/LampIrradiance.h"
#include "Reference/OracleTerrain.h"

#include <cstdio>
#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

namespace
{

Result MeasureLamp(ReferenceScene& reference, const LampSettings& settings)
{
  const oracle::OracleField& field = reference.Scene.Field;
  const Grid grid = testing::GridOf(field);
  const HeightField posts = testing::FieldOf(field);
  const auto count = field.Heights.size();
  std::vector<float> east(count), north(count), light;
  Gradients(
    grid, [&](std::ptrdiff_t column, std::ptrdiff_t row) { return field.At(column, row); }, 0,
    grid.Rows, east.data(), north.data());
  const LampAt at = reference.Lamp();
  Lamp lamp;
  lamp.X = at.X;
  lamp.Y = at.Y;
  lamp.Z = at.Z - testing::BaseOf(field);
  lamp.Radius = at.Radius;
  RepeatTimer timer;
  const PeakMemory memory;
  while (timer.Next(reference.Work.Repeats, reference.Work.Seconds))
  {
    light.assign(3 * count, 0.0f);
    timer.Search(
      [&]
      {
        const LampTerrain terrain(posts);
        AddLampIrradiance(
          terrain, grid, east.data(), north.data(), lamp, settings, 0, grid.Rows, light.data());
      });
  }
  Result result;
  result.FloatsPerPost = memory.FloatsPerPost(static_cast<double>(count));
  timer.Report(result, static_cast<double>(count));
  result.PrepareNs = result.SearchNs = NotMeasured;
  const ReferenceLight& truth = reference.LampLight();
  ErrorSum errors;
  for (std::size_t i = 0; i < truth.Posts.size(); ++i)
  {
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      sum += static_cast<double>(light[3 * static_cast<std::size_t>(truth.Posts[i]) + c]);
    }
    errors.Add(100.0 * sum / truth.Mean, 100.0 * truth.Light[i] / truth.Mean);
  }
  result.Error = errors.Get();
  result.Ran = true;
  return result;
}

} // namespace

void AddLampJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference)
{
  for (const int azimuths : { 32, 8, 2 })
  {
    LampSettings settings;
    settings.Azimuths = azimuths;
    char label[40];
    std::snprintf(label, sizeof label, "lamp, %d planes", azimuths);
    char words[80];
    std::snprintf(
      words, sizeof words, "tolerance %.3g of the unshadowed light", settings.Tolerance);
    AddJob(
      jobs, reference, "lamp", "lamp", label, words, azimuths == 32 ? MainTurn : SweepTurn,
      [reference] { reference->LampLight(); },
      [reference, settings] { return MeasureLamp(*reference, settings); });
  }
  LampSettings loose;
  loose.Azimuths = 8;
  loose.Tolerance = 0.05;
  AddJob(
    jobs, reference, "lamp", "lamp", "lamp, loose",
    "8 planes, tolerance 0.05 of the unshadowed light", SweepTurn,
    [reference] { reference->LampLight(); },
    [reference, loose] { return MeasureLamp(*reference, loose); });
  for (const int side : { 8, 32, 3 })
  {
    AddJob(
      jobs, reference, "lamp", "embree", "Embree " + std::to_string(side * side),
      std::to_string(side * side) + " rays per post into equal cells of the lamp",
      side == 8 ? PeerTurn : SweepTurn, [reference] { reference->LampLight(); },
      [reference, side] { return MeasureEmbreeLamp(*reference, side); });
  }
}

} // namespace benchmark
} // namespace skyline
