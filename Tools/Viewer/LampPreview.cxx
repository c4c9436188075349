// SPDX-License-Identifier: BSD-3-Clause
#include "LampPreview.h"

#include "HeightField/Normals.h"
#include "Lamps/Lamp.h"
#include "ViewerState.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{

/// A slope that hides nothing.
constexpr float Free = -1.0e30f;

// Visits the posts on the border of a square of 2 k + 1 posts that are inside the field.
template <typename Visit>
void ForRing(std::ptrdiff_t k, std::ptrdiff_t column, std::ptrdiff_t row, std::ptrdiff_t columns,
  std::ptrdiff_t rows, Visit visit)
{
  const std::ptrdiff_t west = column - k;
  const std::ptrdiff_t east = column + k;
  for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(row - k, 0); j <= std::min(row + k, rows - 1);
       ++j)
  {
    const bool whole = j == row - k || j == row + k;
    if (whole)
    {
      for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(west, 0); i <= std::min(east, columns - 1);
           ++i)
      {
        visit(i, j);
      }
      continue;
    }
    if (west >= 0)
    {
      visit(west, j);
    }
    if (east < columns)
    {
      visit(east, j);
    }
  }
}

} // namespace

namespace skyline
{

LampPreview::LampPreview(vtkImageData* terrain)
  : Columns(terrain->GetDimensions()[0])
  , Rows(terrain->GetDimensions()[1])
  , Origin{ terrain->GetOrigin()[0], terrain->GetOrigin()[1] }
  , Spacing{ terrain->GetSpacing()[0], terrain->GetSpacing()[1] }
{
  const auto posts = static_cast<std::size_t>(this->Columns * this->Rows);
  vtkDataArray* heights = terrain->GetPointData()->GetArray("Elevation");
  this->Heights.resize(posts);
  this->East.resize(posts);
  this->North.resize(posts);
  for (std::size_t post = 0; post < posts; ++post)
  {
    this->Heights[post] =
      static_cast<float>(heights->GetComponent(static_cast<vtkIdType>(post), 0));
  }
  const Grid grid{ this->Columns, this->Rows, this->Spacing[0], this->Spacing[1] };
  const PostView<float> view{ this->Heights.data(), 1, this->Columns };
  Gradients(grid, view, 0, this->Rows, this->East.data(), this->North.data());
}

std::vector<float> LampPreview::Visibility(const ViewerLamp& lamp, double z) const
{
  // For each post: the greatest slope on the way to it from the lowest point of the lamp, and the
  // distance of that obstacle from the lamp. The obstacle that hides the lower end of the lamp also
  // hides the rest next.
  std::vector<float> slopes(this->Heights.size(), Free);
  std::vector<float> places(this->Heights.size(), 0.0f);
  std::vector<float> seen(this->Heights.size(), 1.0f);
  const auto nearest = [](double place, std::ptrdiff_t count)
  { return std::clamp<std::ptrdiff_t>(std::lround(place), 0, count - 1); };
  const double x = (lamp.X - this->Origin[0]) / this->Spacing[0];
  const double y = (lamp.Y - this->Origin[1]) / this->Spacing[1];
  const std::ptrdiff_t column = nearest(x, this->Columns);
  const std::ptrdiff_t row = nearest(y, this->Rows);
  const auto radius = static_cast<float>(std::max(lamp.Radius, 1.0e-6));
  const float lowest = static_cast<float>(z) - radius;

  const auto visit = [&](std::ptrdiff_t i, std::ptrdiff_t j)
  {
    const std::ptrdiff_t di = i - column;
    const std::ptrdiff_t dj = j - row;
    const bool across = std::abs(di) >= std::abs(dj);
    const std::ptrdiff_t along = across ? di : dj;
    const std::ptrdiff_t aside = across ? dj : di;
    const std::ptrdiff_t before = along > 0 ? along - 1 : along + 1;
    const double crossing = static_cast<double>(aside * before) / static_cast<double>(along);
    const auto lower = static_cast<std::ptrdiff_t>(std::floor(crossing));
    const auto upper = static_cast<std::ptrdiff_t>(std::ceil(crossing));
    const auto weight = static_cast<float>(crossing - static_cast<double>(lower));
    const auto post = [&](std::ptrdiff_t beside)
    {
      return static_cast<std::size_t>(across ? (row + beside) * this->Columns + column + before
                                             : (row + before) * this->Columns + column + beside);
    };
    const std::size_t a = post(lower);
    const std::size_t b = post(upper);
    float slope = slopes[a] + weight * (slopes[b] - slopes[a]);
    float place = places[a] + weight * (places[b] - places[a]);
    const auto here = static_cast<std::size_t>(j * this->Columns + i);
    const auto distance =
      static_cast<float>(std::hypot((static_cast<double>(i) - x) * this->Spacing[0],
        (static_cast<double>(j) - y) * this->Spacing[1]));
    const float own = (this->Heights[here] - lowest) / std::max(distance, 1.0e-6f);
    if (slope > Free && place < distance)
    {
      // Height above the lowest point of the lamp where the ray over the obstacle meets its
      // vertical axis.
      const float over = (slope - own) * distance * place / (distance - place);
      seen[here] = std::clamp(1.0f - 0.5f * over / radius, 0.0f, 1.0f);
    }
    if (own >= slope)
    {
      slope = own;
      place = distance;
    }
    slopes[here] = slope;
    places[here] = place;
  };
  const std::ptrdiff_t rings =
    std::max({ column, this->Columns - 1 - column, row, this->Rows - 1 - row });
  for (std::ptrdiff_t k = 1; k <= rings; ++k)
  {
    ForRing(k, column, row, this->Columns, this->Rows, visit);
  }
  return seen;
}

vtkSmartPointer<vtkFloatArray> LampPreview::Light(const ViewerLamp& lamp, double z) const
{
  auto light = vtkSmartPointer<vtkFloatArray>::New();
  light->SetName("Irradiance");
  light->SetNumberOfComponents(3);
  light->SetNumberOfTuples(this->Columns * this->Rows);
  const std::vector<float> seen = this->Visibility(lamp, z);
  float* to = light->GetPointer(0);
  std::size_t post = 0;
  for (std::ptrdiff_t j = 0; j < this->Rows; ++j)
  {
    const double north = lamp.Y - this->Origin[1] - static_cast<double>(j) * this->Spacing[1];
    for (std::ptrdiff_t i = 0; i < this->Columns; ++i, ++post, to += 3)
    {
      const double east = lamp.X - this->Origin[0] - static_cast<double>(i) * this->Spacing[0];
      const double up = z - this->Heights[post];
      const double distance = std::sqrt(east * east + north * north + up * up);
      const double rise = this->East[post];
      const double climb = this->North[post];
      const double cosine = std::clamp((up - rise * east - climb * north) /
          (std::max(distance, 1.0e-9) * std::sqrt(1.0 + rise * rise + climb * climb)),
        -1.0, 1.0);
      const bool lit = seen[post] > 0.0f && std::isfinite(cosine);
      const double share =
        lit ? seen[post] * DiscIrradiance(DiscOfLamp(lamp.Radius, distance), cosine) : 0.0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        to[c] = static_cast<float>(share * lamp.Radiance[c]);
      }
    }
  }
  return light;
}

} // namespace skyline
