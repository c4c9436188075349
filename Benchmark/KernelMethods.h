// SPDX-License-Identifier: BSD-3-Clause
// Measures whatever speaks HorizonMethod, and the sky view fused with it.
#ifndef skyline_KernelMethods_h
#define skyline_KernelMethods_h

#include "Horizon/HorizonMethod.h"
#include "Result.h"
#include "Truth.h"

#include <functional>
#include <memory>

namespace skyline
{
namespace benchmark
{

using MakeMethod = std::function<std::unique_ptr<HorizonMethod>(const HeightField&)>;

/// Azimuths that a slow method is timed in: every `thin`-th, at another place in each stride so
/// that the axes do not get more than their share. Indices; 1 gives all.
std::vector<std::size_t> ThinnedAzimuths(std::size_t count, std::size_t thin);

/// Errors, times and memory of one method; it runs in all azimuths of the truth or a part of them.
/// No repeat begins after `seconds`.
Result MeasureKernel(const Scene& scene, const Truth& truth, const MakeMethod& make, int repeats,
  std::size_t thin = 1, double seconds = 1e9);

} // namespace benchmark
} // namespace skyline

#endif
