// SPDX-License-Identifier: BSD-3-Clause
// Measures any HorizonMethod.
#ifndef skyline_KernelMethods_h
#define skyline_KernelMethods_h

#include "Horizon/HorizonMethod.h"
#include "ReferenceHorizons.h"
#include "Result.h"

#include <functional>
#include <memory>

namespace skyline
{
namespace benchmark
{

using MakeMethod = std::function<std::unique_ptr<HorizonMethod>(const HeightField&)>;

/// Indices of the azimuths in which a slow method is timed: one in each group of `thin`, at a
/// different place in each group, so that the axes are not over-represented. With 1, all azimuths.
std::vector<std::size_t> ThinnedAzimuths(std::size_t count, std::size_t thin);

/// Errors, times and memory of one method, which runs in all azimuths of the reference or in a part
/// of them. No repeat begins after `seconds`.
Result MeasureKernel(const Scene& scene, const ReferenceHorizons& truth, const MakeMethod& make,
  int repeats, std::size_t thin = 1, double seconds = 1e9);

} // namespace benchmark
} // namespace skyline

#endif
