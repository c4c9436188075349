// SPDX-License-Identifier: BSD-3-Clause
// The peer for suns and lamps: rays cast at a mesh with Intel Embree, one thread.
#ifndef skyline_EmbreeLight_h
#define skyline_EmbreeLight_h

#include "Result.h"
#include "Stage.h"
#include "SunScore.h"

namespace skyline
{
namespace benchmark
{

/// One occlusion ray a post and sun, for all posts. std::runtime_error where Embree is not built in.
Result MeasureEmbreeSun(Stage& stage, SunScore::Kind kind);

/// side x side rays a post into even cells of the lamp's disc, one at random in each, for the posts of
/// the truth.
Result MeasureEmbreeLamp(Stage& stage, int side);

} // namespace benchmark
} // namespace skyline

#endif
