// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"
#include "Pareto.h"
#include "Report.h"

#include <cmath>
#include <cstdio>
#include <sstream>

namespace skyline
{
namespace benchmark
{

namespace
{

std::string Digits(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string CsvText(const std::string& text)
{
  std::string quoted = "\"";
  for (const char letter : text)
  {
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  }
  return quoted + "\"";
}

using Pairs = std::vector<std::pair<std::string, std::string>>;

void WriteObject(std::ostream& out, const char* name, const Pairs& pairs)
{
  out << "  " << JsonText(name) << ": {";
  const char* comma = "";
  for (const auto& [key, value] : pairs)
  {
    out << comma << "\n    " << JsonText(key) << ": " << JsonText(value);
    comma = ",";
  }
  out << "\n  },\n";
}

std::string TaskJson(const Task& task)
{
  return "\"quantity\": " + JsonText(task.Quantity) + ", \"scene\": " + JsonText(task.Scene) +
    ", \"method\": " + JsonText(task.Kind) + ", \"label\": " + JsonText(task.Label) +
    ", \"settings\": " + JsonText(task.Settings);
}

} // namespace

std::string JsonText(const std::string& text)
{
  std::string quoted = "\"";
  for (const char letter : text)
  {
    if (letter == '"' || letter == '\\')
    {
      quoted += '\\';
    }
    if (static_cast<unsigned char>(letter) < 0x20)
    {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(letter));
      quoted += code;
    }
    else
    {
      quoted += letter;
    }
  }
  return quoted + "\"";
}

std::string ReportCsv(const Session& session)
{
  std::ostringstream out;
  out << "quantity,scene,method,label,settings,ran";
  for (const Figure& figure : Figures())
  {
    out << "," << figure.Name;
  }
  out << ",note\n";
  for (const Finding& finding : session.Findings)
  {
    const Task& task = finding.What;
    out << task.Quantity << "," << CsvText(task.Scene) << "," << task.Kind << ","
        << CsvText(task.Label) << "," << CsvText(task.Settings) << ","
        << (finding.Found.Ran ? 1 : 0);
    for (const Figure& figure : Figures())
    {
      const double value = figure.Value(finding.Found);
      out << "," << (finding.Found.Ran && std::isfinite(value) ? Digits(value) : "");
    }
    out << "," << CsvText(finding.Found.Reason) << "\n";
  }
  return out.str();
}

std::string ReportJson(const Session& session, const ReportOrigin& origin)
{
  std::ostringstream out;
  out << "{\n  \"program\": " << JsonText(origin.Program)
      << ",\n  \"command\": " << JsonText(origin.Command)
      << ",\n  \"seconds\": " << Digits(session.Seconds)
      << ",\n  \"budget_s\": " << Digits(session.Budget) << ",\n";
  WriteObject(out, "machine", session.Machine);
  WriteObject(out, "scenes", session.Scenes);
  out << "  \"findings\": [";
  const char* comma = "";
  for (const Finding& finding : session.Findings)
  {
    out << comma << "\n    {" << TaskJson(finding.What)
        << ", \"ran\": " << (finding.Found.Ran ? "true" : "false");
    for (const Figure& figure : Figures())
    {
      const double value = figure.Value(finding.Found);
      if (finding.Found.Ran && std::isfinite(value))
      {
        out << ", " << JsonText(figure.Name) << ": " << Digits(value);
      }
    }
    out << ", \"seconds\": " << Digits(finding.Seconds)
        << ", \"note\": " << JsonText(finding.Found.Reason) << "}";
    comma = ",";
  }
  out << "\n  ],\n  \"left_out\": [";
  comma = "";
  for (const Task& task : session.LeftOut)
  {
    out << comma << "\n    {" << TaskJson(task) << "}";
    comma = ",";
  }
  out << "\n  ],\n  \"ratios\": [";
  comma = "";
  for (const Ratio& ratio : Ratios(session.Findings))
  {
    out << comma << "\n    {\"name\": " << JsonText(ratio.Name)
        << ", \"scene\": " << JsonText(ratio.Scene) << ", \"times\": " << Digits(ratio.Times)
        << "}";
    comma = ",";
  }
  out << "\n  ]\n}\n";
  return out.str();
}

} // namespace benchmark
} // namespace skyline
