// SPDX-License-Identifier: BSD-3-Clause
#include "GpuShadows.h"

#include "Horizon/RayFrame.h"
#include "ShaderText.h"
#include "vtkOpenGLHeightFieldDevice.h"

#include "vtkObject.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace skyline
{

namespace
{

constexpr int RowLength = 1024; // steps per row of the table, as in GpuExact.glsl
constexpr int GroupLanes = 256; // as in ShadowSweep.glsl
constexpr int GroupLines = 64;  // as in HullSweep.glsl
constexpr int LinesPerRun = 64; // of the recurrence; work groups overlap by as many lanes
constexpr int HullLines = 2048; // lines of a run; one buffer holds their hulls
constexpr int HullFloats = 2;   // per sample in a hull

GpuTexture Checked(GpuTexture texture)
{
  if (!texture)
  {
    throw std::runtime_error("OpenGL has no memory for shadow heights");
  }
  return texture;
}

/// The table of steps that GpuExact.glsl reads.
GpuTexture StepTable(GpuDevice& device, const RayFrame& frame)
{
  const std::size_t rows = (frame.Steps.size() + RowLength - 1) / RowLength;
  std::vector<float> values(16 * RowLength * rows, 0.0f);
  float* texel = values.data();
  for (std::size_t d = 0; d < frame.Steps.size(); ++d, texel += 16)
  {
    const RayStep& step = frame.Steps[d];
    const SideStep& side = frame.Sides[d];
    const float numbers[15] = { static_cast<float>(step.Lane), static_cast<float>(step.Next),
      step.RowTrail, step.RowLead, step.RowDrop, step.MidNear, step.MidFar, step.MidDrop,
      side.LeftNear, side.LeftFar, side.LeftDrop, 0.0f, side.RightNear, side.RightFar,
      side.RightDrop };
    std::copy(numbers, numbers + 15, texel);
  }
  return Checked(device.Image(4 * RowLength, static_cast<int>(rows), 4, values.data()));
}

/// The functions of a shader file, without its main.
std::string Functions(const char* file)
{
  const std::string text = ShaderPart(file);
  return text.substr(0, text.find("void main()"));
}

int Groups(int count, int size)
{
  return (count + size - 1) / size;
}

} // namespace

GpuShadows::GpuShadows(GpuDevice& device, const GpuLimits& limits)
  : Device(device)
  , Limits(limits)
{
}

void GpuShadows::Load(const HeightField& field)
{
  const Grid& grid = field.Posts();
  this->Columns = static_cast<int>(grid.Columns);
  this->Rows = static_cast<int>(grid.Rows);
  const int limit = this->Device.ImageLimit();
  const int side = this->Limits.Side > 0 ? std::min(this->Limits.Side, limit) : limit;
  if (std::max(this->Columns, this->Rows) > side)
  {
    throw std::runtime_error(std::to_string(this->Columns) + " x " + std::to_string(this->Rows) +
      " posts exceed the largest texture, " + std::to_string(side) + " posts per side");
  }
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(grid.Columns * grid.Rows));
  for (std::ptrdiff_t row = 0; row < grid.Rows; ++row)
  {
    const float* line = field.RowPlane().Line(row);
    values.insert(values.end(), line, line + grid.Columns);
  }
  this->Holes = field.HasMissing();
  const auto range = std::minmax_element(values.begin(), values.end());
  this->Relief = static_cast<double>(*range.second) - *range.first;
  this->Heights = Checked(this->Device.Image(this->Columns, this->Rows, 1, values.data()));
}

void GpuShadows::Walk(const RayFrame& frame, double fall, std::vector<float>& values)
{
  if (!this->WalkPass)
  {
    this->WalkPass = std::make_unique<GpuPass>(
      this->Device, GpuText({ Functions(skyline_GpuExact), ShaderPart(skyline_ShadowWalk) }));
  }
  const GpuTexture image = Checked(this->Device.Image(this->Columns, this->Rows, 1));
  const GpuTexture steps = StepTable(this->Device, frame);
  // Where a ray has fallen by more than the relief, no terrain stands higher than what the ray has
  // met before. This does not hold beside a hole, where the ray may have met nothing.
  std::ptrdiff_t last = frame.Lines - 1;
  if (!this->Holes && fall > 0.0)
  {
    last = static_cast<std::ptrdiff_t>(
      std::min(static_cast<double>(last), std::ceil(this->Relief / fall) + 2.0));
  }
  const GpuState state(this->Device);
  if (!this->WalkPass->Use())
  {
    throw std::runtime_error("OpenGL cannot build the shader of shadow heights");
  }
  this->WalkPass->Set("heights", this->Heights);
  this->WalkPass->Set("place", 0, 0);
  this->WalkPass->Set("size", this->Columns, this->Rows);
  this->WalkPass->Set("steps", steps);
  this->WalkPass->Set("columns", frame.Columns ? 1 : 0);
  this->WalkPass->Set("forward", frame.Reversed ? -1 : 1);
  this->WalkPass->Set("drift", frame.Drift);
  this->WalkPass->Set("against", frame.Against ? 1 : 0);
  this->WalkPass->Set("first", 1);
  this->WalkPass->Set("last", static_cast<int>(last));
  this->WalkPass->Draw({ image }, { 0, 0, this->Columns, this->Rows });
  values.resize(static_cast<std::size_t>(this->Columns) * static_cast<std::size_t>(this->Rows));
  GpuCompute::Read(image, values.data());
}

