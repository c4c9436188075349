// SPDX-License-Identifier: BSD-3-Clause
#include "Pareto.h"

#include <algorithm>
#include <cmath>

namespace skyline
{
namespace benchmark
{

namespace
{

bool IsOurs(const Finding& finding)
{
  return finding.What.Kind == "exact" || finding.What.Kind == "fast";
}

bool IsPaper(const Finding& finding)
{
  return finding.What.Kind == "sweep" || finding.What.Kind == "pyramid";
}

// True if one of our methods was measured that can be compared with `paper`.
bool HasOurs(const std::vector<Finding>& findings, const Finding& paper)
{
  return std::any_of(findings.begin(), findings.end(),
    [&](const Finding& f)
    {
      return IsOurs(f) && OnChart(f) && f.What.Quantity == paper.What.Quantity &&
        f.What.Scene == paper.What.Scene;
    });
}

const Finding* Find(const std::vector<Finding>& findings, const Finding& like, const char* label)
{
  const auto found = std::find_if(findings.begin(), findings.end(),
    [&](const Finding& f)
    {
      return f.Found.Ran && f.What.Quantity == like.What.Quantity &&
        f.What.Scene == like.What.Scene && f.What.Label == label;
    });
  return found == findings.end() ? nullptr : &*found;
}

} // namespace

bool OnChart(const Finding& finding)
{
  return finding.Found.Ran && TimeOf(finding) > 0.0 && ErrorOf(finding) >= 0.0;
}

bool Beats(const Finding& a, const Finding& b)
{
  return TimeOf(a) <= TimeOf(b) && ErrorOf(a) <= ErrorOf(b) &&
    (TimeOf(a) < TimeOf(b) || ErrorOf(a) < ErrorOf(b));
}

std::vector<const Finding*> Front(const std::vector<const Finding*>& findings)
{
  std::vector<const Finding*> front;
  for (const Finding* one : findings)
  {
    if (std::none_of(findings.begin(), findings.end(),
          [&](const Finding* other) { return Beats(*other, *one); }))
    {
      front.push_back(one);
    }
  }
  std::sort(front.begin(), front.end(),
    [](const Finding* a, const Finding* b) { return TimeOf(*a) < TimeOf(*b); });
  return front;
}

std::vector<const Finding*> ChartOf(
  const std::vector<Finding>& findings, const std::string& quantity, const std::string& scene)
{
  std::vector<const Finding*> chart;
  for (const Finding& finding : findings)
  {
    if (finding.What.Quantity == quantity && finding.What.Scene == scene && OnChart(finding))
    {
      chart.push_back(&finding);
    }
  }
  return chart;
}

std::vector<Exception> Exceptions(const std::vector<Finding>& findings)
{
  std::vector<Exception> exceptions;
  for (const Finding& paper : findings)
  {
    if (!IsPaper(paper) || !OnChart(paper) || !HasOurs(findings, paper))
    {
      continue;
    }
    bool beaten = false;
    Exception exception;
    for (const Finding* ours : ChartOf(findings, paper.What.Quantity, paper.What.Scene))
    {
      beaten = beaten || (IsOurs(*ours) && Beats(*ours, paper));
      if (IsOurs(*ours) && ErrorOf(*ours) <= ErrorOf(paper) &&
        (!exception.Nearest || TimeOf(*ours) < TimeOf(*exception.Nearest)))
      {
        exception.Nearest = ours;
      }
    }
    if (!beaten)
    {
      const auto alike = std::find_if(findings.begin(), findings.end(),
        [&](const Finding& f)
        {
          return f.What.Kind == "exact" && OnChart(f) && f.What.Quantity == paper.What.Quantity &&
            f.What.Scene == paper.What.Scene && f.What.Settings == paper.What.Settings;
        });
      exception.Alike = alike == findings.end() ? nullptr : &*alike;
      exception.Tie =
        exception.Nearest && exception.Nearest->Found.TotalNs <= paper.Found.TotalMedianNs;
      exception.Paper = &paper;
      exceptions.push_back(exception);
    }
  }
  return exceptions;
}

std::size_t ComparedWithPapers(const std::vector<Finding>& findings, const std::string& quantity)
{
  return static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(),
    [&](const Finding& f)
    { return f.What.Quantity == quantity && IsPaper(f) && OnChart(f) && HasOurs(findings, f); }));
}

std::vector<Ratio> Ratios(const std::vector<Finding>& findings)
{
  std::vector<Ratio> ratios;
  for (const Finding& exact : findings)
  {
    if (exact.What.Quantity != "horizon" || exact.What.Label != "exact" || !exact.Found.Ran)
    {
      continue;
    }
    const auto add = [&](const char* name, const Finding* slow, const Finding* quick)
    {
      if (slow && quick && TimeOf(*quick) > 0.0)
      {
        ratios.push_back({ name, exact.What.Scene, TimeOf(*slow) / TimeOf(*quick) });
      }
    };
    add("exact over every crossing", Find(findings, exact, "every crossing"), &exact);
    add("exact over Embree 0.25", Find(findings, exact, "Embree 0.25°"), &exact);
    add("exact over GRASS r.horizon", Find(findings, exact, "GRASS r.horizon"), &exact);
    add("exact over sweep", Find(findings, exact, "sweep"), &exact);
    add("exact over pyramid", Find(findings, exact, "pyramid"), &exact);
    add("fast over exact", &exact, Find(findings, exact, "fast"));
  }
  return ratios;
}

} // namespace benchmark
} // namespace skyline
