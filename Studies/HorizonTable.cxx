// SPDX-License-Identifier: BSD-3-Clause
#include "HorizonTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace skyline
{
namespace benchmark
{

namespace
{

struct Column
{
  const char* Name;   // in the CSV
  const char* Head;   // above the column
  const char* Format; // of its numbers; null: in the CSV only
  double (*Value)(const Result&);
};

const std::vector<Column>& Columns()
{
  static const std::vector<Column> columns{
    { "bias_deg", "bias", "%.4f", [](const Result& r) { return r.Error.Bias; } },
    { "rmse_deg", "rmse", "%.4f", [](const Result& r) { return r.Error.Rmse; } },
    { "p999_deg", "99.9 %", "%.4f", [](const Result& r) { return r.Error.Percentile999; } },
    { "max_deg", "max", "%.4f", [](const Result& r) { return r.Error.Largest; } },
    { "samples", "", nullptr, [](const Result& r) { return r.Error.Samples; } },
    { "prepare_ns", "prepare", "%.2f", [](const Result& r) { return r.PrepareNs; } },
    { "search_ns", "search", "%.2f", [](const Result& r) { return r.SearchNs; } },
    { "cpu_ns", "CPU", "%.2f", [](const Result& r) { return r.TotalNs; } },
    { "cpu_median_ns", "CPU med", "%.2f", [](const Result& r) { return r.TotalMedianNs; } },
    { "wall_ns", "wall", "%.2f", [](const Result& r) { return r.WallNs; } },
    { "wall_median_ns", "wall med", "%.2f", [](const Result& r) { return r.WallMedianNs; } },
    { "floats_per_post", "floats", "%.2f", [](const Result& r) { return r.FloatsPerPost; } },
    { "build_s", "build s", "%.2f", [](const Result& r) { return r.BuildSeconds; } },
    { "svf_rmse", "SVF rmse", "%.1e", [](const Result& r) { return r.SkyViewRmse; } },
  };
  return columns;
}

std::string Number(const char* format, double value)
{
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return std::isnan(value) ? "-" : text;
}

std::string Padded(const std::string& text, int width) // negative: left-aligned
{
  const std::string gap(
    static_cast<std::size_t>(std::max(0, std::abs(width) - static_cast<int>(text.size()))), ' ');
  return width < 0 ? text + gap : gap + text;
}

std::string Quoted(const std::string& text)
{
  std::string quoted = "\"";
  for (const char letter : text)
  {
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  }
  return quoted + "\"";
}

constexpr int LabelWidth = -17, NumberWidth = 10;

// The width of the column of scenes, whose names can be those of files: left-aligned, followed by
// two spaces.
int SceneWidth(const std::vector<Row>& rows)
{
  std::size_t longest = 8;
  for (const Row& row : rows)
  {
    longest = std::max(longest, row.Scene.size());
  }
  return -static_cast<int>(longest + 2);
}

const Row* FindRow(const std::vector<Row>& rows, const std::string& scene, const char* method)
{
  const auto row = std::find_if(rows.begin(), rows.end(),
    [&](const Row& r) { return r.Scene == scene && r.Method == method && r.Found.Ran; });
  return row == rows.end() ? nullptr : &*row;
}

} // namespace

void PrintTable(std::ostream& out, const std::vector<Row>& rows)
{
  const int sceneWidth = SceneWidth(rows);
  out
    << "bias to max: degrees, found - oracle. prepare to wall med: ns for one post and azimuth\n"
       "on one core, CPU time of the thread (prepare, search, their sum) and wall time, smallest\n"
       "and median of the repeats. floats: peak memory per post beyond the input.\n\n"
    << Padded("scene", sceneWidth) << Padded("method", LabelWidth);
  for (const Column& column : Columns())
  {
    if (column.Format)
    {
      out << Padded(column.Head, NumberWidth);
    }
  }
  out << "  note\n";
  std::string scene;
  for (const Row& row : rows)
  {
    if (!scene.empty() && scene != row.Scene)
    {
      out << "\n";
    }
    scene = row.Scene;
    out << Padded(row.Scene, sceneWidth) << Padded(row.Label, LabelWidth);
    for (const Column& column : Columns())
    {
      if (column.Format)
      {
        out << Padded(Number(column.Format, column.Value(row.Found)), NumberWidth);
      }
    }
    out << "  " << row.Found.Reason << "\n";
  }
}

void PrintRatios(std::ostream& out, const std::vector<Row>& rows)
{
  struct Ratio
  {
    const char *Head, *Slow, *Quick;
  };
  const Ratio ratios[] = {
    { "exact over Embree 0.25", "embree0.25", "exact" },
    { "exact over Embree 0.01", "embree0.01", "exact" },
    { "exact over every crossing", "every", "exact" },
    { "exact over GRASS", "grass", "exact" },
    { "fast over exact", "exact", "fast" },
  };
  const int sceneWidth = SceneWidth(rows);
  constexpr int width = 27;
  out << "times faster (CPU ns, smallest)\n\n" << Padded("scene", sceneWidth);
  for (const Ratio& ratio : ratios)
  {
    out << Padded(ratio.Head, width);
  }
  out << "\n";
  std::string scene;
  for (const Row& row : rows)
  {
    if (row.Scene == scene)
    {
      continue;
    }
    scene = row.Scene;
    out << Padded(scene, sceneWidth);
    for (const Ratio& ratio : ratios)
    {
      const Row* slow = FindRow(rows, scene, ratio.Slow);
      const Row* quick = FindRow(rows, scene, ratio.Quick);
      const double times = slow && quick ? slow->Found.TotalNs / quick->Found.TotalNs : NotMeasured;
      out << Padded(Number("%.2f", times), width);
    }
    out << "\n";
  }
}

void PrintCsv(std::ostream& out, const std::vector<Row>& rows)
{
  out << "scene,method";
  for (const Column& column : Columns())
  {
    out << "," << column.Name;
  }
  out << ",note\n";
  for (const Row& row : rows)
  {
    out << Quoted(row.Scene) << "," << row.Method;
    for (const Column& column : Columns())
    {
      const double value = column.Value(row.Found);
      out << "," << (std::isnan(value) ? "" : Number("%.9g", value));
    }
    out << "," << Quoted(row.Found.Reason) << "\n";
  }
}

} // namespace benchmark
} // namespace skyline
