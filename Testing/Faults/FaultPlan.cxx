// SPDX-License-Identifier: BSD-3-Clause
#include "FaultPlan.h"

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace skyline
{
namespace testing
{

namespace
{

constexpr std::size_t Kinds = static_cast<std::size_t>(Call::Count);

/// The content of the file of counts: the number of calls of each type, how many of them failed,
/// and the time at which a signal was sent, by the monotonic clock.
struct FaultCounts
{
  std::atomic<std::uint64_t> Calls[Kinds];
  std::atomic<std::uint64_t> Failed;
  std::atomic<std::uint64_t> SentNanoseconds;
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "threads and processes share it");

struct FaultPlan
{
  Call What = Call::Count;
  std::uint64_t Number = 0;
  int Error = EIO;
  bool Short = false;
  int Signal = 0;
  bool Lasting = false;
  std::size_t LeastBytes = 0;
};

FaultPlan Plan;
FaultCounts OwnCounts;
FaultCounts* Counts = &OwnCounts;
std::atomic<bool> Armed{ false };

const char* Setting(const char* name)
{
  const char* const value = std::getenv(name);
  return value ? value : "";
}

/// Maps the file of counts as shared memory, so that its content outlives the process.
void ShareCounts(const char* path)
{
  // System calls, because the functions of the C library are counted.
  const long file = ::syscall(SYS_openat, AT_FDCWD, path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0 || ::syscall(SYS_ftruncate, file, sizeof(FaultCounts)) != 0)
  {
    return;
  }
  const long place =
    ::syscall(SYS_mmap, nullptr, sizeof(FaultCounts), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0L);
  if (place != -1)
  {
    Counts = reinterpret_cast<FaultCounts*>(place);
  }
  (void)::syscall(SYS_close, file);
}

/// Runs when the library is loaded. Calls that other libraries make before are neither counted nor
/// failed.
__attribute__((constructor)) void ReadPlan()
{
  const char* const call = Setting("SKYLINE_FAULT_CALL");
  for (std::size_t kind = 0; kind < Kinds; ++kind)
  {
    if (std::strcmp(call, CallNames[kind]) == 0)
    {
      Plan.What = static_cast<Call>(kind);
    }
  }
  Plan.Number = std::strtoull(Setting("SKYLINE_FAULT_NUMBER"), nullptr, 10);
  Plan.LeastBytes = std::strtoull(Setting("SKYLINE_FAULT_LEAST"), nullptr, 10);
  Plan.Lasting = std::strcmp(Setting("SKYLINE_FAULT_LASTING"), "1") == 0;
  const char* const error = Setting("SKYLINE_FAULT_ERROR");
  Plan.Short = std::strcmp(error, "short") == 0;
  if (std::strncmp(error, "signal ", 7) == 0)
  {
    Plan.Signal = static_cast<int>(std::strtol(error + 7, nullptr, 10));
  }
  else if (const int number = static_cast<int>(std::strtol(error, nullptr, 10)))
  {
    Plan.Error = number;
  }
  if (const char* const counts = Setting("SKYLINE_FAULT_COUNTS"); *counts != '\0')
  {
    ShareCounts(counts);
  }
  Armed = std::strcmp(Setting("SKYLINE_FAULT_ARMED"), "0") != 0;
}

} // namespace

Fault Next(Call call) noexcept
{
  if (!Armed)
  {
    return Fault::None;
  }
  const std::uint64_t number = ++Counts->Calls[static_cast<std::size_t>(call)];
  const bool chosen = call == Plan.What && Plan.Number != 0 &&
    (number == Plan.Number || (Plan.Lasting && number > Plan.Number));
  if (!chosen)
  {
    return Fault::None;
  }
  ++Counts->Failed;
  if (Plan.Signal != 0)
  {
    timespec now;
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    Counts->SentNanoseconds = static_cast<std::uint64_t>(now.tv_sec) * 1000000000u +
      static_cast<std::uint64_t>(now.tv_nsec);
    (void)::syscall(SYS_kill, ::getpid(), Plan.Signal);
    return Fault::None;
  }
  errno = Plan.Error;
  return Plan.Short ? Fault::Short : Fault::Fails;
}

Fault NextAllocation(std::size_t bytes) noexcept
{
  return bytes < Plan.LeastBytes ? Fault::None : Next(Call::Allocate);
}

} // namespace testing
} // namespace skyline

extern "C" __attribute__((visibility("default"))) void SkylineArmFaults()
{
  skyline::testing::Armed = true;
}
