// SPDX-License-Identifier: BSD-3-Clause
// Where the heads-up display has its parts: pixels of the framebuffer, origin lower left.
#ifndef skyline_HudLayout_h
#define skyline_HudLayout_h

#include <array>
#include <cstddef>
#include <string>

namespace skyline
{

/// A rectangle; of no width where there is no room for it.
struct HudBox
{
  double X = 0.0, Y = 0.0, Width = 0.0, Height = 0.0;

  bool Contains(double x, double y) const
  {
    return this->Width > 0.0 && x >= this->X && x <= this->X + this->Width && y >= this->Y &&
      y <= this->Y + this->Height;
  }
};

/// The layout for a framebuffer of width x height pixels whose texts are enlarged by `scale` (1: 96
/// dots an inch). In small windows parts are left out: first the times, then the sliders, then all.
struct HudLayout
{
  HudLayout() = default;
  HudLayout(int width, int height, double scale);

  int Width = 0, Height = 0; ///< of the framebuffer
  double Scale = 1.0;
  bool Status = false; ///< the lines at the upper left
  bool Times = false;  ///< the lines at the upper right
  bool Arrow = false;
  bool Bar = false;
  double Margin = 0.0;
  int FontSize = 0;                    ///< points of VTK's text, at 72 dots an inch
  std::array<HudBox, 2> Sliders{ {} }; ///< where the mouse takes them
  std::array<HudBox, 2> Tracks{ {} };  ///< what is drawn of them
  std::array<double, 2> ArrowCenter{ {} };
  double ArrowRadius = 0.0;
  std::array<double, 2> BarRight{ {} }; ///< the scale bar's lower right corner
  double LongestBar = 0.0;

  /// The part, 0 to 1, of a slider's track at x, clamped.
  double PartAt(std::size_t slider, double x) const;
};

/// The longest length of 1, 2 or 5 times a power of ten that fits; 0 for no room.
double RoundLength(double longest);

/// A length in metres as people write it: 500 m, 2 km, 5 mm.
std::string LengthText(double metres);

} // namespace skyline

#endif
