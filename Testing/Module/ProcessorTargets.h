// SPDX-License-Identifier: BSD-3-Clause
// Runs a test with each instruction set that this processor has and that the kernels were compiled
// for.
#ifndef skyline_ProcessorTargets_h
#define skyline_ProcessorTargets_h

#include <gtest/gtest.h>

#include <hwy/highway.h>

#include <cstdint>

namespace skyline
{
namespace testing
{

/// Calls body() once per instruction set, whose name is added to failure messages. Afterwards the
/// best one is active.
template <class Body>
void ForEachProcessorTarget(const Body& body)
{
  const auto restore = []()
  {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  };
  restore();
  const auto all =
    static_cast<std::uint64_t>(hwy::SupportedTargets()) & static_cast<std::uint64_t>(HWY_TARGETS);
  for (std::uint64_t left = all; left != 0; left &= left - 1)
  {
    const auto target = static_cast<std::int64_t>(left & (~left + 1));
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    body();
  }
  restore();
}

} // namespace testing
} // namespace skyline

#endif
