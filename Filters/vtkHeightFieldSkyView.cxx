// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldSkyView.h"

#include "Azimuths.h"
#include "Horizon/EdgeTrustAccumulator.h"
#include "HorizonDriver.h"
#include "PostArrays.h"
#include "Sky/SkyAccumulator.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeightFieldSkyView);

namespace
{

// The automatic distance in which the horizon must be known: metres, and as a part of the shorter
// side.
constexpr double UsualEdgeDistance = 1000.0;
constexpr double LargestEdgeShare = 0.1;

// Passes slopes to two consumers.
class Both : public skyline::Accumulator
{
public:
  Both(skyline::Accumulator& one, skyline::Accumulator* other)
    : One(one)
    , Other(other)
  {
  }
  void Begin(double azimuth, double width) override
  {
    this->One.Begin(azimuth, width);
    if (this->Other)
    {
      this->Other->Begin(azimuth, width);
    }
  }
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override
  {
    this->One.Add(row, column, count, slopes);
    if (this->Other)
    {
      this->Other->Add(row, column, count, slopes);
    }
  }
  void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) override
  {
    this->One.Finish(rowBegin, rowEnd);
    if (this->Other)
    {
      this->Other->Finish(rowBegin, rowEnd);
    }
  }

private:
  skyline::Accumulator& One;
  skyline::Accumulator* Other; // may be null
};

} // namespace

void vtkHeightFieldSkyView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfAzimuths: " << this->NumberOfAzimuths << "\n"
     << indent << "SkyViewFactor: " << this->SkyViewFactor << "\n"
     << indent << "SkyViewFactorHorizontal: " << this->SkyViewFactorHorizontal << "\n"
     << indent << "VisibleSkyFraction: " << this->VisibleSkyFraction << "\n"
     << indent << "PositiveOpenness: " << this->PositiveOpenness << "\n"
     << indent << "EdgeTrust: " << this->EdgeTrust << "\n"
     << indent << "AutoEdgeDistance: " << this->AutoEdgeDistance << "\n"
     << indent << "EdgeDistance: " << this->EdgeDistance << "\n";
}

double vtkHeightFieldSkyView::UsedEdgeDistance(const skyline::Grid& posts) const
{
  if (this->AutoEdgeDistance)
  {
    const double width = posts.SpacingX * static_cast<double>(posts.Columns - 1);
    const double height = posts.SpacingY * static_cast<double>(posts.Rows - 1);
    return std::min(UsualEdgeDistance, LargestEdgeShare * std::min(width, height));
  }
  if (!(this->EdgeDistance >= 0.0 && std::isfinite(this->EdgeDistance)))
  {
    throw std::out_of_range("the edge distance is " + std::to_string(this->EdgeDistance) +
      "; give metres, 0 or more, or let it be found by AutoEdgeDistance");
  }
  return this->EdgeDistance;
}

bool vtkHeightFieldSkyView::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  const std::vector<double> azimuths = skyline::EvenAzimuths(this->NumberOfAzimuths);
  const int quantities = this->SkyViewFactor + this->SkyViewFactorHorizontal +
    this->VisibleSkyFraction + this->PositiveOpenness + 2 * this->EdgeTrust;
  driver.DemandFloats("sky views", quantities + (this->SkyViewFactor ? 2 : 0), azimuths);
  std::vector<vtkFloatArray*> arrays;
  const auto buffer = [&](bool wanted, const char* name)
  {
    if (!wanted)
    {
      return skyline::PostBuffer();
    }
    arrays.push_back(skyline::AddPostArray(output, name));
    return skyline::PostBuffer{ arrays.back()->GetPointer(0), 1 };
  };
  skyline::SkyBuffers buffers;
  buffers.SkyViewFactor = buffer(this->SkyViewFactor, "SkyViewFactor");
  buffers.SkyViewFactorHorizontal =
    buffer(this->SkyViewFactorHorizontal, "SkyViewFactorHorizontal");
  buffers.VisibleSkyFraction = buffer(this->VisibleSkyFraction, "VisibleSkyFraction");
  buffers.PositiveOpenness = buffer(this->PositiveOpenness, "PositiveOpenness");
  const skyline::PostBuffer trust = buffer(this->EdgeTrust, "EdgeTrust");
  if (arrays.empty())
  {
    throw std::invalid_argument("no quantity is switched on; switch on SkyViewFactor or another");
  }

  // Only the tilted surface needs gradients.
  std::unique_ptr<float[]> gradients;
  const auto posts = static_cast<std::size_t>(output->GetNumberOfPoints());
  float* north = nullptr;
  if (this->SkyViewFactor)
  {
    gradients.reset(new float[2 * posts]);
    north = gradients.get() + posts;
    driver.Input().FillGradients(gradients.get(), north);
  }
  skyline::SkyAccumulator sky(driver.Input().Posts().Columns, buffers, gradients.get(), north);
  std::unique_ptr<skyline::EdgeTrustAccumulator> edges;
  if (this->EdgeTrust)
  {
    driver.DoubtOneMetric("edge trust", driver.Input().CentreMetric());
    edges = std::make_unique<skyline::EdgeTrustAccumulator>(driver.Input().Field(),
      this->UsedEdgeDistance(driver.Input().Posts()), trust, driver.Input().Ground().RowSpacingX(),
      driver.Input().Ground().RowSpacingY());
  }
  Both consumers(sky, edges.get());
  if (!driver.Run(azimuths, 2.0 * skyline::Pi / this->NumberOfAzimuths, consumers))
  {
    return false;
  }
  for (vtkFloatArray* array : arrays)
  {
    skyline::BlankMissing(driver.Input().Field(), array);
  }
  return true;
}
