// SPDX-License-Identifier: BSD-3-Clause
// Refuses, before any work, what the machine's memory cannot hold.
#ifndef skyline_MemoryDemand_h
#define skyline_MemoryDemand_h

#include <cstddef>
#include <string>

namespace skyline
{

/// Bytes of memory and swap that programs may still take; infinite where the system does not tell
/// (it is Linux's MemAvailable, of the machine: limits of a container are not looked at).
double FreeMemory();

/// std::runtime_error that names the bytes and the cure if columns * rows posts take more than `free`.
/// what: the subject of the sentence, in the plural; bytes: of a post.
void DemandMemory(
  const std::string& what, std::ptrdiff_t columns, std::ptrdiff_t rows, double bytes, double free);

/// The same with the memory that is free now. Some hundred megabytes are not worth asking for.
void DemandMemory(
  const std::string& what, std::ptrdiff_t columns, std::ptrdiff_t rows, double bytes);

} // namespace skyline

#endif
