// SPDX-License-Identifier: BSD-3-Clause
// Preloaded into a program (LD_PRELOAD), this library stops it at an invalid operation, an overflow
// or a division by zero, in Skyline or in a library that it uses.
#include "FloatGuard.h"

namespace
{

[[maybe_unused]] const int Before =
  feenableexcept(skyline::testing::FloatGuard::Watched); // threads inherit it

} // namespace
