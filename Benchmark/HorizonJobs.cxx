// SPDX-License-Identifier: BSD-3-Clause
#include "Jobs.h"

#include "DeviceRun.h"
#include "EmbreeHorizon.h"
#include "EveryCrossing.h"
#include "GrassHorizon.h"
#include "Horizon/HorizonExact.h"
#include "KernelMethods.h"
#include "SceneImage.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLHeightFieldDevice.h"
#include "vtkOpenGLHeightFieldHorizon.h"
#include "vtkPointData.h"

#include <cstdio>

namespace skyline
{
namespace benchmark
{

namespace
{

constexpr std::size_t ThinEvery = 8; // "every crossing" is slow and runs in every eighth azimuth
constexpr int DeviceAzimuths = 16;   // half of those of the reference

Result MeasureDevice(ReferenceScene& reference, bool pyramid)
{
  const ReferenceHorizons& truth = reference.Horizons();
  const auto image = ImageOf(reference.Scene.Field);
  vtkNew<vtkOpenGLHeightFieldHorizon> filter;
  RequireDevice(filter->GetDevice());
  filter->SetInputData(image);
  filter->SetNumberOfAzimuths(DeviceAzimuths);
  filter->SetMethod(pyramid ? vtkHeightFieldAlgorithm::PYRAMID : vtkHeightFieldAlgorithm::EXACT);
  const auto posts = static_cast<double>(reference.Scene.Field.Heights.size());
  Result result =
    TimeUpdates(filter, image, reference.Work, posts * static_cast<double>(DeviceAzimuths));
  CheckOnDevice(filter->IsOnDevice());
  KeepWallOnly(result);
  auto* found =
    vtkFloatArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetArray("HorizonElevation"));
  ErrorSum errors;
  const std::size_t step = truth.Azimuths.size() / DeviceAzimuths;
  for (int k = 0; k < DeviceAzimuths; ++k)
  {
    for (std::size_t post = 0; post < truth.Posts.size(); ++post)
    {
      errors.Add(static_cast<double>(found->GetTypedComponent(truth.Posts[post], k)),
        truth.Elevation(static_cast<std::size_t>(k) * step, post));
    }
  }
  result.Error = errors.Get();
  std::snprintf(result.Reason, sizeof result.Reason, "%s",
    filter->GetDevice()->GetName().substr(0, 150).c_str());
  return result;
}

// Adds jobs on the horizons of a scene.
class HorizonJobs
{
public:
  HorizonJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference)
    : Jobs(jobs)
    , Reference(reference)
  {
  }

  void Add(const char* kind, const std::string& label, const std::string& settings, int turn,
    const std::function<Result()>& measure)
  {
    AddJob(
      this->Jobs, this->Reference, "horizon", kind, label, settings, turn,
      [reference = this->Reference] { reference->Horizons(); }, measure);
  }

  void AddKernel(const char* kind, const std::string& label, const std::string& settings, int turn,
    const HorizonSettings& how)
  {
    this->Add(kind, label, settings, turn,
      [reference = this->Reference, how]
      {
        return MeasureKernel(
          reference->Scene, reference->Horizons(),
          [&](const HeightField& field) { return MakeHorizonMethod(field, how); },
          reference->Work.Repeats, 1, reference->Work.Seconds);
      });
  }

