// SPDX-License-Identifier: BSD-3-Clause
#include "Jobs.h"

#include "DeviceRun.h"
#include "EmbreeLight.h"
#include "PeerSuns.h"
#include "SceneImage.h"
#include "SunScore.h"

#include "vtkDataArray.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldShadowHeight.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLHeightFieldDevice.h"
#include "vtkOpenGLHeightFieldShadowHeight.h"
#include "vtkPointData.h"
#include "vtkSkylineSunLight.h"

#include <cstdio>
#include <functional>
#include <string>

namespace skyline
{
namespace benchmark
{

namespace
{

using Kind = SunScore::Kind;

// Measures one of our filters for all suns. set(sun) sets its light, value(post) reads its output.
Result MeasureSuns(ReferenceScene& reference, Kind kind, vtkAlgorithm* filter,
  const std::function<void(const SunAt&)>& set, const SunOf& value)
{
  const auto image = ImageOf(reference.Scene.Field);
  filter->SetInputDataObject(0, image);
  SunScore score(reference, kind);
  Result sum;
  for (std::size_t sun = 0; sun < Suns.size(); ++sun)
  {
    set(Suns[sun]);
    const Result one = TimeUpdates(
      filter, image, reference.Work, static_cast<double>(reference.Scene.Field.Heights.size()));
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
    score.Add(sun, value);
  }
  score.Report(sum);
  return sum;
}

vtkDataArray* ArrayOf(vtkAlgorithm* filter, const char* name)
{
  return vtkImageData::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData()->GetArray(name);
}

Result MeasureShadow(ReferenceScene& reference, int method)
{
  vtkNew<vtkHeightFieldSunShadow> filter;
  filter->SetMethod(method);
  filter->SetSunAngularRadius(0.0);
  return MeasureSuns(
    reference, Kind::Lit, filter,
    [&](const SunAt& sun)
    {
      filter->SetSunAzimuth(sun.Azimuth);
      filter->SetSunElevation(sun.Elevation);
    },
    [&](std::size_t post)
    {
      const double seen =
        ArrayOf(filter, "SunVisibility")->GetComponent(static_cast<vtkIdType>(post), 0);
      return seen > 0.5 ? seen : 0.0;
    });
}

Result MeasureBeam(ReferenceScene& reference, int method)
{
  vtkNew<vtkHeightFieldIrradiance> filter;
  vtkNew<vtkSkylineSunLight> light;
  light->SetAngularRadius(0.0);
  filter->SetMethod(method);
  filter->AddLight(light);
  return MeasureSuns(
    reference, Kind::Beam, filter,
    [&](const SunAt& sun)
    {
      light->SetAzimuth(sun.Azimuth);
      light->SetElevation(sun.Elevation);
    },
    [&](std::size_t post)
    { return ArrayOf(filter, "Irradiance")->GetComponent(static_cast<vtkIdType>(post), 0); });
}

Result MeasureShadowHeight(
  ReferenceScene& reference, int method, vtkHeightFieldShadowHeight* filter)
{
  filter->SetMethod(method);
  filter->SetSunAngularRadius(0.0);
  return MeasureSuns(
    reference, Kind::Lit, filter,
    [&](const SunAt& sun)
    {
      filter->SetSunAzimuth(sun.Azimuth);
      filter->SetSunElevation(sun.Elevation);
    },
    [&](std::size_t post)
    {
      const auto at = static_cast<vtkIdType>(post);
      const double shadow = ArrayOf(filter, "ShadowHeight")->GetComponent(at, 0);
      return shadow <= ArrayOf(filter, "Elevation")->GetComponent(at, 0) ? 1.0 : 0.0;
    });
}

Result MeasureDeviceShadowHeight(ReferenceScene& reference)
{
  vtkNew<vtkOpenGLHeightFieldShadowHeight> filter;
  RequireDevice(filter->GetDevice());
  Result result = MeasureShadowHeight(reference, vtkHeightFieldAlgorithm::EXACT, filter);
  CheckOnDevice(filter->IsOnDevice());
  KeepWallOnly(result);
  std::snprintf(result.Reason, sizeof result.Reason, "%s",
    filter->GetDevice()->GetName().substr(0, 150).c_str());
  return result;
}

// Measures another program, which runs once for each sun.
Result MeasurePeer(
  ReferenceScene& reference, Kind kind, PeerSun (*make)(const oracle::OracleField& field))
{
  const oracle::OracleField& field = reference.Scene.Field;
  const PeerSun run = make(field);
  SunScore score(reference, kind);
  Cost cost;
  for (std::size_t sun = 0; sun < Suns.size(); ++sun)
  {
    const std::vector<float> found = run(Suns[sun], cost);
    score.Add(sun, [&](std::size_t post) { return static_cast<double>(found[post]); });
  }
  RepeatTimer timer;
  timer.Add({}, { cost.Cpu, cost.Wall });
  Result result;
  timer.Report(
    result, static_cast<double>(field.Heights.size()) * static_cast<double>(Suns.size()));
  score.Report(result);
  result.FloatsPerPost = FloatsPerPost(cost, field);
  return result;
}

// Returns a function that adds jobs of a quantity whose reference is the horizons towards the suns.
auto Adder(std::vector<Job>& jobs, const ReferenceScenePointer& reference, const char* quantity)
{
  return [&jobs, reference, quantity](const char* kind, const char* label, const char* settings,
           int turn, const std::function<Result()>& measure)
  {
    AddJob(
      jobs, reference, quantity, kind, label, settings, turn,
      [reference] { reference->SunHorizons(); }, measure);
  };
}

} // namespace

void AddSunJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference)
{
  const auto add = Adder(jobs, reference, "sun");
  for (const auto& search : Searches)
  {
    add(search.Name, search.Name, "a point sun, one azimuth", MainTurn,
      [reference, method = search.Method] { return MeasureShadow(*reference, method); });
  }
  const auto shadowHeight = [reference](int method)
  {
    vtkNew<vtkHeightFieldShadowHeight> filter;
    return MeasureShadowHeight(*reference, method, filter);
  };
  add("shadow-height", "shadow height", "exact", MainTurn,
    [shadowHeight] { return shadowHeight(vtkHeightFieldAlgorithm::EXACT); });
  add("gdaldem", "gdaldem hillshade", "slopes only, casts no shadow; with start and files",
    PeerTurn, [reference] { return MeasurePeer(*reference, Kind::Lit, GdalSun); });
  add("saga", "SAGA hillshade", "ta_lighting 0, with shadows, one thread; with start and files",
    PeerTurn, [reference] { return MeasurePeer(*reference, Kind::Lit, SagaSun); });
  add("grass", "GRASS r.sunmask", "-z; with start and files", LastTurn,
    [reference] { return MeasurePeer(*reference, Kind::Lit, GrassSunMask); });
  add("embree", "Embree", "one occlusion ray per post and sun", PeerTurn,
    [reference] { return MeasureEmbreeSun(*reference, Kind::Lit); });
  add("shadow-height", "shadow height, sweep", "Lee & Kim's recurrence as published", PeerTurn,
    [shadowHeight] { return shadowHeight(vtkHeightFieldAlgorithm::SWEEP); });
  add("gpu", "GPU shadow height", "exact, wall time", DeviceTurn,
    [reference] { return MeasureDeviceShadowHeight(*reference); });
}

void AddBeamJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference)
{
  const auto add = Adder(jobs, reference, "beam");
  for (const auto& search : Searches)
  {
    add(search.Name, search.Name, "a point sun of irradiance 1", MainTurn,
      [reference, method = search.Method] { return MeasureBeam(*reference, method); });
  }
  add("grass", "GRASS r.sun",
    "beam_rad, mode 1, linke_value=0 (no atmosphere), our slopes; with start and files", PeerTurn,
    [reference] { return MeasurePeer(*reference, Kind::Beam, GrassSun); });
  add("saga", "SAGA hillshade", "ta_lighting 0, with shadows, one thread; with start and files",
    PeerTurn, [reference] { return MeasurePeer(*reference, Kind::Beam, SagaSun); });
  add("gdaldem", "gdaldem hillshade",
    "ZevenbergenThorne, casts no shadow, 254 shades; with start and files", PeerTurn,
    [reference] { return MeasurePeer(*reference, Kind::Beam, GdalSun); });
  add("embree", "Embree", "one occlusion ray per post and sun, then the cosine", PeerTurn,
    [reference] { return MeasureEmbreeSun(*reference, Kind::Beam); });
}

} // namespace benchmark
} // namespace skyline
