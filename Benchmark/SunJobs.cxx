// SPDX-License-Identifier: BSD-3-Clause
#include "Jobs.h"

#include "DeviceRun.h"
#include "External.h"
#include "GrassLocation.h"
#include "SceneImage.h"
#include "Similarity.h"

#include "vtkDataArray.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkShadowHeightMap.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>

namespace skyline
{
namespace benchmark
{

namespace
{

using Lit = std::function<bool(std::size_t post)>; // of the whole scene, row by row from the south

// Counts posts on the wrong side of shadows, and how alike the pictures are, sun by sun.
class SunScore
{
public:
  explicit SunScore(Stage& stage)
    : Field(stage.Scene.Field)
    , Right(stage.SunHorizons())
    , Side(stage.WindowSide())
  {
  }

  void Add(std::size_t sun, const Lit& lit)
  {
    std::vector<double> found, right;
    for (std::size_t i = 0; i < this->Right.Posts.size(); ++i)
    {
      const auto post = static_cast<std::size_t>(this->Right.Posts[i]);
      const double elevation = this->Right.Elevation(sun, i);
      if (!std::isfinite(elevation))
      {
        found.push_back(0.0);
        right.push_back(0.0);
        continue;
      }
      const bool isLit = elevation < Suns[sun].Elevation;
      const double light = this->Light(static_cast<std::ptrdiff_t>(post), Suns[sun]);
      right.push_back(isLit ? light : 0.0);
      found.push_back(lit(post) ? light : 0.0);
      this->Wrong += lit(post) == isLit ? 0.0 : 1.0;
      this->Posts += 1.0;
    }
    this->Similarities += StructuralSimilarity(found, right, this->Side);
  }

  void Report(Result& result) const
  {
    result.WrongPercent = 100.0 * this->Wrong / this->Posts;
    result.Similarity = this->Similarities / static_cast<double>(Suns.size());
    result.Error.Samples = this->Posts;
    result.PrepareNs = result.SearchNs = NotMeasured;
    result.Ran = true;
  }

private:
  // Of a white surface, 0 to 1; posts that turn away still show where shadows lie.
  double Light(std::ptrdiff_t post, const SunAt& sun) const
  {
    double east = 0.0, north = 0.0;
    oracle::Gradient(
      this->Field, post % this->Field.Columns, post / this->Field.Columns, east, north);
    const double azimuth = sun.Azimuth * RadiansPerDegree;
    const double elevation = sun.Elevation * RadiansPerDegree;
    const double cosine =
      (std::sin(elevation) -
        std::cos(elevation) * (east * std::sin(azimuth) + north * std::cos(azimuth))) /
      std::sqrt(1.0 + east * east + north * north);
    return 0.2 + 0.8 * std::max(0.0, cosine);
  }

