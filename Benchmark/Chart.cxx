// SPDX-License-Identifier: BSD-3-Clause
#include "Chart.h"

#include "Pareto.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <limits>
#include <map>

namespace skyline
{
namespace benchmark
{

namespace
{

// Colours of Okabe & Ito, which readers with any kind of colour vision can distinguish, and
// different shapes.
struct Mark
{
  const char* Color;
  char Shape; // c circle, s square, t triangle, v triangle down, d diamond, x cross
};

Mark MarkOf(const std::string& kind)
{
  static const std::map<std::string, Mark> marks{ { "exact", { "#0072B2", 'c' } },
    { "fast", { "#56B4E9", 'c' } }, { "sweep", { "#E69F00", 's' } },
    { "pyramid", { "#009E73", 't' } }, { "harmonics", { "#CC79A7", 'd' } },
    { "shadow-height", { "#0072B2", 'd' } }, { "lamp", { "#0072B2", 'c' } },
    { "gpu", { "#888888", 's' } }, { "every", { "#888888", 'x' } },
    { "embree", { "#D55E00", 's' } }, { "grass", { "#D55E00", 't' } },
    { "saga", { "#D55E00", 'd' } }, { "gdaldem", { "#D55E00", 'v' } } };
  const auto mark = marks.find(kind);
  return mark == marks.end() ? Mark{ "#888888", 'c' } : mark->second;
}

std::string Text(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string Text(const char* format, ...)
{
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

std::string Symbol(const Mark& mark, double x, double y)
{
  constexpr double r = 4.5; // pixels
  const auto path = [&](const std::string& steps)
  { return "<path d=\"" + steps + "\" fill=\"" + mark.Color + "\"/>"; };
  switch (mark.Shape)
  {
    case 's':
      return path(Text("M%.1f %.1fh8v8h-8z", x - 4.0, y - 4.0));
    case 't':
      return path(Text("M%.1f %.1fl5.2 9h-10.4z", x, y - 5.5));
    case 'v':
      return path(Text("M%.1f %.1fl5.2 -9h-10.4z", x, y + 5.5));
    case 'd':
      return path(Text("M%.1f %.1fl5.5 5.5l-5.5 5.5l-5.5 -5.5z", x, y - 5.5));
    case 'x':
      return Text("<path d=\"M%.1f %.1fl8 8m0 -8l-8 8\" stroke=\"%s\" stroke-width=\"2\"/>",
        x - 4.0, y - 4.0, mark.Color);
    default:
      return Text("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\"/>", x, y, r, mark.Color);
  }
}

struct Box
{
  double Left, Top, Right, Bottom;

  double Overlap(const Box& other) const
  {
    const double width = std::min(this->Right, other.Right) - std::max(this->Left, other.Left);
    const double height = std::min(this->Bottom, other.Bottom) - std::max(this->Top, other.Top);
    return width > 0.0 && height > 0.0 ? width * height : 0.0;
  }
};

// The number of characters of a UTF-8 text.
double LengthOf(const std::string& text)
{
  return static_cast<double>(
    std::count_if(text.begin(), text.end(), [](char letter) { return (letter & 0xC0) != 0x80; }));
}

// Places labels beside their points, where they overlap least.
class Labels
{
public:
  explicit Labels(const Box& frame)
    : Frame(frame)
  {
  }
  void Avoid(double x, double y)
  {
    constexpr double reach = 5.0;
    this->Taken.push_back({ x - reach, y - reach, x + reach, y + reach });
  }
  Box Place(double x, double y, const std::string& text)
  {
    constexpr double letter = 6.3, height = 12.0; // pixels, for the font below
    const double width = letter * LengthOf(text) + 2.0;
    Box best{};
    double least = std::numeric_limits<double>::infinity();
    for (const double away : { 8.0, 16.0, 26.0, 40.0, 56.0 })
    {
      for (const auto& [right, down] :
        { std::pair(1.0, 0.0), std::pair(-1.0, 0.0), std::pair(0.0, -1.0), std::pair(0.0, 1.0),
          std::pair(0.8, -0.8), std::pair(0.8, 0.8), std::pair(-0.8, -0.8), std::pair(-0.8, 0.8) })
      {
        const double cx = x + right * (away + 0.5 * width);
        const double cy = y + down * (away + 0.3 * height);
        const Box box{ cx - 0.5 * width, cy - 0.5 * height, cx + 0.5 * width, cy + 0.5 * height };
        double cost = 0.8 * away + (right < 0.0 ? 1.0 : 0.0) + (down != 0.0 ? 2.0 : 0.0);
        for (const Box& taken : this->Taken)
        {
          cost += 4.0 * box.Overlap(taken);
        }
        const double outside = std::max(0.0, this->Frame.Left - box.Left) +
          std::max(0.0, box.Right - this->Frame.Right) + std::max(0.0, this->Frame.Top - box.Top) +
          std::max(0.0, box.Bottom - this->Frame.Bottom);
        cost += 200.0 * outside;
        if (cost < least)
        {
          least = cost;
          best = box;
        }
      }
    }
    this->Taken.push_back(best);
    return best;
  }

private:
  Box Frame;
  std::vector<Box> Taken;
};

// A logarithmic axis, which maps values to pixels.
struct Axis
{
  double First, Last; // decades
  double Begin, End;  // pixels
  double operator()(double value) const
  {
    const double place = (std::log10(value) - this->First) / (this->Last - this->First);
    return this->Begin + std::clamp(place, 0.0, 1.0) * (this->End - this->Begin);
  }
};

std::string TickText(double value)
{
  const int decade = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  return decade >= -3 && decade <= 5 ? Text("%.10g", value)
                                     : Text("%s10<tspan dy=\"-4\" font-size=\"8\">%d</tspan>",
                                         value < 1.5 * std::pow(10.0, decade)
                                           ? ""
                                           : Text("%.0f·", value * std::pow(10.0, -decade)).c_str(),
                                         decade);
}

// Powers of ten; on a short axis also their multiples by two and five.
std::vector<double> TicksOf(const Axis& axis)
{
  const bool isShort = axis.Last - axis.First < 2.1; // decades
  std::vector<double> ticks;
  for (int decade = static_cast<int>(std::floor(axis.First)); decade <= axis.Last; ++decade)
  {
    for (const double step : { 1.0, 2.0, 5.0 })
    {
      const double value = step * std::pow(10.0, decade);
      const double place = std::log10(value);
      constexpr double slack = 1e-9;
      if ((step == 1.0 || isShort) && place >= axis.First - slack && place <= axis.Last + slack)
      {
        ticks.push_back(value);
      }
    }
  }
  return ticks;
}

// The decades that the values fill, with half a decade of margin at each end.
void Range(const std::vector<double>& values, double& first, double& last)
{
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  first = std::floor(2.0 * std::log10(*low) - 0.3) / 2.0;
  last = std::ceil(2.0 * std::log10(*high) + 0.3) / 2.0;
}

// Values below this count as no error. Their points stand on the lower edge, at a tenth of the
// smallest error above 0.
constexpr double NoError = 1e-7;

double EdgeOf(const std::vector<const Finding*>& findings)
{
  double least = 1.0;
  for (const Finding* finding : findings)
  {
    const double error = ErrorOf(*finding);
    least = error > NoError ? std::min(least, error) : least;
  }
  return 0.1 * least;
}

// edge: the value at which points without error stand; 0 if there are none.
std::string DrawAxes(const Axis& x, const Axis& y, const Quantity& quantity, double edge)
{
  std::string svg;
  for (const double value : TicksOf(x))
  {
    const double at = x(value);
    svg += Text("<path d=\"M%.1f %.1fV%.1f\" class=\"grid\"/>", at, y.Begin, y.End);
    svg += Text("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">", at, y.Begin + 14.0) +
      TickText(value) + "</text>";
  }
  const auto across = [&](double value, const std::string& text)
  {
    const double at = y(value);
    svg += Text("<path d=\"M%.1f %.1fH%.1f\" class=\"grid\"/>", x.Begin, at, x.End);
    svg += Text("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">", x.Begin - 5.0, at + 4.0) +
      text + "</text>";
  };
  for (const double value : TicksOf(y))
  {
    if (value > 4.0 * edge)
    {
      across(value, TickText(value));
    }
  }
  if (edge > 0.0)
  {
    across(edge, "0");
  }
  svg += Text("<path d=\"M%.1f %.1fV%.1fH%.1f\" class=\"axis\"/>", x.Begin, y.End, y.Begin, x.End);
  svg += Text("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%s</text>",
    0.5 * (x.Begin + x.End), y.Begin + 31.0, Escaped(quantity.Time).c_str());
  const double middle = 0.5 * (y.Begin + y.End);
  svg += Text("<text transform=\"translate(12 %.1f) rotate(-90)\" text-anchor=\"middle\">%s</text>",
    middle, Escaped(quantity.Error).c_str());
  return svg;
}

std::string TipOf(const Finding& finding)
{
  const Quantity& quantity = FindQuantity(finding.What.Quantity);
  return finding.What.Label + " (" + finding.What.Settings + "): " + Short(TimeOf(finding)) + " " +
    quantity.Time + "; " + quantity.Error + " " + Short(ErrorOf(finding));
}

const char* const Style = "svg text{font:11px system-ui,sans-serif;fill:currentColor}"
                          "svg .label{paint-order:stroke;stroke:var(--card,#fff);stroke-width:4px}"
                          "svg .title{font-size:14px;font-weight:600}"
                          ".grid{stroke:currentColor;stroke-opacity:.13;fill:none}"
                          ".axis{stroke:currentColor;stroke-opacity:.6;fill:none}"
                          ".front{stroke:currentColor;stroke-opacity:.45;fill:none;"
                          "stroke-dasharray:4 3}"
                          ".leader{stroke:currentColor;stroke-opacity:.35;fill:none}";

// The opening tag, the title and the ground of the picture.
std::string DrawHead(const std::string& about, const ChartStyle& style, double begin)
{
  std::string svg = Text("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" "
                         "width=\"%.0f\" height=\"%.0f\" role=\"img\" color=\"%s\">",
    style.Width, style.Height, style.Width, style.Height, style.Alone ? "#222" : "currentColor");
  svg += "<title>" + Escaped(about) + "</title>";
  if (style.Alone)
  {
    svg += std::string("<style>") + Style +
      "</style><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>";
  }
  if (!style.Title.empty())
  {
    svg += Text(
      "<text x=\"%.0f\" y=\"18\" class=\"title\">%s</text>", begin, Escaped(style.Title).c_str());
  }
  return svg;
}

// Where findings stand in the picture.
struct ChartPlaces
{
  Axis X, Y;
  double Edge; // errors below are drawn here

  std::pair<double, double> operator()(const Finding& finding) const
  {
    return { this->X(TimeOf(finding)), this->Y(std::max(ErrorOf(finding), this->Edge)) };
  }
};

// The line of the findings that no other one beats.
std::string DrawFront(const std::vector<const Finding*>& findings, const ChartPlaces& at)
{
  std::string line;
  double before = at.Y.End;
  for (const Finding* finding : Front(findings))
  {
    const auto [px, py] = at(*finding);
    line += line.empty() ? Text("M%.1f %.1fV%.1f", px, before, py) : Text("H%.1fV%.1f", px, py);
    before = py;
  }
  return "<path class=\"front\" d=\"" + line + Text("H%.1f", at.X.End) + "\"/>";
}

// Labels of the findings, and over them their symbols.
std::string DrawFindings(
  const std::vector<const Finding*>& findings, const ChartPlaces& at, double top)
{
  Labels labels({ at.X.Begin + 1.0, top, at.X.End + 24.0, at.Y.Begin });
  for (const Finding* finding : findings)
  {
    const auto [px, py] = at(*finding);
    labels.Avoid(px, py);
  }
  std::string texts, symbols;
  for (const Finding* finding : findings)
  {
    const auto [px, py] = at(*finding);
    const std::string text =
      finding->What.Label + (ErrorOf(*finding) < NoError ? " (no error)" : "");
    const Box box = labels.Place(px, py, text);
    const double cx = std::clamp(px, box.Left, box.Right), cy = std::clamp(py, box.Top, box.Bottom);
    if (std::hypot(cx - px, cy - py) > 12.0)
    {
      texts += Text("<path class=\"leader\" d=\"M%.1f %.1fL%.1f %.1f\"/>", px, py, cx, cy);
    }
    // Anchored at the side of the point: fonts differ in width.
    const bool right = box.Left >= px, left = box.Right <= px;
    const double from = right ? box.Left + 1.0
      : left                  ? box.Right - 1.0
                              : 0.5 * (box.Left + box.Right);
    texts += Text("<text class=\"label\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", from,
               box.Bottom - 2.5,
               right    ? "start"
                 : left ? "end"
                        : "middle") +
      Escaped(text) + "</text>";
    symbols += "<g><title>" + Escaped(TipOf(*finding)) + "</title>" +
      Symbol(MarkOf(finding->What.Kind), px, py) + "</g>";
  }
  return texts + symbols;
}

} // namespace

const char* ChartCss()
{
  return Style;
}

std::string Escaped(const std::string& text)
{
  std::string escaped;
  for (const char letter : text)
  {
    switch (letter)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

std::string Short(double value)
{
  if (std::isnan(value))
  {
    return "-";
  }
  // Three digits without an exponent, if that is not longer.
  const double size = std::abs(value);
  if (size == 0.0 || (size >= 1e-4 && size < 1e6))
  {
    const int digits = size == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(size)));
    return Text("%.*f", std::clamp(2 - digits, 0, 6), value == 0.0 ? 0.0 : value);
  }
  return Text("%.2g", value);
}

std::string DrawChart(const std::vector<const Finding*>& findings, const ChartStyle& style)
{
  if (findings.empty())
  {
    return "";
  }
  const Quantity& quantity = FindQuantity(findings.front()->What.Quantity);
  const double edge = EdgeOf(findings);
  std::vector<double> times, errors;
  for (const Finding* finding : findings)
  {
    times.push_back(TimeOf(*finding));
    errors.push_back(std::max(ErrorOf(*finding), edge));
  }
  const double top = style.Title.empty() ? 10.0 : 32.0;
  Axis x{ 0.0, 0.0, 58.0, style.Width - 26.0 }, y{ 0.0, 0.0, style.Height - 42.0, top };
  Range(times, x.First, x.Last);
  Range(errors, y.First, y.Last);

  std::string svg = DrawHead(quantity.Title + ", " + findings.front()->What.Scene, style, x.Begin);
  const bool isZero = std::any_of(findings.begin(), findings.end(),
    [](const Finding* finding) { return ErrorOf(*finding) < NoError; });
  svg += DrawAxes(x, y, quantity, isZero ? edge : 0.0);

  const ChartPlaces at{ x, y, edge };
  return svg + DrawFront(findings, at) + DrawFindings(findings, at, top) + "</svg>";
}

} // namespace benchmark
} // namespace skyline
