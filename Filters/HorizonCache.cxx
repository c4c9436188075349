// SPDX-License-Identifier: BSD-3-Clause
#include "HorizonCache.h"

#include "HorizonDriver.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace skyline
{

namespace
{

/// Stores the slopes of each azimuth.
class SlopeStore : public Accumulator
{
public:
  SlopeStore(const Grid& grid, std::vector<std::vector<float>*> planes)
    : Posts(grid)
    , Planes(std::move(planes))
  {
  }
  void Begin(double, double) override
  {
    this->Plane = this->Planes[this->Next++];
    this->Plane->resize(static_cast<std::size_t>(this->Posts.Columns * this->Posts.Rows));
  }
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override
  {
    std::copy_n(slopes, count, this->Plane->data() + row * this->Posts.Columns + column);
  }
  void Finish(std::ptrdiff_t, std::ptrdiff_t) override {}

private:
  Grid Posts;
  std::vector<std::vector<float>*> Planes;
  std::vector<float>* Plane = nullptr;
  std::size_t Next = 0;
};

} // namespace

void HorizonCache::SetSurface(const std::vector<double>& key)
{
  if (!this->Keep || key != this->Key)
  {
    this->Slopes.clear();
    this->Key = key;
  }
}

bool HorizonCache::Run(
  HorizonDriver& driver, const std::vector<double>& azimuths, double width, Accumulator& consumer)
{
  if (!this->Keep)
  {
    this->Searched += static_cast<int>(azimuths.size());
    return driver.Run(azimuths, width, consumer);
  }
  std::vector<double> missing;
  for (const double azimuth : azimuths)
  {
    if (this->Slopes.find(azimuth) == this->Slopes.end())
    {
      missing.push_back(azimuth);
    }
  }
  std::sort(missing.begin(), missing.end());
  missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
  driver.DemandFloats("kept horizons", static_cast<std::ptrdiff_t>(missing.size()), missing);
  std::vector<std::vector<float>*> planes;
  planes.reserve(missing.size());
  for (const double azimuth : missing)
  {
    planes.push_back(&this->Slopes[azimuth]);
  }
  SlopeStore store(driver.Input().Posts(), planes);
  if (!missing.empty() && !driver.Run(missing, width, store))
  {
    this->Slopes.clear(); // the last planes are incomplete
    return false;
  }
  this->Searched += static_cast<int>(missing.size());
  const Grid& grid = driver.Input().Posts();
  for (const double azimuth : azimuths)
  {
    const std::vector<float>& slopes = this->Slopes[azimuth];
    consumer.Begin(azimuth, width);
    vtkSMPTools::For(0, grid.Rows,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          consumer.Add(row, 0, grid.Columns, slopes.data() + row * grid.Columns);
        }
      });
  }
  vtkSMPTools::For(
    0, grid.Rows, [&](vtkIdType begin, vtkIdType end) { consumer.Finish(begin, end); });
  return true;
}

} // namespace skyline
