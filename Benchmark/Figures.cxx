// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

namespace skyline
{
namespace benchmark
{

const std::vector<Figure>& Figures()
{
  static const std::vector<Figure> figures{
    { "bias", "bias", [](const Result& r) { return r.Error.Bias; } },
    { "rmse", "rmse", [](const Result& r) { return r.Error.Rmse; } },
    { "p999", "99.9 %", [](const Result& r) { return r.Error.Percentile999; } },
    { "max", "greatest", [](const Result& r) { return r.Error.Largest; } },
    { "samples", nullptr, [](const Result& r) { return r.Error.Samples; } },
    { "wrong_percent", "wrong posts, %", [](const Result& r) { return r.WrongPercent; } },
    { "ssim", "SSIM", [](const Result& r) { return r.Similarity; } },
    { "cpu_cold_ns", "CPU, first run", [](const Result& r) { return r.ColdNs; } },
    { "cpu_median_ns", "CPU, median", [](const Result& r) { return r.TotalMedianNs; } },
    { "cpu_smallest_ns", nullptr, [](const Result& r) { return r.TotalNs; } },
    { "wall_median_ns", "wall, median", [](const Result& r) { return r.WallMedianNs; } },
    { "relight_ns", "new light alone", [](const Result& r) { return r.RelightNs; } },
    { "repeats", "runs", [](const Result& r) { return r.Repeats; } },
    { "threads", "threads", [](const Result& r) { return r.Threads; } },
    { "floats_per_post", "peak memory, floats per post",
      [](const Result& r) { return r.FloatsPerPost; } },
    { "build_s", nullptr, [](const Result& r) { return r.BuildSeconds; } },
  };
  return figures;
}

} // namespace benchmark
} // namespace skyline
