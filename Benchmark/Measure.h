// SPDX-License-Identifier: BSD-3-Clause
// Clocks, peak memory, and a process of its own for every measurement.
#ifndef skyline_Measure_h
#define skyline_Measure_h

#include "Result.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// Seconds.
struct Seconds
{
  double Cpu = 0.0; ///< of the calling thread
  double Wall = 0.0;
};
Seconds Now();

/// CPU seconds of all threads of the process.
double ProcessCpu();

/// Times of the two halves of a method, repeat by repeat.
class Laps
{
public:
  /// Begins another repeat, the first in any case; false once there are `repeats`, or the ones so far
  /// took `seconds` of wall time.
  bool Next(int repeats, double seconds)
  {
    const double now = Now().Wall;
    if (this->Repeats.empty())
    {
      this->Start = now;
    }
    else if (this->Repeats.size() >= static_cast<std::size_t>(repeats) ||
      now - this->Start >= seconds)
    {
      return false;
    }
    this->Repeats.emplace_back();
    return true;
  }

  template <typename Work>
  void Prepare(const Work& work)
  {
    Time(this->Repeats.back().Prepare, work);
  }
  template <typename Work>
  void Search(const Work& work)
  {
    Time(this->Repeats.back().Search, work);
  }
  /// A repeat timed elsewhere.
  void Add(const Seconds& prepare, const Seconds& search)
  {
    this->Repeats.push_back({ prepare, search });
  }

  /// Fills in the nanoseconds; count: posts x azimuths of a repeat.
  void Report(Result& result, double count) const;

private:
  struct Repeat
  {
    Seconds Prepare, Search;
  };

  template <typename Work>
  static void Time(Seconds& sum, const Work& work)
  {
    const Seconds start = Now();
    work();
    const Seconds end = Now();
    sum.Cpu += end.Cpu - start.Cpu;
    sum.Wall += end.Wall - start.Wall;
  }

  std::vector<Repeat> Repeats;
  double Start = 0.0;
};

/// Growth of the peak of resident memory from construction on, in floats a post.
class PeakMemory
{
public:
  PeakMemory();
  double FloatsPerPost(double posts) const;

private:
  double Start; // bytes
};

/// Asked now and then during long work; true: stop.
using WantsToStop = std::function<bool()>;

/// Runs work(0) to work(count - 1) on all processors, for truths, which nobody times. Leaves the
/// rest out when asked to stop.
void ForAll(
  std::size_t count, const std::function<void(std::size_t)>& work, const WantsToStop& stop = {});

/// Runs a measurement in a forked child, so that memory, caches of the allocator, threads of
/// libraries and crashes stay its own. What it throws becomes the reason. When asked to stop, the
/// child ends at once, with the programs that it runs.
Result InChild(const std::function<Result()>& measure, const WantsToStop& stop = {});

} // namespace benchmark
} // namespace skyline

#endif