void GpuShadows::Sweep(const RayFrame& frame, double fall, std::vector<float>& values)
{
  if (!this->SweepPass)
  {
    this->SweepPass = std::make_unique<GpuCompute>(this->Device, ShaderPart(skyline_ShadowSweep));
  }
  const int lanes = static_cast<int>(frame.Lanes);
  const int count = static_cast<int>(frame.Lines);
  const GpuTexture image = Checked(this->Device.Image(lanes, count, 1));
  const GpuBuffer buffers[2] = { GpuBuffer(static_cast<std::size_t>(lanes)),
    GpuBuffer(static_cast<std::size_t>(lanes)) };
  GpuCompute& pass = *this->SweepPass;
  pass.Use();
  pass.SetImage(0, image);
  pass.Set("heights", this->Heights);
  pass.Set("columns", frame.Columns ? 1 : 0);
  pass.Set("reversed", frame.Reversed ? 1 : 0);
  pass.Set("drift", frame.Drift);
  pass.Set("size", lanes, count);
  pass.Set("aside", static_cast<float>(frame.Slant));
  pass.Set("fall", static_cast<float>(fall));
  int from = 0;
  for (int top = count - 1; top > 0; top -= LinesPerRun, from = 1 - from)
  {
    const int end = std::max(top - LinesPerRun, 0);
    buffers[from].Bind(0);
    buffers[1 - from].Bind(1);
    pass.Set("lines", top, end);
    pass.Run(Groups(lanes, GroupLanes - (top - end)));
  }
  pass.Release();
  GpuCompute::Read(image, values.data());
}

void GpuShadows::Hulls(const SweepLines& sweep, std::vector<float>& values)
{
  if (!this->HullPass)
  {
    this->HullPass = std::make_unique<GpuCompute>(
      this->Device, "const float NoTerrain = -1.0e18;\n" + ShaderPart(skyline_HullSweep));
  }
  const int samples = static_cast<int>(sweep.Samples);
  const int count = static_cast<int>(sweep.Lines);
  const std::size_t floats = static_cast<std::size_t>(samples) * HullFloats;
  const int run = std::min({ HullLines, count, this->Device.ImageLimit(),
    static_cast<int>(std::min<std::size_t>(GpuBuffer::Limit() / floats, HullLines)) });
  if (samples > this->Device.ImageLimit() || run < 1)
  {
    throw std::runtime_error(
      "a sweep of " + std::to_string(samples) + " samples per line exceeds the buffers of OpenGL");
  }
  const GpuTexture image = Checked(this->Device.Image(samples, run, 1));
  const GpuBuffer hulls(floats * static_cast<std::size_t>(run));
  std::vector<float> part(static_cast<std::size_t>(samples) * static_cast<std::size_t>(run));
  GpuCompute& pass = *this->HullPass;
  for (int line = 0; line < count; line += run)
  {
    const int end = std::min(line + run, count);
    pass.Use();
    pass.SetImage(0, image);
    hulls.Bind(0);
    pass.Set("heights", this->Heights);
    pass.Set("posts", this->Columns, this->Rows);
    pass.Set("samples", samples);
    pass.Set("lines", line, end);
    pass.Set("origin", sweep.Origin[0], sweep.Origin[1]);
    pass.Set("perSample", sweep.PerSample[0], sweep.PerSample[1]);
    pass.Set("perLine", sweep.PerLine[0], sweep.PerLine[1]);
    pass.Set("begin", sweep.Begin);
    pass.Set("spacing", sweep.Step);
    pass.Set("drop", sweep.CurvatureDrop);
    pass.Run(Groups(end - line, GroupLines));
    pass.Release();
    GpuCompute::Read(image, part.data());
    std::copy_n(part.begin(), static_cast<std::ptrdiff_t>(end - line) * samples,
      values.begin() + static_cast<std::ptrdiff_t>(line) * samples);
  }
}

