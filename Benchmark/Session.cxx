// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include "External.h"
#include "Jobs.h"
#include "Machine.h"
#include "Scenes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

namespace skyline
{
namespace benchmark
{

namespace
{

constexpr double LeastLimit = 10.0; // seconds that each measurement may take at least

bool IsAmong(const std::string& name, const std::vector<std::string>& names)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<ReferenceScenePointer> MakeReferenceScenes(
  const SessionOptions& options, const WantsToStop& stop)
{
  std::vector<ReferenceScenePointer> scenes;
  const auto add = [&](const std::string& scene, int size, bool named)
  {
    Effort effort;
    effort.Size = size;
    Scene made = MakeScene(scene, size);
    made.Name += named ? " " + std::to_string(size) : "";
    for (int copy = 2; std::any_of(scenes.begin(), scenes.end(),
           [&](const ReferenceScenePointer& reference)
           { return reference->Scene.Name == made.Name; });
         ++copy) // for files with the same name
    {
      made.Name = made.Name.substr(0, made.Name.find(" #")) + " #" + std::to_string(copy);
    }
    scenes.push_back(std::make_shared<ReferenceScene>(std::move(made), effort, stop));
  };
  for (const std::string& file : options.Rasters) // rasters of the user come first
  {
    add(file, 0, false);
  }
  for (const std::string& scene : options.Scenes)
  {
    if (scene == "helens") // this scene has its own size
    {
      add(scene, 0, false);
      continue;
    }
    for (const int size : options.Sizes)
    {
      add(scene, size, options.Sizes.size() > 1);
    }
  }
  return scenes;
}

// A killed child leaves its temporary files behind. They lie in this folder, which is removed at
// the end.
class TemporaryFiles
{
public:
  TemporaryFiles()
  {
    const char* before = std::getenv("TMPDIR");
    this->Before = before ? before : "";
    setenv("TMPDIR", this->Folder.Path().c_str(), 1);
  }
  ~TemporaryFiles()
  {
    if (this->Before.empty())
    {
      unsetenv("TMPDIR");
    }
    else
    {
      setenv("TMPDIR", this->Before.c_str(), 1);
    }
  }
  TemporaryFiles(const TemporaryFiles&) = delete;
  TemporaryFiles& operator=(const TemporaryFiles&) = delete;

private:
  ScratchFolder Folder;
  std::string Before;
};

// Measures in a child process, which is ended if it takes too long for the budget.
Result MeasureWithin(
  double seconds, const std::function<Result()>& measure, const WantsToStop& stop)
{
  const double start = Now().Wall;
  bool late = false;
  Result result = InChild(measure,
    [&]
    {
      late = late || Now().Wall - start > seconds;
      return late || (stop && stop());
    });
  if (late && !result.Ran)
  {
    std::snprintf(result.Reason, sizeof result.Reason,
      "ended after %.0f s, more than a quarter of the budget; use a greater --budget", seconds);
  }
  return result;
}

std::vector<Job> MakeJobs(
  const SessionOptions& options, const std::vector<ReferenceScenePointer>& scenes)
{
  std::vector<Job> jobs;
  const auto begins =
    [](const ReferenceScenePointer& reference, std::initializer_list<const char*> names)
  {
    return std::any_of(names.begin(), names.end(),
      [&](const char* name) { return reference->Scene.Name.rfind(name, 0) == 0; });
  };
  for (std::size_t k = 0; k < scenes.size(); ++k)
  {
    const ReferenceScenePointer& reference = scenes[k];
    // Light is measured on a few scenes only, because its errors follow those of the horizons.
    const bool main =
      k < options.Rasters.size() || begins(reference, { "hills", "helens", "lidar" });
    const bool only = scenes.size() == 1;
    const std::size_t before = jobs.size();
    AddHorizonJobs(jobs, reference, main || only);
    if (main || only)
    {
      AddSkyJobs(jobs, reference);
      AddBeamJobs(jobs, reference);
      AddIrradianceJobs(jobs, reference);
      AddLampJobs(jobs, reference);
    }
    AddSunJobs(jobs, reference);
    if (begins(reference, { "moving" }))
    {
      AddFrameJobs(jobs, reference);
    }
    if (begins(reference, { "hills" }) || only)
    {
      AddThreadJobs(jobs, reference);
    }
    // The main setting of each method comes before further values of a parameter on any scene.
    const bool first = k < options.Rasters.size() || begins(reference, { "hills" });
    const int later = first ? 0 : main ? 1 : 2;
    for (std::size_t j = before; j < jobs.size(); ++j)
    {
      const std::string& quantity = jobs[j].What.Quantity;
      jobs[j].What.Turn += quantity == "frame" ? 0
        : quantity == "horizon"                ? std::min(later, 1)
                                               : later;
    }
  }
  const auto wanted = [&](const Task& task)
  {
    return (options.Kinds.empty() || IsAmong(task.Kind, options.Kinds)) &&
      (options.Quantities.empty() || IsAmong(task.Quantity, options.Quantities));
  };
  jobs.erase(
    std::remove_if(jobs.begin(), jobs.end(), [&](const Job& job) { return !wanted(job.What); }),
    jobs.end());
  // Within a turn, measure chart by chart, because one method alone tells little.
  const auto place = [&](const Task& task)
  {
    const auto quantity = std::find_if(Quantities().begin(), Quantities().end(),
      [&](const Quantity& one) { return one.Name == task.Quantity; });
    return std::pair(task.Turn, quantity - Quantities().begin());
  };
  std::stable_sort(jobs.begin(), jobs.end(),
    [&](const Job& a, const Job& b) { return place(a.What) < place(b.What); });
  return jobs;
}

} // namespace

Session RunSession(
  const SessionOptions& options, const ProgressFunction& tell, const WantsToStop& stop)
{
  Session session;
  const double start = Now().Wall;
  const auto stopped = [&] { return stop && stop(); };
  session.Budget = options.Budget;
  session.Machine = MachineFacts();
  const std::vector<ReferenceScenePointer> scenes = MakeReferenceScenes(options, stop);
  for (const ReferenceScenePointer& reference : scenes)
  {
    session.Scenes.emplace_back(reference->Scene.Name, reference->Scene.Description);
  }
  const std::vector<Job> jobs = MakeJobs(options, scenes);
  if (jobs.empty())
  {
    throw std::runtime_error(
      "nothing to measure: no method chosen is measured for the quantities "
      "chosen on these scenes; leave out --methods, --quantities or --scenes");
  }
  const TemporaryFiles files;
  const double longest = std::max(LeastLimit, 0.25 * options.Budget); // limit for one measurement
  for (std::size_t k = 0; k < jobs.size() && !stopped(); ++k)
  {
    const Job& job = jobs[k];
    if (Now().Wall - start > options.Budget)
    {
      session.LeftOut.push_back(job.What);
      continue;
    }
    tell(k, jobs.size(), job.What.Scene + ": " + job.What.Label + ", " + job.What.Quantity);
    const double begin = Now().Wall;
    job.Prepare();
    if (!stopped())
    {
      session.Findings.push_back({ job.What, MeasureWithin(longest, job.Measure, stop) });
      session.Findings.back().Seconds = Now().Wall - begin;
    }
  }
  session.Machine.emplace_back("load at the end", Load());
  session.Seconds = Now().Wall - start;
  return session;
}

} // namespace benchmark
} // namespace skyline
