// SPDX-License-Identifier: BSD-3-Clause
// Measures suns and lamps with rays cast at a mesh by Intel Embree on one thread, for comparison.
#ifndef skyline_EmbreeLight_h
#define skyline_EmbreeLight_h

#include "ReferenceScene.h"
#include "Result.h"
#include "SunScore.h"

namespace skyline
{
namespace benchmark
{

/// One occlusion ray per post and sun, for all posts. Throws std::runtime_error without Embree.
Result MeasureEmbreeSun(ReferenceScene& reference, SunScore::Kind kind);

/// side x side rays per post, one at random in each of as many equal cells of the lamp's disc, for
/// the posts of the reference.
Result MeasureEmbreeLamp(ReferenceScene& reference, int side);

} // namespace benchmark
} // namespace skyline

#endif
