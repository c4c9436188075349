// SPDX-License-Identifier: BSD-3-Clause
// A figure: rows of captioned pictures, and the errors that belong to them.
#ifndef skyline_Sheet_h
#define skyline_Sheet_h

#include "Picture.h"

#include <functional>
#include <string>
#include <vector>

namespace skyline
{
namespace gallery
{

/// Differences of irradiance in units of the open light: root of the mean square, what 95 % of the
/// posts stay below, the largest.
struct Errors
{
  double Rms = 0.0, Most = 0.0, Largest = 0.0;
};

/// Of found - truth, both as multiples of `unit`.
Errors ErrorsOf(
  const std::vector<float>& found, const std::vector<float>& truth, double unit = 1.0);

/// One line of a figure's table.
struct Measurement
{
  std::string Setting; ///< e.g. "k = 2"
  std::string Against; ///< e.g. "direct"
  Errors Error;
};

/// A number that is no error, e.g. how sharp a shadow is.
struct Number
{
  std::string Setting;
  std::string What;
  double Value = 0.0;
};

struct Panel
{
  std::string Caption;
  Picture Image;
};

struct PanelRow
{
  std::string Label; ///< what the row shows, written above it
  std::vector<Panel> Panels;
};

struct Figure
{
  std::string Title;
  std::vector<PanelRow> Rows;
  std::vector<Measurement> Table;
  std::vector<Number> Numbers;
};

/// All of a figure on one white sheet.
Picture SheetOf(const Figure& figure);

/// How large to make a figure.
struct Scale
{
  bool Quick = false; ///< fields of a quarter of the posts' side, small pictures: for tests
  int Posts(int full) const { return this->Quick ? full / 4 : full; }
  int Pixels(int full) const { return this->Quick ? full / 3 : full; }
};

class Studio;

struct FigureMaker
{
  std::string Name; ///< of the figure and, with .png, of its file
  std::function<Figure(Studio&, const Scale&)> Make;
};

/// SN08's figures 3, 4, 6, 9 and 10.
std::vector<FigureMaker> KeyFigures();

/// THESIS's figures 6.1 to 6.5.
std::vector<FigureMaker> LampFigures();

/// SHM's figures of houses and of an aircraft in the shadow of the terrain, and TW10's figure 8.
std::vector<FigureMaker> ShadowFigures();

} // namespace gallery
} // namespace skyline

#endif
