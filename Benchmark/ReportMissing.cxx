// SPDX-License-Identifier: BSD-3-Clause
#include "ReportMissing.h"

#include "Chart.h"

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

namespace
{

using Places = std::map<std::string, std::vector<std::string>>; // for each method, its scenes

std::string Joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

void WriteFailed(std::ostream& out, const Session& session)
{
  Places reasons;
  for (const Finding& finding : session.Findings)
  {
    if (!finding.Found.Ran)
    {
      const Task& task = finding.What;
      const std::string reason = finding.Found.Reason;
      reasons[task.Label + ": " + (reason.empty() ? "failed" : reason)].push_back(
        task.Scene + " (" + task.Quantity + ")");
    }
  }
  for (const auto& [reason, places] : reasons)
  {
    out << "<li>" << Escaped(reason) << " <span class=\"soft\">" << Escaped(Joined(places))
        << "</span></li>\n";
  }
}

void WriteLeftOut(std::ostream& out, const Session& session)
{
  for (const Quantity& quantity : Quantities())
  {
    Places scenes;
    std::size_t count = 0;
    for (const Task& task : session.LeftOut)
    {
      if (task.Quantity == quantity.Name)
      {
        scenes[task.Label].push_back(task.Scene);
        ++count;
      }
    }
    if (count > 0)
    {
      out << "<tr><td class=\"w\">" << Escaped(quantity.Title) << "</td><td>" << count
          << "</td><td class=\"w wrap\">";
      const char* comma = "";
      for (const auto& [label, where] : scenes)
      {
        out << comma << Escaped(label) << " <span class=\"soft\">(" << Escaped(Joined(where))
            << ")</span>";
        comma = "; ";
      }
      out << "</td><td class=\"w\"><code>--quantities " << quantity.Name << "</code></td></tr>\n";
    }
  }
}

} // namespace

double BudgetForAll(const Session& session)
{
  const auto done = static_cast<double>(session.Findings.size());
  const auto all = done + static_cast<double>(session.LeftOut.size());
  constexpr double spare = 1.2, minute = 60.0;
  const double seconds = done > 0.0 ? spare * session.Seconds * all / done : 10.0 * minute;
  return minute * std::ceil(seconds / minute);
}

void WriteHowMuch(std::ostream& out, const Session& session)
{
  if (session.LeftOut.empty())
  {
    return;
  }
  out << "<p><b>" << session.Findings.size() << " of "
      << session.Findings.size() + session.LeftOut.size() << " measurements were made within "
      << Short(session.Budget)
      << " s.</b> What is missing is listed under <a href=\"#missing\">Not "
      << "measured</a>; at the speed of this run <code>--budget " << BudgetForAll(session)
      << "</code> makes all of them.</p>\n";
}

void WriteNotMeasured(std::ostream& out, const Session& session)
{
  bool failed = false;
  for (const Finding& finding : session.Findings)
  {
    failed = failed || !finding.Found.Ran;
  }
  if (!failed && session.LeftOut.empty())
  {
    return;
  }
  out << "<h2 id=\"missing\">Not measured</h2>\n";
  if (failed)
  {
    out << "<p>These gave no result:</p><ul>\n";
    WriteFailed(out, session);
    out << "</ul>\n";
  }
  if (!session.LeftOut.empty())
  {
    out << "<p>There was no time for " << session.LeftOut.size()
        << " measurements. The option in the last column measures one quantity alone; all of them "
        << "need about "
        << "<code>--budget " << BudgetForAll(session)
        << "</code>. <code>--scenes</code> and <code>--methods</code> also select.</p>\n"
        << "<div class=\"wide\"><table><tr><th class=\"w\">what</th><th>missing</th>"
        << "<th class=\"w\">methods (scenes)</th><th class=\"w\">option</th></tr>\n";
    WriteLeftOut(out, session);
    out << "</table></div>\n";
  }
}

} // namespace benchmark
} // namespace skyline
