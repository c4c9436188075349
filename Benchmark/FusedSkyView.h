// SPDX-License-Identifier: BSD-3-Clause
// Measures horizons and all four sky quantities in one pass, as the sky view filter computes them.
#ifndef skyline_FusedSkyView_h
#define skyline_FusedSkyView_h

#include "ReferenceHorizons.h"
#include "Result.h"

namespace skyline
{
namespace benchmark
{

/// Sums exact horizons, azimuth by azimuth, into the four quantities. The time covers everything
/// from the image to the filled arrays (including heights, gradients and the transposed copy), on
/// one thread.
Result MeasureFusedSkyView(const Scene& scene, const ReferenceHorizons& truth, int repeats);

} // namespace benchmark
} // namespace skyline

#endif
