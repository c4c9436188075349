// SPDX-License-Identifier: BSD-3-Clause
// Error against run time as a picture: SVG, written as text, so that a report has its charts on a
// machine without any OpenGL. (VTK's own charts, as SVG too, need a render window with a context.)
#ifndef skyline_Chart_h
#define skyline_Chart_h

#include "Job.h"

#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

struct ChartStyle
{
  double Width = 460.0, Height = 330.0; ///< pixels
  bool Alone = false;                   ///< a file of its own, with a background
  std::string Title;                    ///< above the chart; empty: none
};

/// Both axes logarithmic; every point with its label, the front as a line. Points without error stand
/// on the lower edge. Empty if there is none.
std::string DrawChart(const std::vector<const Finding*>& findings, const ChartStyle& style);

/// The rules that the charts of a page share; a chart alone brings them.
const char* ChartCss();

/// Text for HTML, SVG and XML.
std::string Escaped(const std::string& text);

/// Three digits, "0" for 0, "-" for NaN.
std::string Short(double value);

} // namespace benchmark
} // namespace skyline

#endif
