// SPDX-License-Identifier: BSD-3-Clause
// Which call of the system fails, as the environment says it:
//
//   SKYLINE_FAULT_CALL     a name of CallNames; none: nothing fails, calls are counted
//   SKYLINE_FAULT_NUMBER   which call of all threads, from 1
//   SKYLINE_FAULT_ERROR    the errno; "short": half is read or written; "signal N": the process gets
//                          that signal, and the call is made
//   SKYLINE_FAULT_LASTING  "1": every later call fails too
//   SKYLINE_FAULT_LEAST    bytes; smaller allocations are neither counted nor failed (default 0)
//   SKYLINE_FAULT_COUNTS   a file of FaultCounts in the machine's bytes, which tells how many calls there
//                          were even when the process was killed
//   SKYLINE_FAULT_ARMED    "0": nothing is counted before SkylineArmFaults() is called
#ifndef skyline_FaultPlan_h
#define skyline_FaultPlan_h

#include <cstddef>

namespace skyline
{
namespace testing
{

/// Kinds of calls; several functions of the C library stand behind each.
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
  Fails, ///< errno says with what
  Short
};

/// Counts a call, and says whether it is the one that fails. From any thread.
Fault Next(Call call) noexcept;

/// The same for an allocation of so many bytes.
Fault NextAllocation(std::size_t bytes) noexcept;

} // namespace testing
} // namespace skyline

#endif
