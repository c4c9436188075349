// SPDX-License-Identifier: BSD-3-Clause
#include "Exposure.h"

#include <algorithm>

namespace skyline
{

double AdaptedStops(double stops)
{
  return stops - UnadaptedShare * std::max(0.0, stops - FullAdaptation);
}

} // namespace skyline