  const oracle::OracleField& Field;
  const Truth& Right;
  std::ptrdiff_t Side;
  double Wrong = 0.0, Posts = 0.0, Similarities = 0.0;
};

// A filter of ours for all suns; lit(filter, post).
template <typename Filter>
Result MeasureFilter(
  Stage& stage, Filter* filter, const std::function<bool(Filter*, std::size_t)>& lit)
{
  const auto image = ImageOf(stage.Scene.Field);
  filter->SetInputData(image);
  filter->SetSunAngularRadius(0.0);
  SunScore score(stage);
  Result sum;
  for (std::size_t sun = 0; sun < Suns.size(); ++sun)
  {
    filter->SetSunAzimuth(Suns[sun].Azimuth);
    filter->SetSunElevation(Suns[sun].Elevation);
    const Result one =
      TimeUpdates(filter, image, stage.Work, static_cast<double>(stage.Scene.Field.Heights.size()));
    const auto add = [&](double Result::*member)
    {
      const double part = one.*member / static_cast<double>(Suns.size());
      sum.*member = sun == 0 ? part : sum.*member + part;
    };
    add(&Result::TotalNs);
    add(&Result::TotalMedianNs);
    add(&Result::WallNs);
    add(&Result::WallMedianNs);
    add(&Result::ColdNs);
    sum.Repeats = one.Repeats;
    sum.FloatsPerPost = sun == 0 ? one.FloatsPerPost : sum.FloatsPerPost;
    score.Add(sun, [&](std::size_t post) { return lit(filter, post); });
  }
  score.Report(sum);
  return sum;
}

Result MeasureShadow(Stage& stage, int method)
{
  vtkNew<vtkHeightFieldSunShadow> filter;
  filter->SetMethod(method);
  return MeasureFilter<vtkHeightFieldSunShadow>(stage, filter,
    [](vtkHeightFieldSunShadow* shadow, std::size_t post)
    {
      vtkDataArray* seen = shadow->GetOutput()->GetPointData()->GetArray("SunVisibility");
      return seen->GetComponent(static_cast<vtkIdType>(post), 0) > 0.5;
    });
}

Result MeasureShadowHeight(Stage& stage, int method)
{
  vtkNew<vtkShadowHeightMap> filter;
  filter->SetMethod(method);
  return MeasureFilter<vtkShadowHeightMap>(stage, filter,
    [](vtkShadowHeightMap* map, std::size_t post)
    {
      vtkPointData* data = map->GetOutput()->GetPointData();
      const auto at = static_cast<vtkIdType>(post);
      return data->GetArray("ShadowHeight")->GetComponent(at, 0) <=
        data->GetScalars("Elevation")->GetComponent(at, 0);
    });
}

// One run of another program for each sun; run(sun, cost) returns who is lit.
Result MeasurePeer(Stage& stage, const std::function<Lit(const SunAt&, Cost&)>& run)
{
  SunScore score(stage);
  Laps laps;
  Cost sum;
  for (std::size_t sun = 0; sun < Suns.size(); ++sun)
  {
    Cost cost;
    const Lit lit = run(Suns[sun], cost);
    sum.Cpu += cost.Cpu;
    sum.Wall += cost.Wall;
    score.Add(sun, lit);
  }
  laps.Add({}, { sum.Cpu, sum.Wall });
  Result result;
  laps.Report(result,
    static_cast<double>(stage.Scene.Field.Heights.size()) * static_cast<double>(Suns.size()));
  score.Report(result);
  return result;
}

Result MeasureSaga(Stage& stage)
{
  const oracle::OracleField& field = stage.Scene.Field;
  const ScratchFolder folder;
  WriteSagaGrid(field, folder.File("heights"));
  return MeasurePeer(stage,
    [&](const SunAt& sun, Cost& cost) -> Lit
    {
      cost = RunProgram({ "saga_cmd", "-c=1", "ta_lighting", "0",
        "-ELEVATION=" + folder.File("heights.sgrd"), "-SHADE=" + folder.File("shade.sgrd"),
        "-METHOD=2", "-AZIMUTH=" + std::to_string(sun.Azimuth),
        "-DECLINATION=" + std::to_string(sun.Elevation) });
      constexpr float dark = 0.4999f * static_cast<float>(Pi); // a right angle stands for shadow
      return [shade = ReadSagaGrid(field, folder.File("shade"))](std::size_t post)
      { return shade[post] < dark; };
    });
}

// Shades slopes and casts no shadow: what many maps show in its place.
Result MeasureHillshade(Stage& stage)
{
  const oracle::OracleField& field = stage.Scene.Field;
  const ScratchFolder folder;
  WriteSagaGrid(field, folder.File("heights"));
  return MeasurePeer(stage,
    [&](const SunAt& sun, Cost& cost) -> Lit
    {
      cost = RunProgram({ "gdaldem", "hillshade", folder.File("heights.sdat"),
        folder.File("shade.bil"), "-of", "EHdr", "-compute_edges", "-az",
        std::to_string(sun.Azimuth), "-alt", std::to_string(sun.Elevation) });
      std::vector<char> shade(field.Heights.size());
      std::ifstream file(folder.File("shade.bil"), std::ios::binary);
      if (!file.read(shade.data(), static_cast<std::streamsize>(shade.size())))
      {
        throw std::runtime_error("gdaldem wrote too little");
      }
      return [shade = std::move(shade), &field](std::size_t post)
      {
        const auto columns = static_cast<std::size_t>(field.Columns);
        const std::size_t row = static_cast<std::size_t>(field.Rows) - 1 - post / columns;
        return static_cast<unsigned char>(shade[row * columns + post % columns]) > 1;
      };
    });
}

Result MeasureGrassSun(Stage& stage, bool solar)
{
  const std::string base = FirstLine("grass --config path 2>/dev/null");
  if (base.empty())
  {
    throw std::runtime_error("not installed");
  }
  const oracle::OracleField& field = stage.Scene.Field;
  const GrassLocation location(field, base);
  location.Import("heights");
  return MeasurePeer(stage,
    [&](const SunAt& sun, Cost& cost) -> Lit
    {
      if (solar)
      {
        // The place is the equator: declination and hour angle that put the sun there.
        const double azimuth = sun.Azimuth * RadiansPerDegree;
        const double elevation = sun.Elevation * RadiansPerDegree;
        const double declination = std::asin(std::cos(elevation) * std::cos(azimuth));
        const double hour =
          std::atan2(-std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
        cost = location.Run("r.sun",
          { "elevation=heights", "incidout=shade", "day=80", "nprocs=1",
            "declination=" + std::to_string(declination),
            "time=" + std::to_string(12.0 + 12.0 * hour / Pi), "--overwrite" });
      }
      else
      {
        cost = location.Run("r.sunmask",
          { "-z", "elevation=heights", "output=shade", "altitude=" + std::to_string(sun.Elevation),
            "azimuth=" + std::to_string(sun.Azimuth), "--overwrite" });
      }
      return [shade = location.Take("shade"), &field, solar](std::size_t post)
      {
        const auto columns = static_cast<std::size_t>(field.Columns);
        const std::size_t row = static_cast<std::size_t>(field.Rows) - 1 - post / columns;
        const float value = shade[row * columns + post % columns];
        return solar ? value != GrassLocation::Null && value > 0.0f : value != 1.0f;
      };
    });
}

} // namespace

void AddSunJobs(std::vector<Job>& jobs, const StagePointer& stage)
{
  const auto add = [&](const char* kind, const char* label, const char* settings, int turn,
                     const std::function<Result()>& measure)
  {
    AddJob(
      jobs, stage, "sun", kind, label, settings, turn, [stage] { stage->SunHorizons(); }, measure);
  };
  const auto shadow = [&](const char* kind, int method)
  {
    add(kind, kind, "a point sun, its one azimuth", 1,
      [stage, method] { return MeasureShadow(*stage, method); });
  };
  shadow("exact", vtkHeightFieldAlgorithm::EXACT);
  shadow("fast", vtkHeightFieldAlgorithm::FAST);
  shadow("sweep", vtkHeightFieldAlgorithm::SWEEP);
  shadow("pyramid", vtkHeightFieldAlgorithm::PYRAMID);
  add("shadow-height", "shadow height", "exact", 1,
    [stage] { return MeasureShadowHeight(*stage, vtkHeightFieldAlgorithm::EXACT); });
  add("shadow-height", "shadow height, sweep", "Lee & Kim's recurrence as published", 1,
    [stage] { return MeasureShadowHeight(*stage, vtkHeightFieldAlgorithm::SWEEP); });
  add("gdaldem", "gdaldem hillshade", "slopes alone, casts no shadow; start and files included", 1,
    [stage] { return MeasureHillshade(*stage); });
  add("saga", "SAGA hillshade", "ta_lighting 0, with shadows, one thread; start and files included",
    1, [stage] { return MeasureSaga(*stage); });
  add("grass", "GRASS r.sunmask", "start and files included", 2,
    [stage] { return MeasureGrassSun(*stage, false); });
  add("grass", "GRASS r.sun", "mode 1, incidence angle; start and files included", 3,
    [stage] { return MeasureGrassSun(*stage, true); });
}

} // namespace benchmark
} // namespace skyline
