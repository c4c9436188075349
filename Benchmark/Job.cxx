// SPDX-License-Identifier: BSD-3-Clause
#include "Job.h"

#include "Jobs.h"

#include <algorithm>
#include <cmath>

namespace skyline
{
namespace benchmark
{

const std::vector<Quantity>& Quantities()
{
  static const std::vector<Quantity> quantities{
    { "horizon", "Horizons", "rmse of the horizon, degrees", "ns per post and azimuth", false },
    { "sky", "Sky view factor", "rmse of the sky view factor, 0 to 1", "ns per post", false },
    { "irradiance", "Irradiance of a clear sky", "rmse, % of the mean irradiance", "ns per post",
      false },
    { "sun", "Visibility of the sun", "posts on the wrong side of a shadow, %",
      "ns per post and sun", true },
    { "beam", "Irradiance of the sun", "rmse, % of the mean irradiance", "ns per post and sun",
      false },
    { "lamp", "Irradiance of a lamp", "rmse, % of the mean irradiance", "ns per post", false },
    { "frame", "Moving terrain: a frame", "rmse, % of the mean irradiance", "ns per post", false },
    { "threads", "Threads: sky view of 36 azimuths", "", "ns per post, wall time", false },
  };
  return quantities;
}

const Quantity& FindQuantity(const std::string& name)
{
  return *std::find_if(Quantities().begin(), Quantities().end(),
    [&](const Quantity& quantity) { return quantity.Name == name; });
}

const std::vector<std::string>& Kinds()
{
  static const std::vector<std::string> kinds{ "exact", "fast", "sweep", "pyramid", "harmonics",
    "shadow-height", "lamp", "gpu", "every", "embree", "grass", "saga", "gdaldem" };
  return kinds;
}

void AddJob(std::vector<Job>& jobs, const ReferenceScenePointer& reference, const char* quantity,
  const char* kind, const std::string& label, const std::string& settings, int turn,
  std::function<void()> prepare, std::function<Result()> measure)
{
  Job job;
  job.What.Quantity = quantity;
  job.What.Scene = reference->Scene.Name;
  job.What.Kind = kind;
  job.What.Label = label;
  job.What.Settings = settings;
  job.What.Turn = turn;
  job.Prepare = std::move(prepare);
  job.Measure = std::move(measure);
  jobs.push_back(std::move(job));
}

double TimeOf(const Finding& finding)
{
  const Result& found = finding.Found;
  const bool wall = std::isnan(found.TotalMedianNs) || finding.What.Quantity == "threads";
  return found.Ran ? (wall ? found.WallMedianNs : found.TotalMedianNs) : NotMeasured;
}

double ErrorOf(const Finding& finding)
{
  const Result& found = finding.Found;
  return !found.Ran                               ? NotMeasured
    : FindQuantity(finding.What.Quantity).ByWrong ? found.WrongPercent
                                                  : found.Error.Rmse;
}

} // namespace benchmark
} // namespace skyline
