// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include "Jobs.h"
#include "Machine.h"
#include "Scenes.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace skyline
{
namespace benchmark
{

namespace
{

bool IsAmong(const std::string& name, const std::vector<std::string>& names)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<StagePointer> MakeStages(const SessionOptions& options, const WantsToStop& stop)
{
  std::vector<StagePointer> stages;
  const auto add = [&](const std::string& scene, int size, bool named)
  {
    Effort effort;
    effort.Size = size;
    Scene made = MakeScene(scene, size);
    made.Name += named ? " " + std::to_string(size) : "";
    for (int copy = 2; std::any_of(stages.begin(), stages.end(),
           [&](const StagePointer& stage) { return stage->Scene.Name == made.Name; });
         ++copy) // two files of one name
    {
      made.Name = made.Name.substr(0, made.Name.find(" #")) + " #" + std::to_string(copy);
    }
    stages.push_back(std::make_shared<Stage>(std::move(made), effort, stop));
  };
  for (const std::string& file : options.Rasters) // what the user brings comes first
  {
    add(file, 0, false);
  }
  for (const std::string& scene : options.Scenes)
  {
    if (scene == "helens") // has its own size
    {
      add(scene, 0, false);
      continue;
    }
    for (const int size : options.Sizes)
    {
      add(scene, size, options.Sizes.size() > 1);
    }
  }
  return stages;
}

std::vector<Job> MakeJobs(const SessionOptions& options, const std::vector<StagePointer>& stages)
{
  std::vector<Job> jobs;
  const auto begins = [](const StagePointer& stage, std::initializer_list<const char*> names)
  {
    return std::any_of(names.begin(), names.end(),
      [&](const char* name) { return stage->Scene.Name.rfind(name, 0) == 0; });
  };
  for (std::size_t k = 0; k < stages.size(); ++k)
  {
    const StagePointer& stage = stages[k];
    // Light is measured on few of the made scenes: it repeats what horizons say.
    const bool main = k < options.Rasters.size() || begins(stage, { "hills", "helens", "lidar" });
    const bool only = stages.size() == 1;
    const std::size_t before = jobs.size();
    AddHorizonJobs(jobs, stage, main || only);
    if (main || only)
    {
      AddSkyJobs(jobs, stage);
      AddIrradianceJobs(jobs, stage);
      AddLampJobs(jobs, stage);
    }
    AddSunJobs(jobs, stage);
    if (begins(stage, { "moving" }))
    {
      AddFrameJobs(jobs, stage);
    }
    if (begins(stage, { "hills" }) || only)
    {
      AddThreadJobs(jobs, stage);
    }
    for (std::size_t j = before; j < jobs.size() && !main; ++j)
    {
      jobs[j].What.Turn += jobs[j].What.Quantity == "frame" ? 0 : 1;
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
  // Scenes and quantities take turns, so that no time is too short for some of each.
  std::map<std::tuple<int, std::string, std::string>, int> counts;
  std::vector<std::pair<std::pair<int, int>, std::size_t>> order;
  for (std::size_t j = 0; j < jobs.size(); ++j)
  {
    const Task& task = jobs[j].What;
    order.push_back({ { task.Turn, counts[{ task.Turn, task.Quantity, task.Scene }]++ }, j });
  }
  std::sort(order.begin(), order.end());
  std::vector<Job> sorted;
  sorted.reserve(jobs.size());
  for (const auto& place : order)
  {
    sorted.push_back(std::move(jobs[place.second]));
  }
  return sorted;
}

} // namespace

Session RunSession(const SessionOptions& options, const Tell& tell, const WantsToStop& stop)
{
  Session session;
  const double start = Now().Wall;
  const auto stopped = [&] { return stop && stop(); };
  session.Machine = MachineFacts();
  const std::vector<StagePointer> stages = MakeStages(options, stop);
  for (const StagePointer& stage : stages)
  {
    session.Scenes.emplace_back(stage->Scene.Name, stage->Scene.Description);
  }
  const std::vector<Job> jobs = MakeJobs(options, stages);
  for (std::size_t k = 0; k < jobs.size() && !stopped(); ++k)
  {
    const Job& job = jobs[k];
    if (Now().Wall - start > options.Budget)
    {
      session.LeftOut.push_back(job.What);
      continue;
    }
    tell(k, jobs.size(), job.What.Scene + ": " + job.What.Label + ", " + job.What.Quantity);
    job.Prepare();
    if (!stopped())
    {
      session.Findings.push_back({ job.What, InChild(job.Measure, stop) });
    }
  }
  session.Machine.emplace_back("load at the end", Load());
  session.Seconds = Now().Wall - start;
  return session;
}

} // namespace benchmark
} // namespace skyline
