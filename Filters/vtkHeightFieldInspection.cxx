// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldInspection.h"

#include "Data/ImageGeoreference.h"
#include "Data/Warnings.h"
#include "Geo/LooksLikeDegrees.h"
#include "HeightField/HeightCensus.h"
#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

vtkStandardNewMacro(vtkHeightFieldInspection);

void vtkHeightFieldInspection::Inspect(vtkImageData* heightField, const char* subject)
{
  vtkDataArray* heights = heightField ? heightField->GetPointData()->GetScalars() : nullptr;
  if (!heights || heights->GetNumberOfComponents() != 1)
  {
    return;
  }
  skyline::HeightCensus census;
  const auto count = [&](auto* array)
  {
    for (const auto height : vtk::DataArrayValueRange<1>(array))
    {
      const auto number = static_cast<double>(height);
      if (std::isfinite(number))
      {
        census.Add(number);
      }
    }
  };
  if (!vtkArrayDispatch::Dispatch::Execute(heights, count))
  {
    count(heights);
  }
  const std::string name = subject ? subject : "the height field";
  const skyline::HeightCensus::Findings found =
    census.Judge(name, 1.0, heights->GetDataType() == VTK_FLOAT);
  for (const skyline::Doubt& doubt : found.Doubts)
  {
    skyline::Warn(this, doubt);
  }

  const skyline::Georeference place = skyline::LoadGeoreference(heightField);
  const int* posts = heightField->GetDimensions();
  const double* spacing = heightField->GetSpacing();
  double west = 0.0, south = 0.0, east = posts[0] * spacing[0], north = posts[1] * spacing[1];
  if (place.HasGeoTransform)
  {
    west = place.GeoTransform[0];
    east = west + posts[0] * place.GeoTransform[1];
    north = place.GeoTransform[3];
    south = north + posts[1] * place.GeoTransform[5];
  }
  const double relief = found.Highest - found.Lowest;
  // A spacing of a metre or more is taken as metres.
  constexpr double finest = 1.0;
  const bool given = !place.HasGeoTransform && spacing[0] >= finest;
  if (found.Any && place.Crs.empty() && !given &&
    skyline::LooksLikeDegrees(west, south, east, north, relief))
  {
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(),
      " has no CRS and looks like degrees (%.6g wide, %.6g high) with a relief of %.6g m",
      east - west, north - south, relief);
    std::array<char, 64> assumed{};
    std::snprintf(assumed.data(), assumed.size(), "a spacing of %.6g metres", spacing[0]);
    skyline::Warn(this, { name + text.data(), assumed.data(), "a transform and a CRS" });
  }
}

void vtkHeightFieldInspection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
