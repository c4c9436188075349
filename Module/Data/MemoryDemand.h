// SPDX-License-Identifier: BSD-3-Clause
// Refuses a computation that does not fit into memory before it starts.
#ifndef skyline_MemoryDemand_h
#define skyline_MemoryDemand_h

#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <string>

namespace skyline
{

/// Advice in messages about a lack of memory.
constexpr const char* MemoryAdvice =
  "ask for less at a time, cut the raster (gdal_translate -srcwin) or make it coarser (-tr)";

/// Bytes of memory and swap that this process can still allocate: the least of the free memory of
/// the machine (Linux: MemAvailable and SwapFree), what remains in its control groups (the limit of
/// a container, versions 1 and 2), and what remains of its address space (ulimit -v). Infinite if
/// the system does not report it. root: folder to use instead of / for the files of the system, for
/// tests.
SKYLINECORE_EXPORT double FreeMemory(const std::string& root = "");

/// Throws std::runtime_error, which names the bytes and the advice, if columns * rows posts need
/// more than `free` bytes. what: the subject of the message, in the plural; bytes: per post.
SKYLINECORE_EXPORT void DemandMemory(
  const std::string& what, std::ptrdiff_t columns, std::ptrdiff_t rows, double bytes, double free);

/// The same with the memory that is free now. Demands below some hundred megabytes are not checked.
SKYLINECORE_EXPORT void DemandMemory(
  const std::string& what, std::ptrdiff_t columns, std::ptrdiff_t rows, double bytes);

} // namespace skyline

#endif
