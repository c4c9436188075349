// SPDX-License-Identifier: BSD-3-Clause
// Independent jobs on all threads, in batches, after each of which the calling thread reports
// progress.
#ifndef skyline_Batches_h
#define skyline_Batches_h

#include "vtkSMPTools.h"

#include <algorithm>
#include <exception>
#include <mutex>

namespace skyline
{

/// Number of jobs in a batch for each thread.
constexpr int JobsPerThread = 4;

/// Calls work(job) for each job in [0, jobs), on any thread and in any order within a batch, and
/// then finish(begin, end) for the batch on the calling thread. The first exception of a job ends
/// the run and is rethrown on the calling thread. One thread is enough.
template <typename Work, typename Finish>
void RunInBatches(int jobs, const Work& work, const Finish& finish)
{
  const int batch = std::max(1, JobsPerThread * vtkSMPTools::GetEstimatedNumberOfThreads());
  std::exception_ptr thrown;
  std::mutex mutex;
  for (int begin = 0; begin < jobs; begin += batch)
  {
    const int end = std::min(jobs, begin + batch);
    vtkSMPTools::For(begin, end, 1,
      [&](vtkIdType first, vtkIdType last)
      {
        try
        {
          for (vtkIdType job = first; job < last; ++job)
          {
            work(static_cast<int>(job));
          }
        }
        catch (...)
        {
          const std::lock_guard<std::mutex> lock(mutex);
          thrown = thrown ? thrown : std::current_exception();
        }
      });
    if (thrown)
    {
      std::rethrow_exception(thrown);
    }
    finish(begin, end);
  }
}

} // namespace skyline

#endif
