// SPDX-License-Identifier: BSD-3-Clause
// Charts of error against run time as SVG text, so that a report has its charts on a machine
// without OpenGL. (VTK's own charts need a render window with a context even for SVG.)
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
  bool Alone = false;                   ///< the chart is a separate file with a background
  std::string Title;                    ///< text above the chart; empty for none
};

/// A chart with two logarithmic axes, a labelled point for each finding, and a line for the front.
/// Points without error stand on the lower edge. Empty if there are no points.
std::string DrawChart(const std::vector<const Finding*>& findings, const ChartStyle& style);

/// The style rules that the charts of a page share. A separate chart contains them itself.
const char* ChartCss();

/// The text with the special characters of HTML, SVG and XML escaped.
std::string Escaped(const std::string& text);

/// Three significant digits; "0" for 0 and "-" for NaN.
std::string Short(double value);

} // namespace benchmark
} // namespace skyline

#endif
