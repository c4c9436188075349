// SPDX-License-Identifier: BSD-3-Clause
#include "HudLayout.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{

// Sizes in pixels at scale 1.
constexpr double Margin = 12.0;
constexpr double FontSize = 14.0;
constexpr double SliderHeight = 26.0; // area that reacts to the mouse
constexpr double TrackHeight = 6.0;
constexpr double LabelWidth = 92.0;
constexpr double WidestSlider = 560.0;
constexpr double NarrowestSlider = 120.0;
constexpr double ArrowRadius = 22.0;
constexpr double LongestBar = 160.0;
constexpr double ShortestBar = 40.0;

// The smallest window, at scale 1, that has room for a part.
constexpr double StatusWidth = 300.0, StatusHeight = 160.0;
constexpr double TimesWidth = 560.0, TimesHeight = 300.0;
constexpr double ArrowWidth = 120.0, ArrowHeight = 120.0;

} // namespace

namespace skyline
{

HudLayout::HudLayout(int width, int height, double scale)
  : Width(width)
  , Height(height)
  , Scale(scale)
{
  const double wide = width / scale;
  const double high = height / scale;
  this->Margin = ::Margin * scale;
  this->FontSize = std::max(1, static_cast<int>(std::lround(::FontSize * scale)));
  this->Status = wide >= StatusWidth && high >= StatusHeight;
  this->Times = wide >= TimesWidth && high >= TimesHeight;
  this->Arrow = wide >= ArrowWidth && high >= ArrowHeight;
  this->ArrowRadius = ::ArrowRadius * scale;
  this->ArrowCenter = { { width - this->Margin - this->ArrowRadius,
    height - this->Margin - this->ArrowRadius } };

  const double barRoom = std::min(::LongestBar * scale, 0.25 * width);
  this->Bar = this->Status && barRoom >= ShortestBar * scale;
  this->LongestBar = barRoom;
  this->BarRight = { { width - this->Margin, this->Margin } };

  const double room =
    width - 3.0 * this->Margin - LabelWidth * scale - (this->Bar ? barRoom + this->Margin : 0.0);
  const double length = std::min(WidestSlider * scale, room);
  for (std::size_t k = 0; k < this->Sliders.size() && this->Status; ++k)
  {
    if (length < NarrowestSlider * scale)
    {
      break;
    }
    HudBox& box = this->Sliders[k];
    box.X = this->Margin;
    box.Y = this->Margin + (k == 0 ? SliderHeight * scale : 0.0); // the first is above the second
    box.Width = length;
    box.Height = SliderHeight * scale;
    this->Tracks[k] = { box.X, box.Y + 0.5 * (box.Height - TrackHeight * scale), length,
      TrackHeight * scale };
  }
}

double HudLayout::PartAt(std::size_t slider, double x) const
{
  const HudBox& track = this->Tracks[slider];
  return track.Width > 0.0 ? std::clamp((x - track.X) / track.Width, 0.0, 1.0) : 0.0;
}

double RoundLength(double longest)
{
  if (!(longest > 0.0) || !std::isfinite(longest))
  {
    return 0.0;
  }
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  const double digits = longest / power;
  return power * (digits >= 5.0 ? 5.0 : digits >= 2.0 ? 2.0 : 1.0);
}

std::string LengthText(double metres)
{
  char text[32];
  const bool kilo = metres >= 999.0;
  const bool milli = metres < 0.9;
  std::snprintf(text, sizeof(text), "%g %s",
    metres *
      (kilo       ? 1.0e-3
          : milli ? 1.0e3
                  : 1.0),
    kilo      ? "km"
      : milli ? "mm"
              : "m");
  return text;
}

} // namespace skyline
