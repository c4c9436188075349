// SPDX-License-Identifier: BSD-3-Clause
// Refuses, before any work, what the machine's memory cannot hold.
#ifndef skyline_MemoryDemand_h
#define skyline_MemoryDemand_h

#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <string>

namespace skyline
{

/// What to do where memory is short.
constexpr const char* MemoryCure =
  "ask for less at a time, cut the raster (gdal_translate -srcwin) or make it coarser (-tr)";

/// Bytes of memory and swap that this program may still take: the least of what the machine has free
/// (Linux's MemAvailable and SwapFree), what the control groups leave that it runs in (a container's
/// limit, versions 1 and 2), and its own limit of addresses (ulimit -v). Infinite where the system does
/// not tell. root: a folder that stands in place of / for the files of the system, for tests.
SKYLINECORE_EXPORT double FreeMemory(const std::string& root = "");

/// std::runtime_error that names the bytes and the cure if columns * rows posts take more than `free`.
/// what: the subject of the sentence, in the plural; bytes: of a post.
SKYLINECORE_EXPORT void DemandMemory(
  const std::string& what, std::ptrdiff_t columns, std::ptrdiff_t rows, double bytes, double free);

/// The same with the memory that is free now. Some hundred megabytes are not worth asking for.
SKYLINECORE_EXPORT void DemandMemory(
  const std::string& what, std::ptrdiff_t columns, std::ptrdiff_t rows, double bytes);

} // namespace skyline

#endif
