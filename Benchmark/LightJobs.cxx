// SPDX-License-Identifier: BSD-3-Clause
#include "Jobs.h"

#include "ClearSky.h"
#include "DeviceRun.h"
#include "External.h"
#include "PeerSuns.h"
#include "SceneImage.h"
#include "Sky/LightTable.h"

#include "vtkFloatArray.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldSkyView.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLHeightFieldDevice.h"
#include "vtkOpenGLHeightFieldIrradiance.h"
#include "vtkPointData.h"

#include <cstdio>
#include <string>
#include <thread>

namespace skyline
{
namespace benchmark
{

namespace
{

vtkFloatArray* ArrayOf(vtkAlgorithm* filter, const char* name)
{
  auto* image = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  return vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(name));
}

vtkSmartPointer<vtkHeightFieldSkyView> MakeSkyView(int method, int azimuths)
{
  vtkNew<vtkHeightFieldSkyView> filter;
  filter->SetMethod(method);
  filter->SetNumberOfAzimuths(azimuths);
  filter->SkyViewFactorHorizontalOff();
  filter->VisibleSkyFractionOff();
  filter->PositiveOpennessOff();
  return filter;
}

Result MeasureSky(ReferenceScene& reference, int method, int azimuths)
{
  const auto filter = MakeSkyView(method, azimuths);
  const auto image = ImageOf(reference.Scene.Field);
  filter->SetInputData(image);
  Result result = TimeUpdates(
    filter, image, reference.Work, static_cast<double>(reference.Scene.Field.Heights.size()));
  const ReferenceHorizons& truth = reference.SkyHorizons();
  ErrorSum errors;
  for (std::size_t i = 0; i < truth.Posts.size(); ++i)
  {
    errors.Add(static_cast<double>(ArrayOf(filter, "SkyViewFactor")->GetValue(truth.Posts[i])),
      reference.SkyView()[i]);
  }
  result.Error = errors.Get();
  return result;
}

// Errors and cost of the sky view factors of another program.
Result OfProgram(ReferenceScene& reference, const Cost& cost, const std::vector<float>& found)
{
  ErrorSum errors;
  const ReferenceHorizons& truth = reference.SkyHorizons();
  for (std::size_t i = 0; i < truth.Posts.size(); ++i)
  {
    errors.Add(
      static_cast<double>(found[static_cast<std::size_t>(truth.Posts[i])]), reference.SkyView()[i]);
  }
  Result result;
  RepeatTimer timer;
  timer.Add({}, { cost.Cpu, cost.Wall });
  timer.Report(result, static_cast<double>(reference.Scene.Field.Heights.size()));
  result.FloatsPerPost = FloatsPerPost(cost, reference.Scene.Field);
  result.PrepareNs = result.SearchNs = NotMeasured;
  result.Error = errors.Get();
  result.Ran = true;
  return result;
}

// Sky view factors of SAGA, with rays from cell to cell in a number of sectors.
Result MeasureSagaSky(ReferenceScene& reference, int sectors)
{
  const oracle::OracleField& field = reference.Scene.Field;
  const ScratchFolder folder;
  WriteSagaGrid(field, folder.File("heights"));
  const Cost cost = RunProgram({ "saga_cmd", "-c=1", "ta_lighting", "3",
    "-DEM=" + folder.File("heights.sgrd"), "-VISIBLE=" + folder.File("visible.sgrd"),
    "-SVF=" + folder.File("sky.sgrd"), "-RADIUS=1e9", "-NDIRS=" + std::to_string(sectors) });
  return OfProgram(reference, cost, ReadSagaGrid(field, folder.File("sky")));
}

// The diffuse light of r.sun, which ignores the shadow of terrain: a sky view factor without
// horizons.
Result MeasureGrassDiffuse(ReferenceScene& reference)
{
  const oracle::OracleField& field = reference.Scene.Field;
  Cost cost;
  const std::vector<float> found = GrassDiffuse(field, cost);
  return OfProgram(reference, cost, found);
}

// The errors of red, green and blue together, in per cent of the mean.
Errors LightErrors(vtkFloatArray* found, const ReferenceLight& truth)
{
  ErrorSum errors;
  for (std::size_t i = 0; i < truth.Posts.size(); ++i)
  {
    double sum = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      sum += static_cast<double>(found->GetTypedComponent(truth.Posts[i], c));
    }
    errors.Add(100.0 * sum / truth.Mean, 100.0 * truth.Light[i] / truth.Mean);
  }
  return errors.Get();
}

struct LightSettings
{
  bool Harmonics = false;
  int Count = 128; // number of azimuths
  int Bands = 4;
  int Method = vtkHeightFieldAlgorithm::EXACT;
  bool Keep = false; // keep the horizons
};

void Apply(const LightSettings& how, vtkHeightFieldIrradiance* filter)
{
  filter->SetLightMethod(
    how.Harmonics ? vtkHeightFieldIrradiance::HARMONICS : vtkHeightFieldIrradiance::TABLE);
  filter->SetNumberOfAzimuths(how.Count);
  filter->SetHarmonicBands(how.Bands);
  filter->SetMethod(how.Method);
  filter->SetKeepHorizons(how.Keep);
}

// The time for a new light, with everything else unchanged.
double RelightNs(
  vtkHeightFieldIrradiance* filter, vtkSkylineEnvironmentLight* sky, const Effort& effort)
{
  RepeatTimer timer;
  int repeat = 0;
  while (timer.Next(effort.Repeats, effort.Seconds))
  {
    sky->SetSunAzimuth(140.0 + 10.0 * repeat++);
    sky->GetLightMap(); // the light, not the filter, computes the sky map
    timer.Search([&] { filter->Update(); });
  }
  Result result;
  timer.Report(result, static_cast<double>(filter->GetOutput()->GetNumberOfPoints()));
  return result.TotalMedianNs;
}

Result MeasureIrradiance(
  ReferenceScene& reference, vtkHeightFieldIrradiance* filter, const LightSettings& how)
{
  const auto image = ImageOf(reference.Scene.Field);
  const auto sky = MakeClearSky();
  Apply(how, filter);
  filter->SetInputData(image);
  filter->AddLight(sky);
  sky->GetLightMap();
  Result result = TimeUpdates(
    filter, image, reference.Work, static_cast<double>(reference.Scene.Field.Heights.size()));
  result.Error = LightErrors(ArrayOf(filter, "Irradiance"), reference.ClearSky());
  result.RelightNs = RelightNs(filter, sky, reference.Work);
  return result;
}

Result MeasureDeviceIrradiance(ReferenceScene& reference, const LightSettings& how)
{
  vtkNew<vtkOpenGLHeightFieldIrradiance> filter;
  RequireDevice(filter->GetDevice());
  Result result = MeasureIrradiance(reference, filter, how);
  CheckOnDevice(filter->IsOnDevice());
  KeepWallOnly(result);
  result.RelightNs = NotMeasured;
  std::snprintf(result.Reason, sizeof result.Reason, "%s",
    filter->GetDevice()->GetName().substr(0, 150).c_str());
  return result;
}

// The cost of a frame of moving terrain: a new surface, new horizons, new light.
Result MeasureFrames(ReferenceScene& reference, const LightSettings& how)
{
  vtkNew<vtkHeightFieldIrradiance> filter;
  return MeasureIrradiance(reference, filter, how);
}

} // namespace

void AddSkyJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference)
{
  const auto add = [&](const char* kind, const std::string& label, const std::string& settings,
                     int turn, const std::function<Result()>& measure)
  {
    AddJob(
      jobs, reference, "sky", kind, label, settings, turn, [reference] { reference->SkyView(); },
      measure);
  };
  for (const int azimuths : { 36, 16, 72, 8, 180 })
  {
    for (const auto& search : Searches)
    {
      const int method = search.Method;
      const bool ours =
        method == vtkHeightFieldAlgorithm::EXACT || method == vtkHeightFieldAlgorithm::FAST;
      if (ours || azimuths == 16 || azimuths == 36)
      {
        add(search.Name, std::string(search.Name) + " " + std::to_string(azimuths),
          std::to_string(azimuths) + " azimuths",
          azimuths == 36     ? MainTurn
            : azimuths == 16 ? PeerTurn
                             : SweepTurn,
          [reference, method, azimuths] { return MeasureSky(*reference, method, azimuths); });
      }
    }
  }
  for (const int sectors : { 8, 36 })
  {
    add("saga", "SAGA " + std::to_string(sectors),
      "ta_lighting 3, whole radius, cell by cell, one thread, with start and files",
      sectors == 8 ? PeerTurn : SweepTurn,
      [reference, sectors] { return MeasureSagaSky(*reference, sectors); });
  }
  add("grass", "GRASS r.sun, diffuse",
    "diff_rad, sun at the zenith, coeff_bh=0: no shadows of terrain; with start and files",
    PeerTurn, [reference] { return MeasureGrassDiffuse(*reference); });
}

void AddThreadJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference)
{
  const int most = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  for (int threads = 1; threads <= most;
       threads = threads < most ? std::min(2 * threads, most) : most + 1)
  {
    AddJob(
      jobs, reference, "threads", "exact",
      std::to_string(threads) + (threads == 1 ? " thread" : " threads"),
      "sky view factor, 36 azimuths", PeerTurn, [] {},
      [reference, threads]
      {
        constexpr int azimuths = 36;
        const auto filter = MakeSkyView(vtkHeightFieldAlgorithm::EXACT, azimuths);
        const auto image = ImageOf(reference->Scene.Field);
        filter->SetInputData(image);
        return TimeUpdates(filter, image, reference->Work,
          static_cast<double>(reference->Scene.Field.Heights.size()), threads);
      });
  }
}

void AddIrradianceJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference)
{
  const auto add = [&](const char* kind, const std::string& label, const std::string& settings,
                     int turn, const std::function<Result()>& measure)
  {
    AddJob(
      jobs, reference, "irradiance", kind, label, settings, turn,
      [reference] { reference->ClearSky(); }, measure);
  };
  const auto host = [&](const char* kind, const std::string& label, const std::string& settings,
                      int turn, const LightSettings& how)
  {
    add(kind, label, settings, turn,
      [reference, how]
      {
        vtkNew<vtkHeightFieldIrradiance> filter;
        return MeasureIrradiance(*reference, filter, how);
      });
  };
  LightSettings how;
  for (const int count : { 32, 64, 16, 128 })
  {
    for (const auto& search : Searches)
    {
      if (search.Method == vtkHeightFieldAlgorithm::EXACT ||
        search.Method == vtkHeightFieldAlgorithm::FAST || count == 32)
      {
        how.Count = count;
        how.Method = search.Method;
        host(search.Name, std::string(search.Name) + " " + std::to_string(count),
          "tables, " + std::to_string(count) + " azimuths",
          count == 32     ? MainTurn
            : count == 64 ? PeerTurn
                          : SweepTurn,
          how);
      }
    }
  }
  how = LightSettings();
  how.Harmonics = true;
  how.Count = 32;
  for (const int bands : { 4, 2, 3, 6, 8 })
  {
    how.Bands = bands;
    host("harmonics", "SH " + std::to_string(bands) + ", exact",
      "harmonics of " + std::to_string(bands) + " bands, 32 azimuths",
      bands == 4 ? MainTurn : SweepTurn, how);
  }
  how.Bands = 4;
  how.Method = vtkHeightFieldAlgorithm::PYRAMID;
  host("harmonics", "SH 4, pyramid", "harmonics of 4 bands, 32 azimuths", PeerTurn, how);
  how.Count = 16;
  add("gpu", "GPU SH 4, pyramid", "harmonics of 4 bands, 16 azimuths, wall time", DeviceTurn,
    [reference, how] { return MeasureDeviceIrradiance(*reference, how); });
}

void AddFrameJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference)
{
  const auto add = [&](const char* kind, const std::string& label, const std::string& settings,
                     int turn, const LightSettings& how)
  {
    AddJob(
      jobs, reference, "frame", kind, label, settings, turn, [reference] { reference->ClearSky(); },
      [reference, how] { return MeasureFrames(*reference, how); });
  };
  for (const auto& search : Searches)
  {
    LightSettings how;
    how.Method = search.Method;
    how.Count = 16;
    how.Keep = true;
    add(search.Name, std::string(search.Name) + ", table", "16 azimuths, horizons kept", MainTurn,
      how);
    how.Keep = false;
    how.Harmonics = true;
    add(search.Name, std::string(search.Name) + ", SH 4", "16 azimuths, transfer kept", PeerTurn,
      how);
  }
}

} // namespace benchmark
} // namespace skyline
