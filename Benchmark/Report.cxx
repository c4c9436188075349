// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "Chart.h"
#include "Figures.h"
#include "Pareto.h"
#include "ReportMissing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace skyline
{
namespace benchmark
{

namespace
{

const char* const PageStyle = R"(
:root{color-scheme:light dark;--back:#fff;--text:#1c1e21;--soft:#5b6168;--line:#d9dce0;--card:#f7f8f9}
@media(prefers-color-scheme:dark){:root{--back:#16181b;--text:#e6e8ea;--soft:#a0a6ad;--line:#34383d;--card:#1e2125}}
body{margin:0 auto;max-width:1160px;padding:24px 20px 60px;background:var(--back);color:var(--text);font:15px/1.5 system-ui,sans-serif}
h1{font-size:26px;margin:0 0 4px}h2{font-size:20px;margin:40px 0 6px;border-top:1px solid var(--line);padding-top:22px}
p{max-width:76ch;margin:8px 0}.soft{color:var(--soft)}code{font-size:13px}
.charts{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,460px),1fr));gap:14px;margin:14px 0}
figure{margin:0;background:var(--card);border:1px solid var(--line);border-radius:8px;padding:10px}
figure svg{width:100%;height:auto;display:block}figcaption{font-weight:600}figcaption span{font-weight:400;color:var(--soft);font-size:13px;display:block}
.wide{overflow-x:auto}table{border-collapse:collapse;font-size:13px;font-variant-numeric:tabular-nums}
th,td{padding:3px 9px;text-align:right;border-bottom:1px solid var(--line);white-space:nowrap}th{color:var(--soft);font-weight:500;vertical-align:bottom;white-space:normal}
td.w,th.w{text-align:left}td.wrap{white-space:normal;min-width:34ch}summary{cursor:pointer;color:var(--soft);margin:8px 0}li{margin:3px 0;max-width:80ch}
)";

std::string DescriptionOf(const Session& session, const std::string& scene)
{
  const auto found = std::find_if(session.Scenes.begin(), session.Scenes.end(),
    [&](const auto& entry) { return entry.first == scene; });
  return found == session.Scenes.end() ? "" : found->second;
}

// The scenes on which a quantity was measured, in order.
std::vector<std::string> ScenesOf(const Session& session, const std::string& quantity)
{
  std::vector<std::string> scenes;
  for (const auto& [scene, description] : session.Scenes)
  {
    const std::string& name = scene;
    if (std::any_of(session.Findings.begin(), session.Findings.end(),
          [&](const Finding& f) { return f.What.Quantity == quantity && f.What.Scene == name; }))
    {
      scenes.push_back(name);
    }
  }
  return scenes;
}

void WriteCharts(std::ostream& out, const Session& session, const Quantity& quantity)
{
  std::string figures, alone;
  for (const std::string& scene : ScenesOf(session, quantity.Name))
  {
    const std::vector<const Finding*> points = ChartOf(session.Findings, quantity.Name, scene);
    if (points.size() == 1) // nothing to compare with
    {
      alone += (alone.empty() ? "" : "; ") + scene + ": " + points.front()->What.Label;
    }
    else if (!points.empty())
    {
      figures += "<figure><figcaption>" + Escaped(scene) + "<span>" +
        Escaped(DescriptionOf(session, scene)) + "</span></figcaption>" +
        DrawChart(points, ChartStyle()) + "</figure>\n";
    }
  }
  if (!figures.empty())
  {
    out << "<div class=\"charts\">\n" << figures << "</div>\n";
  }
  if (!alone.empty())
  {
    out << "<p class=\"soft\">Only one method was measured (see the table) on " << Escaped(alone)
        << ".</p>\n";
  }
}

// Writes how much faster several threads are than one.
void WriteSpeedUp(std::ostream& out, const Session& session)
{
  for (const Finding& one : session.Findings)
  {
    for (const Finding& many : session.Findings)
    {
      const bool comparable = one.What.Quantity == "threads" && many.What.Quantity == "threads" &&
        one.What.Scene == many.What.Scene && one.Found.Ran && many.Found.Ran;
      if (comparable && one.Found.Threads == 1.0 && many.Found.Threads > 1.0)
      {
        out << "<p>" << Escaped(many.What.Scene) << ": " << Escaped(many.What.Label) << " are "
            << Short(TimeOf(one) / TimeOf(many)) << " times as fast as one.</p>\n";
      }
    }
  }
}

void WriteTable(std::ostream& out, const Session& session, const Quantity& quantity, bool open)
{
  std::vector<const Finding*> rows;
  for (const std::string& scene : ScenesOf(session, quantity.Name))
  {
    for (const Finding& finding : session.Findings)
    {
      if (finding.What.Quantity == quantity.Name && finding.What.Scene == scene &&
        finding.Found.Ran)
      {
        rows.push_back(&finding);
      }
    }
  }
  if (rows.empty())
  {
    return;
  }
  std::vector<const Figure*> columns;
  for (const Figure& figure : Figures())
  {
    if (figure.Head &&
      std::any_of(rows.begin(), rows.end(),
        [&](const Finding* row) { return std::isfinite(figure.Value(row->Found)); }))
    {
      columns.push_back(&figure);
    }
  }
  out << "<details" << (open ? " open" : "") << "><summary>All figures: " << rows.size()
      << (rows.size() == 1 ? " measurement" : " measurements") << ", times in "
      << Escaped(quantity.Time) << "</summary><div class=\"wide\">"
      << "<table><tr><th class=\"w\">scene</th><th class=\"w\">method</th>"
      << "<th class=\"w\">settings</th>";
  for (const Figure* column : columns)
  {
    out << "<th>" << Escaped(column->Head) << "</th>";
  }
  out << "<th class=\"w\">note</th></tr>\n";
  for (const Finding* row : rows)
  {
    out << "<tr><td class=\"w\">" << Escaped(row->What.Scene) << "</td><td class=\"w\">"
        << Escaped(row->What.Label) << "</td><td class=\"w\">" << Escaped(row->What.Settings)
        << "</td>";
    for (const Figure* column : columns)
    {
      out << "<td>" << Short(column->Value(row->Found)) << "</td>";
    }
    out << "<td class=\"w\">" << Escaped(row->Found.Reason) << "</td></tr>\n";
  }
  out << "</table></div></details>\n";
}

// Explains why a published method is fast in the cases in which it is faster than ours.
const char* WhyQuick(const std::string& kind)
{
  return kind == "sweep"
    ? "a sweep visits each edge once, whatever the terrain, while the search visits more edges if many "
      "of them have similar slopes"
    : "the pyramid reads a fixed number of smoothed heights, whatever the terrain";
}

void WriteExceptions(std::ostream& out, const Session& session, const Quantity& quantity)
{
  const std::size_t compared = ComparedWithPapers(session.Findings, quantity.Name);
  if (compared == 0)
  {
    return;
  }
  std::vector<Exception> exceptions;
  for (const Exception& exception : Exceptions(session.Findings))
  {
    if (exception.Paper->What.Quantity == quantity.Name)
    {
      exceptions.push_back(exception);
    }
  }
  if (exceptions.empty())
  {
    out
      << "<p><b>Exact or fast beats sweep and pyramid everywhere here</b>: each of the " << compared
      << " points of these has one of ours that takes no more time and has no greater error.</p>\n";
    return;
  }
  out << "<p>Exact or fast beats sweep and pyramid in " << compared - exceptions.size() << " of "
      << compared << " points. The exceptions are:</p><ul>\n";
  for (const Exception& exception : exceptions)
  {
    const Finding& paper = *exception.Paper;
    out << "<li>" << Escaped(paper.What.Scene) << ", " << Escaped(paper.What.Label) << ": "
        << Short(TimeOf(paper)) << " ns, error " << Short(ErrorOf(paper));
    if (exception.Nearest)
    {
      const Finding& ours = *exception.Nearest;
      out << ". The fastest of ours with no greater error, " << Escaped(ours.What.Label)
          << ", takes " << Short(TimeOf(ours)) << " ns and has the error " << Short(ErrorOf(ours))
          << ": "
          << (exception.Tie ? "a tie, because its fastest run was no slower"
                            : WhyQuick(paper.What.Kind));
    }
    else if (exception.Alike)
    {
      out << ". Exact with the same settings has the error " << Short(ErrorOf(*exception.Alike))
          << ": most of both errors comes from between the azimuths, and differs by chance";
    }
    else
    {
      out << ". None of ours that ran has as small an error";
    }
    out << ".</li>\n";
  }
  out << "</ul>\n";
}

// The summary counts the measurements of all charts.
void WriteVerdict(std::ostream& out, const Session& session)
{
  std::size_t compared = 0;
  for (const Quantity& quantity : Quantities())
  {
    compared += ComparedWithPapers(session.Findings, quantity.Name);
  }
  const std::size_t exceptions = Exceptions(session.Findings).size();
  if (compared > 0)
  {
    out
      << "<p>Exact or fast beats " << compared - exceptions << " of the " << compared
      << " measurements of sweep and pyramid: it takes no more time there and has no greater error. "
      << (exceptions > 0 ? "The others are listed above their charts, each with its reason." : "")
      << "</p>\n";
  }
}

void WriteSummary(std::ostream& out, const Session& session)
{
  const std::vector<Ratio> ratios = Ratios(session.Findings);
  if (ratios.empty())
  {
    return;
  }
  out << "<h2>Summary</h2>\n";
  WriteVerdict(out, session);
  out << "<div class=\"wide\"><table><tr><th class=\"w\">times faster, CPU</th>";
  std::vector<std::string> scenes, names;
  std::map<std::pair<std::string, std::string>, double> times;
  for (const Ratio& ratio : ratios)
  {
    const auto add = [](std::vector<std::string>& list, const std::string& name)
    {
      if (std::find(list.begin(), list.end(), name) == list.end())
      {
        list.push_back(name);
      }
    };
    add(scenes, ratio.Scene);
    add(names, ratio.Name);
    times[{ ratio.Name, ratio.Scene }] = ratio.Times;
  }
  for (const std::string& scene : scenes)
  {
    out << "<th>" << Escaped(scene) << "</th>";
  }
  out << "</tr>\n";
  for (const std::string& name : names)
  {
    out << "<tr><td class=\"w\">" << Escaped(name) << "</td>";
    for (const std::string& scene : scenes)
    {
      const auto found = times.find({ name, scene });
      out << "<td>" << Short(found == times.end() ? NotMeasured : found->second) << "</td>";
    }
    out << "</tr>\n";
  }
  out << "</table></div>\n";
}

const char* Explanation(const std::string& quantity)
{
  static const std::map<std::string, const char*> texts{
    { "horizon",
      "The horizon of a post in an azimuth, compared with a search of each crossed edge in double "
      "precision. The dashed line is the front: no measured method is both faster and more exact "
      "than a point on it." },
    { "sky",
      "Compared with 360 exact horizons per post. The number in a label is that of azimuths (of "
      "SAGA: sectors). A small number of azimuths limits all methods alike, so that the error of the "
      "horizons shows only if there are many." },
    { "irradiance",
      "Compared with each column of the light map above 360 exact horizons. SH: spherical harmonics "
      "with that number of bands, which blur light, but allow another light at once. The others are "
      "light tables with that number of azimuths." },
    { "sun",
      "Three suns, 10 to 35 degrees high, above a square in the middle of the scene. Posts on the "
      "wrong side are lit but dark in the reference, or the reverse. SSIM, in the table, compares the "
      "shaded pictures." },
    { "beam",
      "The same suns and square: the cosine of the angle of incidence where the sun is visible, "
      "without an atmosphere. GRASS r.sun runs with linke_value=0, also without an atmosphere, and "
      "with our slopes. SAGA and gdaldem compute theirs from the same differences. gdaldem casts no "
      "shadows." },
    { "lamp",
      "A ball above the middle of the scene, compared with 1024 rays per post at the triangles, in "
      "double precision. Embree casts the number of rays in its label, which are not those of the "
      "reference, and is timed for the compared posts only." },
    { "frame",
      "Each frame has new heights and uses nothing of the previous one; \"new light alone\" in the "
      "table is the same frame after a change of the light only." },
    { "threads",
      "The same work with more threads. Wall time depends on other work on the machine." }
  };
  const auto text = texts.find(quantity);
  return text == texts.end() ? "" : text->second;
}

} // namespace

std::string ReportPicture(const Session& session)
{
  const std::vector<std::string> scenes = ScenesOf(session, "horizon");
  if (scenes.empty())
  {
    return "";
  }
  const bool hills = std::find(scenes.begin(), scenes.end(), "hills") != scenes.end();
  const std::string scene = hills ? "hills" : scenes.front();
  ChartStyle style;
  style.Width = 760.0;
  style.Height = 460.0;
  style.Alone = true;
  style.Title = "Horizons on the scene " + scene + ": error against run time";
  return DrawChart(ChartOf(session.Findings, "horizon", scene), style);
}

std::string ReportPage(const Session& session, const ReportOrigin& origin)
{
  std::ostringstream out;
  out << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      << "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">"
      << "<title>Skyline: error against run time</title><style>" << PageStyle << ChartCss()
      << "</style></head><body>\n<h1>Error against run time</h1>\n<p class=\"soft\">"
      << Escaped(origin.Program) << ", made by <code>" << Escaped(origin.Command) << "</code> in "
      << Short(session.Seconds) << " s. Every figure on this page was measured in that run.</p>\n"
      << "<div class=\"wide\"><table>\n";
  for (const auto& [name, value] : session.Machine)
  {
    out << "<tr><th class=\"w\">" << Escaped(name) << "</th><td class=\"w\">" << Escaped(value)
        << "</td></tr>\n";
  }
  out << "</table></div>\n";
  WriteHowMuch(out, session);
  WriteSummary(out, session);
  for (const Quantity& quantity : Quantities())
  {
    if (ScenesOf(session, quantity.Name).empty())
    {
      continue;
    }
    out << "<h2>" << Escaped(quantity.Title) << "</h2>\n<p>" << Explanation(quantity.Name)
        << "</p>\n";
    WriteExceptions(out, session, quantity);
    WriteCharts(out, session, quantity);
    if (quantity.Name == "threads")
    {
      WriteSpeedUp(out, session);
    }
    WriteTable(out, session, quantity, quantity.Name == "threads");
  }
  WriteNotMeasured(out, session);
  out
    << "<h2>How it was measured</h2>\n<ul>\n"
       "<li>Each measurement runs in a separate process. Times are CPU time of one thread and the "
       "median of the runs; the first run includes cold caches. Times of the graphics processor and "
       "of several threads are wall time. Times of other programs include their start and their "
       "files.</li>\n"
       "<li>An error is the result minus the reference value. 99.9 % of the absolute errors are no "
       "greater than the value in that column. The posts are drawn at random from those with a cell "
       "on all four sides. Each scene is flat, and its surface is the triangles that VTK "
       "draws.</li>\n"
       "<li>Peak memory does not include the given heights; for other programs it is all that they "
       "use.</li>\n"
       "<li>Times vary on a busy machine: compare only within a page, and consider the load "
       "above.</li>\n</ul>\n</body></html>\n";
  return out.str();
}

} // namespace benchmark
} // namespace skyline
