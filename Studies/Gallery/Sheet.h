// SPDX-License-Identifier: BSD-3-Clause
// A figure: rows of pictures with captions, and their errors.
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

/// Differences of irradiance in units of the open light: root mean square, 95th percentile, and
/// maximum.
struct Errors
{
  double Rms = 0.0, Most = 0.0, Largest = 0.0;
};

/// The errors of found - truth, both in units of `unit`.
Errors ErrorsOf(
  const std::vector<float>& found, const std::vector<float>& truth, double unit = 1.0);

/// One line of a figure's table.
struct Measurement
{
  std::string Setting; ///< e.g. "k = 2"
  std::string Against; ///< e.g. "direct"
  Errors Error;
};

/// A number that is not an error, for instance the sharpness of a shadow.
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
  std::string Label; ///< description of the row, written above it
  std::vector<Panel> Panels;
};

struct Figure
{
  std::string Title;
  std::vector<PanelRow> Rows;
  std::vector<Measurement> Table;
  std::vector<Number> Numbers;
};

/// The whole figure on one white sheet.
Picture SheetOf(const Figure& figure);

/// The size at which a figure is made.
struct Scale
{
  bool Quick = false; ///< for tests: fields with a quarter of the posts per side, small pictures
  int Posts(int full) const { return this->Quick ? full / 4 : full; }
  int Pixels(int full) const { return this->Quick ? full / 3 : full; }
};

class Studio;

struct FigureMaker
{
  std::string Name; ///< name of the figure; its file has the extension .png
  std::function<Figure(Studio&, const Scale&)> Make;
};

/// Figures 3, 4, 6, 9 and 10 of SN08.
std::vector<FigureMaker> KeyFigures();

/// Figures 6.1 to 6.5 of THESIS.
std::vector<FigureMaker> LampFigures();

/// The figures of SHM with houses and an aircraft in the shadow of the terrain, and figure 8 of
/// TW10.
std::vector<FigureMaker> ShadowFigures();

} // namespace gallery
} // namespace skyline

#endif
