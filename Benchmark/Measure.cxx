// SPDX-License-Identifier: BSD-3-Clause
#include "Measure.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>
#include <thread>

#include <malloc.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace skyline
{
namespace benchmark
{

namespace
{

double Clock(clockid_t id)
{
  timespec time{};
  clock_gettime(id, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The value of a line of /proc/self/status, in bytes; 0 if there is no such line.
double StatusBytes(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
  {
    if (word == name + ":")
    {
      double kibibytes = 0.0;
      status >> kibibytes;
      return 1024.0 * kibibytes;
    }
    status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return 0.0;
}

struct Spread
{
  double Smallest, Median;
};

Spread SpreadOf(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const double median =
    values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  return { values.front(), median };
}

} // namespace

Seconds Now()
{
  return { Clock(CLOCK_THREAD_CPUTIME_ID), Clock(CLOCK_MONOTONIC) };
}

double ProcessCpu()
{
  return Clock(CLOCK_PROCESS_CPUTIME_ID);
}

void RepeatTimer::Report(Result& result, double count) const
{
  if (this->Repeats.empty())
  {
    return;
  }
  std::vector<double> prepare, search, total, wall;
  for (const Repeat& repeat : this->Repeats)
  {
    const double scale = 1e9 / count;
    prepare.push_back(scale * repeat.Prepare.Cpu);
    search.push_back(scale * repeat.Search.Cpu);
    total.push_back(scale * (repeat.Prepare.Cpu + repeat.Search.Cpu));
    wall.push_back(scale * (repeat.Prepare.Wall + repeat.Search.Wall));
  }
  result.ColdNs = total.front();
  result.Repeats = static_cast<double>(total.size());
  result.PrepareNs = SpreadOf(prepare).Smallest;
  result.SearchNs = SpreadOf(search).Smallest;
  result.TotalNs = SpreadOf(total).Smallest;
  result.TotalMedianNs = SpreadOf(total).Median;
  result.WallNs = SpreadOf(wall).Smallest;
  result.WallMedianNs = SpreadOf(wall).Median;
}

PeakMemory::PeakMemory()
{
  // Memory that was freed earlier must not hide later allocations. Writing "5" makes Linux reset
  // the peak.
  mallopt(M_MMAP_THRESHOLD, 64 * 1024);
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
  this->Start = StatusBytes("VmRSS");
}

double PeakMemory::FloatsPerPost(double posts) const
{
  return (StatusBytes("VmHWM") - this->Start) / sizeof(float) / posts;
}

void ForAll(
  std::size_t count, const std::function<void(std::size_t)>& work, const WantsToStop& stop)
{
  std::atomic<std::size_t> next{ 0 };
  const auto run = [&]
  {
    for (std::size_t k = next++; k < count && !(stop && stop()); k = next++)
    {
      work(k);
    }
  };
  std::vector<std::thread> others;
  try
  {
    for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k)
    {
      others.emplace_back(run);
    }
  }
  catch (const std::system_error&)
  {
    // No more threads could be started: the existing ones do the work.
  }
  run();
  for (std::thread& other : others)
  {
    other.join();
  }
}

namespace
{

// Waits until the child writes or ends. If asked to stop, kills the child and the programs that it
// started.
void Await(int end, pid_t child, const WantsToStop& stop)
{
  constexpr int patience = 50; // milliseconds
  pollfd wanted{ end, POLLIN, 0 };
  while (stop)
  {
    if (stop())
    {
      kill(-child, SIGKILL);
      return;
    }
    if (poll(&wanted, 1, patience) > 0)
    {
      return;
    }
  }
}

} // namespace

Result InChild(const std::function<Result()>& measure, const WantsToStop& stop)
{
  Result result;
  int ends[2];
  std::fflush(nullptr);
  if (pipe(ends) != 0)
  {
    std::snprintf(result.Reason, sizeof result.Reason, "no pipe: %s", std::strerror(errno));
    return result;
  }
  const pid_t child = fork();
  if (child == 0)
  {
    close(ends[0]);
    setpgid(0, 0); // Ctrl-C goes to the parent, which then ends this group
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : { SIGINT, SIGTERM, SIGHUP, SIGALRM })
    {
      std::signal(signal, SIG_DFL);
    }
    Result found;
    try
    {
      found = measure();
    }
    catch (const std::exception& failure)
    {
      std::snprintf(found.Reason, sizeof found.Reason, "%s", failure.what());
    }
    const bool written = write(ends[1], &found, sizeof found) == ssize_t{ sizeof found };
    _exit(written ? 0 : 1); // no destructors, because files and libraries belong to the parent
  }
  close(ends[1]);
  if (child > 0)
  {
    setpgid(child, child); // set by both processes, because either may run first
    Await(ends[0], child, stop);
  }
  Result found;
  const bool complete = child > 0 && read(ends[0], &found, sizeof found) == ssize_t{ sizeof found };
  close(ends[0]);
  int status = 0;
  if (child > 0)
  {
    waitpid(child, &status, 0);
  }
  if (complete)
  {
    return found;
  }
  if (WIFSIGNALED(status))
  {
    std::snprintf(result.Reason, sizeof result.Reason, "stopped by signal %d", WTERMSIG(status));
  }
  else
  {
    std::snprintf(result.Reason, sizeof result.Reason, "its process ended without a result");
  }
  return result;
}

} // namespace benchmark
} // namespace skyline