  void AddMethods();
  void AddPeers(bool much);
  void AddTolerances();
  void AddPyramids();

private:
  std::vector<Job>& Jobs;
  ReferenceScenePointer Reference;
};

void HorizonJobs::AddMethods()
{
  HorizonSettings how;
  char segments[100]; // compiled constants, not settings: see Documentation/horizon.md
  std::snprintf(segments, sizeof segments, "%td near lines, segments of %td lines in groups of %td",
    std::ptrdiff_t{ ExactState::NearLines }, std::ptrdiff_t{ SegmentBounds::Lines },
    std::ptrdiff_t{ SegmentBounds::PerGroup });
  const std::string search = segments;
  this->AddKernel("exact", "exact", "tolerance 0, " + search, MainTurn, how);
  how.Method = HorizonMethodKind::Fast;
  this->AddKernel("fast", "fast", "tolerance 0.25 degrees, certified; " + search, MainTurn, how);
  how.Method = HorizonMethodKind::Sweep;
  this->AddKernel("sweep", "sweep", "as published, resampled to the posts", MainTurn, how);
  how.Method = HorizonMethodKind::Pyramid;
  this->AddKernel("pyramid", "pyramid", "k = 4, o = 2, b-spline", MainTurn, how);
  how.Pyramid.Spline = false;
  this->AddKernel("pyramid", "pyramid, max", "k = 4, o = 2, greatest level only", PeerTurn, how);
}

void HorizonJobs::AddPeers(bool much)
{
  this->Add("every", "every crossing", "plain loops, every eighth azimuth",
    much ? MainTurn : PeerTurn,
    [reference = this->Reference]
    {
      return MeasureKernel(
        reference->Scene, reference->Horizons(),
        [](const HeightField& field)
        { return std::make_unique<EveryCrossing>(field, HorizonSettings()); },
        reference->Work.Repeats, ThinEvery, reference->Work.Seconds);
    });
  for (const double accuracy : { 0.25, 0.01 })
  {
    char label[40];
    std::snprintf(label, sizeof label, "Embree %.2f°", accuracy);
    this->Add("embree", label, "occlusion rays, bracket from the previous azimuth",
      accuracy > 0.1 && much ? MainTurn : PeerTurn,
      [reference = this->Reference, accuracy]
      {
        return MeasureEmbree(
          reference->Scene, reference->Horizons(), accuracy, reference->Work.Repeats);
      });
  }
  this->Add("grass", "GRASS r.horizon", "-d, whole raster, with start and files", PeerTurn,
    [reference = this->Reference]
    { return MeasureGrass(reference->Scene, reference->Horizons(), 1); });
}

void HorizonJobs::AddTolerances()
{
  HorizonSettings how;
  for (const double tolerance : { 0.05, 1.0 })
  {
    how.Tolerance = tolerance * RadiansPerDegree;
    char label[40];
    std::snprintf(label, sizeof label, "exact, %.3g°", tolerance);
    this->AddKernel("exact", label, "may fall short by the tolerance", SweepTurn, how);
  }
}

void HorizonJobs::AddPyramids()
{
  HorizonSettings how;
  how.Method = HorizonMethodKind::Pyramid;
  for (const double step : { 2.0, 8.0 })
  {
    how.Pyramid.LevelStep = step;
    char label[40];
    std::snprintf(label, sizeof label, "pyramid k=%.0f", step);
    this->AddKernel("pyramid", label, "o = 2, b-spline", SweepTurn, how);
  }
  how.Pyramid.LevelStep = 4.0;
  for (const double offset : { 0.0, 4.0 })
  {
    how.Pyramid.LevelOffset = offset;
    char label[40];
    std::snprintf(label, sizeof label, "pyramid o=%.0f", offset);
    this->AddKernel("pyramid", label, "k = 4, b-spline", SweepTurn, how);
  }
}

} // namespace

void AddHorizonJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference, bool much)
{
  HorizonJobs all(jobs, reference);
  all.AddMethods();
  all.AddPeers(much);
  all.AddTolerances();
  if (!much)
  {
    return;
  }
  all.AddPyramids();
  all.Add("gpu", "GPU exact", "16 azimuths, wall time", DeviceTurn,
    [reference] { return MeasureDevice(*reference, false); });
  all.Add("gpu", "GPU pyramid", "16 azimuths, k = 4, o = 2, wall time", DeviceTurn,
    [reference] { return MeasureDevice(*reference, true); });
}

} // namespace benchmark
} // namespace skyline
