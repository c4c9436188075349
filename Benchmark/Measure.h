// SPDX-License-Identifier: BSD-3-Clause
// Clocks, peak memory, and a separate process for each measurement.
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

/// CPU and wall time, in seconds.
struct Seconds
{
  double Cpu = 0.0; ///< of the calling thread
  double Wall = 0.0;
};
Seconds Now();

/// CPU time of all threads of the process, in seconds.
double ProcessCpu();

/// The times of the preparation and the search of a method, for each repeat.
class RepeatTimer
{
public:
  /// Begins another repeat; the first one always begins. Returns false after `repeats` repeats, or
  /// once they took `seconds` of wall time.
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
  /// Adds a repeat that was timed elsewhere.
  void Add(const Seconds& prepare, const Seconds& search)
  {
    this->Repeats.push_back({ prepare, search });
  }

  /// Fills in the nanoseconds. `count`: posts x azimuths of one repeat.
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

/// The growth of the peak of resident memory since construction, in floats per post.
class PeakMemory
{
public:
  PeakMemory();
  double FloatsPerPost(double posts) const;

private:
  double Start; // bytes
};

/// Called regularly during long work. True means stop.
using WantsToStop = std::function<bool()>;

/// Runs work(0) to work(count - 1) on all processors. It is used for reference values, which are
/// not timed. Omits the rest when asked to stop.
void ForAll(
  std::size_t count, const std::function<void(std::size_t)>& work, const WantsToStop& stop = {});

/// Runs a measurement in a forked child, so that memory, allocator caches, threads of libraries and
/// crashes do not affect other measurements. The text of an exception becomes the reason. When
/// asked to stop, the child and the programs that it runs end at once.
Result InChild(const std::function<Result()>& measure, const WantsToStop& stop = {});

} // namespace benchmark
} // namespace skyline

#endif
