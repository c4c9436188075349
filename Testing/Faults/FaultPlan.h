// SPDX-License-Identifier: BSD-3-Clause
// Selects the system call that fails, by environment variables:
//
//   SKYLINE_FAULT_CALL     a name of CallNames; without it, calls are counted and none fails
//   SKYLINE_FAULT_NUMBER   the number of the call, over all threads, from 1
//   SKYLINE_FAULT_ERROR    the errno; "short": half of the data is read or written; "signal N": the
//                          process receives this signal, and the call is made
//   SKYLINE_FAULT_LASTING  "1": all later calls fail too
//   SKYLINE_FAULT_LEAST    bytes; smaller allocations are neither counted nor failed (default 0)
//   SKYLINE_FAULT_COUNTS   a binary file of FaultCounts, which holds the number of calls even after
//                          the process was killed
//   SKYLINE_FAULT_ARMED    "0": nothing is counted before SkylineArmFaults() is called
#ifndef skyline_FaultPlan_h
#define skyline_FaultPlan_h

#include <cstddef>

namespace skyline
{
namespace testing
{

/// Types of calls. Each stands for several functions of the C library.
enum class Call
{
  Open,
  Read,
  Write,
  Close,
  Sync,
  Rename,
  Remove,
  Truncate,
  Status,
  Folder,
  Mode,
  Map,
  Thread,
  Allocate,
  Count
};

inline constexpr const char* CallNames[] = { "open", "read", "write", "close", "sync", "rename",
  "remove", "truncate", "status", "folder", "mode", "map", "thread", "allocate" };
static_assert(sizeof(CallNames) / sizeof(*CallNames) == static_cast<std::size_t>(Call::Count), "");

enum class Fault
{
  None,
  Fails, ///< with the errno that the environment sets
  Short
};

/// Counts a call, and returns whether it must fail. Thread-safe.
Fault Next(Call call) noexcept;

/// The same for an allocation of the given number of bytes.
Fault NextAllocation(std::size_t bytes) noexcept;

} // namespace testing
} // namespace skyline

#endif
