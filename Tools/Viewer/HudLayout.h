// SPDX-License-Identifier: BSD-3-Clause
// The layout of the heads-up display, in pixels of the framebuffer with the origin at the lower
// left.
#ifndef skyline_HudLayout_h
#define skyline_HudLayout_h

#include <array>
#include <cstddef>
#include <string>

namespace skyline
{

/// A rectangle. Its width is 0 if there is no room for it.
struct HudBox
{
  double X = 0.0, Y = 0.0, Width = 0.0, Height = 0.0;

  bool Contains(double x, double y) const
  {
    return this->Width > 0.0 && x >= this->X && x <= this->X + this->Width && y >= this->Y &&
      y <= this->Y + this->Height;
  }
};

/// The layout for a framebuffer of width x height pixels, with texts enlarged by `scale` (1 for 96
/// dots per inch). In small windows parts are left out: first the times, then the sliders, then
/// everything.
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
  int FontSize = 0;                    ///< points of VTK's text, at 72 dots per inch
  std::array<HudBox, 2> Sliders{ {} }; ///< areas that react to the mouse
  std::array<HudBox, 2> Tracks{ {} };  ///< the drawn parts
  std::array<double, 2> ArrowCenter{ {} };
  double ArrowRadius = 0.0;
  std::array<double, 2> BarRight{ {} }; ///< lower right corner of the scale bar
  double LongestBar = 0.0;

  /// Returns the position of x on the track of a slider, 0 to 1, clamped.
  double PartAt(std::size_t slider, double x) const;
};

/// The greatest length of 1, 2 or 5 times a power of ten that is at most `longest`; 0 if there is
/// no room.
double RoundLength(double longest);

/// A length in metres as text: 500 m, 2 km, 5 mm.
std::string LengthText(double metres);

} // namespace skyline

#endif
