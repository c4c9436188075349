// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/VisibilityWedge.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skyline
{

namespace
{

constexpr int MaxCount = HarmonicCount(MaxHarmonicBands);
constexpr double HalfPi = 0.5 * Pi;

/// Nodes and weights of Gauss-Legendre quadrature on [-1, 1], by Newton's method.
struct GaussLegendre
{
  static constexpr int Points = 16;
  std::array<double, Points> Nodes{}, Weights{};

  GaussLegendre()
  {
    for (int i = 0; i < Points; ++i)
    {
      double x = std::cos(Pi * (i + 0.75) / (Points + 0.5));
      double slope = 1.0;
      for (int step = 0; step < 8; ++step)
      {
        double before = 1.0;
        double now = x;
        for (int k = 1; k < Points; ++k)
        {
          const double next = ((2.0 * k + 1.0) * x * now - k * before) / (k + 1.0);
          before = now;
          now = next;
        }
        slope = Points * (x * now - before) / (x * x - 1.0);
        x -= now / slope;
      }
      this->Nodes[static_cast<std::size_t>(i)] = x;
      this->Weights[static_cast<std::size_t>(i)] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
  }
};

/// All integrals of the harmonics of 1 to 8 bands.
const std::vector<ElevationIntegral>& Integrals(int bands)
{
  static const std::array<std::vector<ElevationIntegral>, MaxHarmonicBands + 1> all = []()
  {
    std::array<std::vector<ElevationIntegral>, MaxHarmonicBands + 1> made;
    for (std::size_t b = 1; b < made.size(); ++b)
    {
      made[b] = ElevationIntegrals(static_cast<int>(b), ElevationWeight::One);
    }
    return made;
  }();
  return all[static_cast<std::size_t>(bands)];
}

/// Adds weight times the sky above the horizon. means: the azimuthal factors of each order.
void AddSky(int bands, double horizon, double weight, const SwathMean* means, double* wedge)
{
  auto integral = Integrals(bands).begin();
  for (int m = 0; m < bands; ++m)
  {
    for (int l = m; l < bands; ++l, ++integral)
    {
      const double sky = weight * (integral->Whole - integral->Lost(horizon));
      wedge[HarmonicIndex(l, m)] += sky * means[m].Cosine;
      if (m > 0)
      {
        wedge[HarmonicIndex(l, -m)] += sky * means[m].Sine;
      }
    }
  }
}

} // namespace

void StepWedge(int bands, double azimuth, double width, double horizon, double* wedge)
{
  SwathMean means[MaxHarmonicBands];
  for (int m = 0; m < bands; ++m)
  {
    means[m] = MeanOverSwath(m, azimuth, width);
  }
  std::fill_n(wedge, HarmonicCount(bands), 0.0);
  AddSky(bands, horizon, width, means, wedge);
}

void LinearWedge(int bands, double azimuth, double width, double from, double to, double* wedge)
{
  static const GaussLegendre rule;
  const int panels = std::max(1, static_cast<int>(std::ceil(2.0 * width)));
  std::fill_n(wedge, HarmonicCount(bands), 0.0);
  for (int panel = 0; panel < panels; ++panel)
  {
    for (std::size_t i = 0; i < GaussLegendre::Points; ++i)
    {
      const double part = (panel + 0.5 + 0.5 * rule.Nodes[i]) / panels;
      SwathMean means[MaxHarmonicBands];
      for (int m = 0; m < bands; ++m)
      {
        means[m] = MeanOverSwath(m, azimuth + part * width, 0.0);
      }
      AddSky(
        bands, from + part * (to - from), 0.5 * width / panels * rule.Weights[i], means, wedge);
    }
  }
}

WedgeTable::WedgeTable(int bands, double width)
  : Count(bands)
  , Extent(width)
{
  const auto count = static_cast<std::size_t>(HarmonicCount(bands));
  const auto elevation = [](int k) { return HalfPi * k / (Elevations - 1); };
  double wedge[MaxCount];
  const auto keep = [&](std::vector<float>& table)
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      table.push_back(static_cast<float>(wedge[k]));
    }
  };
  this->Interior.reserve(count * Elevations * Elevations);
  for (int from = 0; from < Elevations; ++from)
  {
    for (int to = 0; to < Elevations; ++to)
    {
      LinearWedge(bands, 0.0, width, elevation(from), elevation(to), wedge);
      keep(this->Interior);
    }
  }
  for (int k = 0; k < Elevations; ++k)
  {
    LinearWedge(bands, 0.0, 0.5 * width, HalfPi, elevation(k), wedge);
    keep(this->Start);
    LinearWedge(bands, 0.0, 0.5 * width, elevation(k), HalfPi, wedge);
    keep(this->End);
  }
}

namespace
{

/// The position of an elevation in a table.
struct TablePlace
{
  std::size_t Low;
  double Part;
};

TablePlace PlaceOf(double horizon)
{
  const double place =
    std::clamp(horizon / HalfPi, 0.0, 1.0) * static_cast<double>(WedgeTable::Elevations - 1);
  const double low = std::min(std::floor(place), static_cast<double>(WedgeTable::Elevations - 2));
  return { static_cast<std::size_t>(low), place - low };
}

} // namespace

void WedgeTable::AddTurned(double azimuth, const double* wedge, double* sums) const
{
  double turned[MaxCount];
  RotateAboutVertical(this->Count, azimuth, wedge, turned);
  for (int k = 0; k < HarmonicCount(this->Count); ++k)
  {
    sums[k] += turned[k];
  }
}

void WedgeTable::AddInterior(double azimuth, double from, double to, double* sums) const
{
  const auto count = static_cast<std::size_t>(HarmonicCount(this->Count));
  const TablePlace a = PlaceOf(from);
  const TablePlace b = PlaceOf(to);
  const float* low = this->Interior.data() + (a.Low * Elevations + b.Low) * count;
  const float* high = low + Elevations * count;
  double wedge[MaxCount];
  for (std::size_t k = 0; k < count; ++k)
  {
    wedge[k] = (1.0 - a.Part) * ((1.0 - b.Part) * low[k] + b.Part * low[count + k]) +
      a.Part * ((1.0 - b.Part) * high[k] + b.Part * high[count + k]);
  }
  this->AddTurned(azimuth, wedge, sums);
}

void WedgeTable::AddStart(double azimuth, double horizon, double* sums) const
{
  const auto count = static_cast<std::size_t>(HarmonicCount(this->Count));
  const TablePlace place = PlaceOf(horizon);
  const float* low = this->Start.data() + place.Low * count;
  double wedge[MaxCount];
  for (std::size_t k = 0; k < count; ++k)
  {
    wedge[k] = (1.0 - place.Part) * low[k] + place.Part * low[count + k];
  }
  this->AddTurned(azimuth - 0.5 * this->Extent, wedge, sums);
}

void WedgeTable::AddEnd(double azimuth, double horizon, double* sums) const
{
  const auto count = static_cast<std::size_t>(HarmonicCount(this->Count));
  const TablePlace place = PlaceOf(horizon);
  const float* low = this->End.data() + place.Low * count;
  double wedge[MaxCount];
  for (std::size_t k = 0; k < count; ++k)
  {
    wedge[k] = (1.0 - place.Part) * low[k] + place.Part * low[count + k];
  }
  this->AddTurned(azimuth, wedge, sums);
}

std::shared_ptr<const WedgeTable> WedgeTables::Get(int bands, double width)
{
  std::shared_ptr<const WedgeTable>& table = this->Tables[{ bands, width }];
  if (!table)
  {
    table = std::make_shared<WedgeTable>(bands, width);
  }
  return table;
}

} // namespace skyline