GpuShadows* GpuShadowPasses::Open(
  vtkObject* filter, vtkOpenGLHeightFieldDevice* device, const HeightField& field, bool computes)
{
  this->OnDevice = false;
  if (!device->IsAvailable())
  {
    this->ReportFallback(filter, device->GetReason());
    return nullptr;
  }
  if (computes && !GpuCompute::Known())
  {
    return nullptr;
  }
  if (!this->Passes || this->Device != device || this->Generation != device->GetGeneration() ||
    this->Time != device->GetMTime())
  {
    this->Passes = std::make_unique<GpuShadows>(device->Gpu(), device->Limits());
    this->Device = device;
    this->Generation = device->GetGeneration();
    this->Time = device->GetMTime();
  }
  try
  {
    this->Passes->Load(field);
    this->OnDevice = true;
    return this->Passes.get();
  }
  catch (const std::runtime_error& error)
  {
    this->ReportFallback(filter, error.what());
    return nullptr;
  }
}

GpuFailure GpuShadowPasses::Failure(vtkObject* filter)
{
  return [this, filter](const std::string& reason) { this->ReportFallback(filter, reason); };
}

void GpuShadowPasses::ReportFallback(vtkObject* filter, const std::string& reason)
{
  this->OnDevice = false;
  if (reason != this->LastReason)
  {
    vtkErrorWithObjectMacro(
      filter, "the host computes instead of the graphics processor: " << reason);
  }
  this->LastReason = reason;
}

GpuShadowExact::GpuShadowExact(
  GpuShadows& passes, GpuFailure failure, const HeightField& field, double slope, double drop)
  : ShadowHeightExact(field, slope, drop)
  , Passes(passes)
  , Failure(std::move(failure))
  , Light(slope)
  , Columns(field.Posts().Columns)
{
}

void GpuShadowExact::SetAzimuth(const Grid& grid, double azimuth)
{
  this->ShadowHeightExact::SetAzimuth(grid, azimuth);
  try
  {
    this->Passes.Walk(this->Frame(), this->Light * this->Frame().StepLength, this->Values);
  }
  catch (const std::runtime_error& error)
  {
    this->Values.clear();
    this->Failure(error.what());
  }
}

void GpuShadowExact::Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd,
  std::ptrdiff_t laneBegin, std::ptrdiff_t laneEnd, float* heights, std::ptrdiff_t stride) const
{
  if (this->Values.empty())
  {
    this->ShadowHeightExact::Find(lineBegin, lineEnd, laneBegin, laneEnd, heights, stride);
    return;
  }
  const RayFrame& frame = this->Frame();
  for (std::ptrdiff_t line = lineBegin; line < lineEnd; ++line)
  {
    const std::ptrdiff_t image = frame.ImageLine(line);
    float* out = heights + (line - lineBegin) * stride - laneBegin;
    for (std::ptrdiff_t lane = laneBegin; lane < laneEnd; ++lane)
    {
      out[lane] = this->Values[static_cast<std::size_t>(
        frame.Columns ? lane * this->Columns + image : image * this->Columns + lane)];
    }
  }
}

GpuShadowSweep::GpuShadowSweep(
  GpuShadows& passes, GpuFailure failure, const HeightField& field, double slope)
  : ShadowHeightSweep(field, slope)
  , Passes(passes)
  , Failure(std::move(failure))
{
}

void GpuShadowSweep::SetAzimuth(const Grid& grid, double azimuth)
{
  this->ShadowHeightSweep::SetAzimuth(grid, azimuth);
  try
  {
    this->Passes.Sweep(this->Frame(), this->Slope * this->Frame().StepLength, this->Cast);
    this->Done = true;
  }
  catch (const std::runtime_error& error)
  {
    this->Done = false;
    this->Failure(error.what());
  }
}

std::ptrdiff_t GpuShadowSweep::PrepareCount() const
{
  return this->Done ? 0 : this->ShadowHeightSweep::PrepareCount();
}

GpuHorizonSweep::GpuHorizonSweep(
  GpuShadows& passes, GpuFailure failure, const HeightField& field, const HorizonSettings& settings)
  : HorizonSweep(field, settings)
  , Passes(passes)
  , Failure(std::move(failure))
{
}

void GpuHorizonSweep::SetAzimuth(const Grid& grid, double azimuth)
{
  this->HorizonSweep::SetAzimuth(grid, azimuth);
  try
  {
    this->Passes.Hulls(this->LinesOfSweep(), this->Slopes);
    this->Done = true;
  }
  catch (const std::runtime_error& error)
  {
    this->Done = false;
    this->Failure(error.what());
  }
}

std::ptrdiff_t GpuHorizonSweep::PrepareCount() const
{
  return this->Done ? 0 : this->HorizonSweep::PrepareCount();
}

} // namespace skyline
