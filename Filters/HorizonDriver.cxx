// SPDX-License-Identifier: BSD-3-Clause
#include "HorizonDriver.h"

#include "Data/MemoryDemand.h"
#include "FanBlend.h"
#include "Geo/RayFan.h"
#include "PyramidCache.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

namespace skyline
{

namespace
{

double Now()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

// Adds the seconds of its lifetime to a sum.
class Timer
{
public:
  explicit Timer(double& sum)
    : Sum(sum)
    , Start(Now())
  {
  }
  ~Timer() { this->Sum += Now() - this->Start; }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

private:
  double& Sum;
  double Start;
};

} // namespace

HorizonDriver::HorizonDriver(
  HorizonInput& input, const HorizonSettings& settings, PyramidCache* pyramids)
  : Surface(input)
  , Settings(settings)
  , Pyramids(pyramids)
{
  if (const auto doubt = input.BendingDoubt())
  {
    this->AddDoubt(*doubt);
  }
}

bool HorizonDriver::Run(
  const std::vector<double>& azimuths, double width, Accumulator& consumer, AzimuthAxes axes)
{
  std::shared_ptr<const HeightPyramid> pyramid;
  if (this->Pyramids && this->Settings.Method == HorizonMethodKind::Pyramid)
  {
    const std::uint64_t checksum = this->Surface.Checksum();
    const Timer timer(this->PrepareSeconds);
    bool built = false;
    pyramid =
      this->Pyramids->Get(this->Surface.Field(), checksum, this->Settings.Pyramid.LevelStep, built);
    this->PyramidBuilds += built ? 1 : 0;
  }
  const auto method = MakeHorizonMethod(this->Surface.Field(), this->Settings, pyramid);
  if (!this->FollowsGround())
  {
    this->DoubtOneMetric(
      this->Settings.Method == HorizonMethodKind::Sweep ? "the sweep" : "the pyramid",
      this->Surface.CentreMetric());
  }
  return this->FollowsGround() && !this->Surface.Ground().Uniform()
    ? this->RunFans(*method, azimuths, width, consumer, axes)
    : this->Run(*method, azimuths, width, consumer, axes);
}

bool HorizonDriver::Run(HorizonMethod& method, const std::vector<double>& azimuths, double width,
  Accumulator& consumer, AzimuthAxes axes)
{
  const std::vector<RowBand>& bands = this->Surface.Bands();
  const Grid& posts = this->Surface.Posts();
  const double total = static_cast<double>(azimuths.size() * bands.size());
  double done = 0.0;
  const auto add = [&](std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count,
                     const float* slopes) { consumer.Add(row, column, count, slopes); };
  for (const double azimuth : azimuths)
  {
    consumer.Begin(azimuth, width);
    const double ground = axes == AzimuthAxes::Image
      ? this->Surface.Ground().GroundAzimuth(this->Surface.CentreMetric(), azimuth)
      : azimuth;
    for (const RowBand& band : bands)
    {
      if (!this->Goes(done++ / total))
      {
        return false;
      }
      const Grid grid = WithSpacing(posts, band);
      const PostRegion region{ band.RowBegin, band.RowEnd, 0, grid.Columns };
      this->Prepare(method, grid, ground, region);
      const Timer timer(this->SearchSeconds);
      FindSlopes(method, region, add);
    }
  }
  this->Finish(consumer);
  return true;
}

bool HorizonDriver::RunFans(HorizonMethod& method, const std::vector<double>& azimuths,
  double width, Accumulator& consumer, AzimuthAxes axes)
{
  const GroundMetric& ground = this->Surface.Ground();
  const Grid& posts = this->Surface.Posts();
  const auto count = static_cast<double>(azimuths.size());
  std::unique_ptr<FanBlend> blend;
  for (std::size_t number = 0; number < azimuths.size(); ++number)
  {
    consumer.Begin(azimuths[number], width);
    const RayFan fan(
      ground, azimuths[number], axes == AzimuthAxes::Image, this->Settings.CurvatureDrop > 0.0);
    if (fan.IsOne())
    {
      if (!this->Goes(static_cast<double>(number) / count))
      {
        return false;
      }
      this->RunRay(method, fan, consumer);
      continue;
    }
    if (!blend)
    {
      blend = std::make_unique<FanBlend>(ground);
    }
    blend->Begin(fan);
    const std::size_t lengths = fan.Lengths.size();
    const std::size_t rays = fan.Directions.size() * lengths;
    for (std::size_t ray = 0; ray < rays; ++ray)
    {
      const double part = static_cast<double>(ray) / static_cast<double>(rays);
      if (!this->Goes((static_cast<double>(number) + part) / count))
      {
        return false;
      }
      PostRegion region;
      if (blend->Asks(ray / lengths, ray % lengths, region))
      {
        this->Prepare(method, WithSpacing(posts, fan.MetricOf(ray % lengths)),
          fan.Directions[ray / lengths], region);
        const Timer timer(this->SearchSeconds);
        blend->Add(method);
      }
    }
    blend->End(consumer);
  }
  this->Finish(consumer);
  return true;
}

void HorizonDriver::RunRay(HorizonMethod& method, const RayFan& fan, Accumulator& consumer)
{
  const Grid& posts = this->Surface.Posts();
  const PostRegion whole{ 0, posts.Rows, 0, posts.Columns };
  this->Prepare(method, WithSpacing(posts, fan.MetricOf(0)), fan.Directions[0], whole);
  const Timer timer(this->SearchSeconds);
  FindSlopes(method, whole,
    [&](std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, float* slopes)
    {
      FanBlend::Lengthen(this->Surface.Ground(), method.Frame(), row, column, count, slopes);
      consumer.Add(row, column, count, slopes);
    });
}

void HorizonDriver::Prepare(
  HorizonMethod& method, const Grid& grid, double azimuth, const PostRegion& region)
{
  const Timer timer(this->PrepareSeconds);
  if (RayFrame::TakesColumns(grid, azimuth))
  {
    this->Surface.Transpose(); // done once; a sun in the north or south does not need it
  }
  method.SetAzimuth(grid, azimuth);
  AskFor(method, region);
  vtkSMPTools::For(
    0, method.PrepareCount(), [&](vtkIdType begin, vtkIdType end) { method.Prepare(begin, end); });
}

void HorizonDriver::Finish(Accumulator& consumer) const
{
  vtkSMPTools::For(0, this->Surface.Posts().Rows,
    [&](vtkIdType begin, vtkIdType end) { consumer.Finish(begin, end); });
}

bool HorizonDriver::Goes(double done) const
{
  return !this->Progress || this->Progress(done);
}

bool HorizonDriver::FollowsGround() const
{
  return this->Settings.Method == HorizonMethodKind::Exact ||
    this->Settings.Method == HorizonMethodKind::Fast;
}

void HorizonDriver::AddDoubt(const Doubt& doubt)
{
  const auto same = [&](const Doubt& known) { return DoubtText(known) == DoubtText(doubt); };
  if (std::none_of(this->Found.begin(), this->Found.end(), same))
  {
    this->Found.push_back(doubt);
  }
}

void HorizonDriver::DoubtOneMetric(const std::string& what, const PostMetric& used)
{
  if (const auto doubt = this->Surface.OneMetricDoubt(what, used))
  {
    this->AddDoubt(*doubt);
  }
}

bool HorizonDriver::TakesColumns(const std::vector<double>& azimuths) const
{
  Grid grid = this->Surface.Posts();
  // This holds for both types of azimuth axes: near the diagonal it may count one plane too many.
  const double slack = this->Surface.Ground().Uniform() ? 1.0 : 2.0;
  const auto& bands = this->Surface.Bands();
  return std::any_of(bands.begin(), bands.end(),
    [&](const RowBand& band)
    {
      grid.SpacingX = band.SpacingX / slack;
      grid.SpacingY = band.SpacingY;
      return std::any_of(azimuths.begin(), azimuths.end(),
        [&](double azimuth) { return RayFrame::TakesColumns(grid, azimuth); });
    });
}

void HorizonDriver::DemandFloats(
  const char* what, std::ptrdiff_t floats, const std::vector<double>& azimuths) const
{
  const std::ptrdiff_t blend =
    this->Surface.Ground().Uniform() || !this->FollowsGround() ? 0 : FanBlend::Floats;
  double all = static_cast<double>(floats + blend + (this->TakesColumns(azimuths) ? 1 : 0));
  if (this->Settings.Method == HorizonMethodKind::Pyramid &&
    !(this->Pyramids && !this->Pyramids->Empty()))
  {
    // Each level has 1 / b of the rows of the level below, and 1 / b^2 of its samples
    // (HeightPyramid.h).
    const double ratio = std::exp2(-1.0 / this->Settings.Pyramid.LevelStep);
    const double copies = 1.0 / (1.0 - ratio) + 1.0 / (1.0 - ratio * ratio);
    all += copies * (this->Surface.Field().HasMissing() ? 2.0 : 1.0);
  }
  const Grid& posts = this->Surface.Posts();
  DemandMemory(what, posts.Columns, posts.Rows, all * sizeof(float));
}

} // namespace skyline
