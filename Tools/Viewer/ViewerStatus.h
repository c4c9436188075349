// SPDX-License-Identifier: BSD-3-Clause
// The state as text, for the heads-up display.
#ifndef skyline_ViewerStatus_h
#define skyline_ViewerStatus_h

#include "LitTerrain.h"
#include "SunLight.h"
#include "ViewerState.h"

#include <string>

namespace skyline
{

/// The name of the file without its folders.
std::string NameOf(const std::string& file);

/// Sun, time, sky and exposure; also lamps and exaggeration if there are any.
std::string StatusText(
  const std::string& terrain, const ViewerState& state, const SunLight& sun, bool exact);

/// One line per pass, and their sum.
std::string TimesText(const PassTimes& times);

} // namespace skyline

#endif
