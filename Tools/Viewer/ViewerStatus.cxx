// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerStatus.h"

#include <cstdio>
#include <filesystem>
#include <sstream>

namespace
{

template <typename... Numbers>
std::string Format(const char* format, Numbers... numbers)
{
  char text[160];
  std::snprintf(text, sizeof(text), format, numbers...);
  return text;
}

} // namespace

namespace skyline
{

std::string NameOf(const std::string& file)
{
  return std::filesystem::path(file).filename().string();
}

std::string StatusText(
  const std::string& terrain, const ViewerState& state, const SunLight& sun, bool exact)
{
  std::ostringstream text;
  text << NameOf(terrain) << (exact ? "" : "  (preview)") << "\n";
  text << Format("sun      %s%05.1f\xc2\xb0  elevation %.1f\xc2\xb0", sun.TrueNorth ? "" : "grid ",
            sun.TrueNorth ? sun.TrueAzimuth : sun.GridAzimuth, sun.ApparentElevation)
       << (state.Sun ? "" : "  off") << "\n";
  if (state.ByTime)
  {
    text << "local    " << state.Clock.LocalDate() << " " << state.Clock.LocalClock() << " "
         << state.Clock.ZoneName() << "\n"
         << "UTC      " << state.Clock.UtcText() << "\n";
  }
  text << "sky      " << NameOf(state.GetSky().Text);
  if (state.Rotation != 0.0)
  {
    text << Format("  turned %.0f\xc2\xb0", state.Rotation);
  }
  text << Format("\nexposure %s %+.1f stops", state.AutoExposure ? "auto" : "fixed", state.Stops());
  if (!state.Lamps.empty())
  {
    text << "\nlamps    " << state.Lamps.size();
    if (state.HasChosen())
    {
      const ViewerLamp& lamp = state.Lamps[state.Chosen];
      text << Format("; chosen: radius %.3g m, %.3g m up", lamp.Radius, lamp.Height);
    }
  }
  if (state.Exaggeration != 1.0)
  {
    text << Format("\nheights  x %.3g", state.Exaggeration);
  }
  return text.str();
}

std::string TimesText(const PassTimes& times)
{
  if (times.empty())
  {
    return "";
  }
  std::ostringstream text;
  double sum = 0.0;
  for (const auto& [name, seconds] : times)
  {
    text << Format("%s %6.1f ms\n", name.c_str(), 1000.0 * seconds);
    sum += seconds;
  }
  text << Format("frame %6.1f ms", 1000.0 * sum);
  return text.str();
}

} // namespace skyline
