// SPDX-License-Identifier: BSD-3-Clause
// The state in words, for the heads-up display.
#ifndef skyline_ViewerStatus_h
#define skyline_ViewerStatus_h

#include "LitTerrain.h"
#include "SunLight.h"
#include "ViewerState.h"

#include <string>

namespace skyline
{

/// The file's name without its folders.
std::string NameOf(const std::string& file);

/// Sun, time, sky, exposure, and lamps and heights where there is something to say.
std::string StatusText(
  const std::string& terrain, const ViewerState& state, const SunLight& sun, bool exact);

/// A line a pass, and their sum.
std::string TimesText(const PassTimes& times);

} // namespace skyline

#endif
