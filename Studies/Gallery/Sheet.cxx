// SPDX-License-Identifier: BSD-3-Clause
#include "Sheet.h"

#include <algorithm>
#include <cmath>

namespace skyline
{
namespace gallery
{

namespace
{

constexpr int Gap = 6;
constexpr int TitleSize = 15;
constexpr int TextSize = 12;
constexpr int TitleHeight = 26;
constexpr int LineHeight = 20;
constexpr int Base = 6; // pixels from the lower edge of a line to its letters

} // namespace

Errors ErrorsOf(const std::vector<float>& found, const std::vector<float>& truth, double unit)
{
  std::vector<double> sizes;
  double squares = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k)
  {
    const double error =
      std::abs(static_cast<double>(found[k]) - static_cast<double>(truth[k])) / unit;
    squares += error * error;
    sizes.push_back(error);
  }
  if (sizes.empty())
  {
    return {};
  }
  std::sort(sizes.begin(), sizes.end());
  const auto count = static_cast<double>(sizes.size());
  return { std::sqrt(squares / count), sizes[static_cast<std::size_t>(0.95 * (count - 1.0))],
    sizes.back() };
}

Picture SheetOf(const Figure& figure)
{
  int width = TextWidth(figure.Title, TitleSize) + 2 * Gap;
  int height = TitleHeight;
  for (const PanelRow& row : figure.Rows)
  {
    int across = Gap;
    int tallest = 0;
    for (const Panel& panel : row.Panels)
    {
      across += panel.Image.Width + Gap;
      tallest = std::max(tallest, panel.Image.Height);
    }
    width = std::max({ width, across, TextWidth(row.Label, TextSize) + 2 * Gap });
    height += LineHeight + tallest + LineHeight;
  }
  Picture sheet(width, height, 255);
  int top = height - TitleHeight;
  WriteText(sheet, figure.Title, Gap, top + Base, TitleSize);
  for (const PanelRow& row : figure.Rows)
  {
    top -= LineHeight;
    WriteText(sheet, row.Label, Gap, top + Base, TextSize);
    int x = Gap;
    int lowest = top;
    for (const Panel& panel : row.Panels)
    {
      const int y = top - panel.Image.Height;
      Paste(sheet, panel.Image, x, y);
      WriteText(sheet, panel.Caption, x, y - LineHeight + Base, TextSize);
      x += panel.Image.Width + Gap;
      lowest = std::min(lowest, y);
    }
    top = lowest - LineHeight;
  }
  return sheet;
}

} // namespace gallery
} // namespace skyline
