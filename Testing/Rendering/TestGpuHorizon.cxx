// SPDX-License-Identifier: BSD-3-Clause
#include "GpuTesting.h"

#include "vtkOpenGLHeightFieldHorizon.h"
#include "vtkOpenGLHeightFieldTransfer.h"

#include "Data/ImageGeoreference.h"

namespace skyline
{
namespace testing
{
namespace
{

// Degrees. Both compute the same differences of floats. The polynomials of the host and of the
// shader round differently, by 1.4e-7 rad each, and so does the sum of two products if one of them
// is fused.
constexpr double RoundingTolerance = 6.0e-5;

// Degrees. Heights of 1500 m are summed in another order, at a distance of 30 m.
constexpr double PyramidTolerance = 1.0e-3;

// Degrees. The graphics processor uses one spacing per band of rows, with an error of 0.05 %. The
// host uses the spacing of each row.
constexpr double BandParity = 0.0144;

class Horizons : public GpuTest
{
protected:
  double Parity(const oracle::OracleField& field, int method, int azimuths = 24)
  {
    return this->Parity(ImageOf<vtkDoubleArray>(field), method, azimuths);
  }

  double Parity(const vtkSmartPointer<vtkImageData>& image, int method, int azimuths)
  {
    vtkNew<vtkOpenGLHeightFieldHorizon> gpu;
    gpu->SetDevice(this->Device);
    vtkNew<vtkHeightFieldHorizon> host;
    for (vtkHeightFieldHorizon* filter :
      { static_cast<vtkHeightFieldHorizon*>(gpu), host.GetPointer() })
    {
      filter->SetInputData(image);
      filter->SetMethod(method);
      filter->SetNumberOfAzimuths(azimuths);
      filter->Update();
    }
    EXPECT_TRUE(gpu->IsOnDevice());
    return Difference(ArrayOf(gpu, "HorizonElevation"), ArrayOf(host, "HorizonElevation"));
  }
};

TEST_F(Horizons, AreExact)
{
  EXPECT_LT(this->Parity(Hills(131, 97), vtkHeightFieldHorizon::EXACT), RoundingTolerance);
  EXPECT_LT(this->Parity(Hills(50, 140), vtkHeightFieldHorizon::EXACT, 7), RoundingTolerance);
}

TEST_F(Horizons, BesideMissingPosts)
{
  EXPECT_LT(this->Parity(HillsWithHoles(131, 97), vtkHeightFieldHorizon::EXACT), RoundingTolerance);
}

TEST_F(Horizons, OfTheSmallestFields)
{
  EXPECT_LT(this->Parity(Hills(2, 2), vtkHeightFieldHorizon::EXACT, 16), RoundingTolerance);
  EXPECT_LT(this->Parity(Hills(2, 9), vtkHeightFieldHorizon::EXACT, 16), RoundingTolerance);
}

TEST_F(Horizons, OfThePyramid)
{
  EXPECT_LT(this->Parity(Hills(131, 97), vtkHeightFieldHorizon::PYRAMID), PyramidTolerance);
}

// Degrees of longitude on the Earth: rows have different spacings, and the curvature lowers distant
// posts.
TEST_F(Horizons, OnABody)
{
  const auto image = ImageOf<vtkDoubleArray>(shapes::Fractal(40, 50, 2000.0, 3000.0, 6));
  Georeference place;
  place.EquatorialRadius = 6371000.0;
  place.Earth = true;
  place.Columns = 40;
  place.Rows = 50;
  place.LatticeColumns = place.LatticeRows = 2;
  place.Longitude = { 0.0, 1.0, 0.0, 1.0 };
  place.Latitude = { 0.0, 0.0, 1.0, 1.0 };
  for (int row = 0; row < 50; ++row)
  {
    place.RowSpacingX.push_back(2000.0 * std::cos(row * 0.015));
    place.RowSpacingY.push_back(2000.0);
  }
  StoreGeoreference(place, image);
  for (const int limit : { 0, 33 })
  {
    this->Device->SetTextureLimit(limit);
    EXPECT_LT(this->Parity(image, vtkHeightFieldHorizon::EXACT, 7), BandParity);
    EXPECT_LT(this->Parity(image, vtkHeightFieldHorizon::PYRAMID, 7), PyramidTolerance);
  }
}

TEST_F(Horizons, TileByTile)
{
  this->Device->SetTextureLimit(40);
  EXPECT_LT(this->Parity(Hills(91, 67), vtkHeightFieldHorizon::EXACT, 10), RoundingTolerance);
  EXPECT_LT(
    this->Parity(HillsWithHoles(61, 44), vtkHeightFieldHorizon::EXACT, 10), RoundingTolerance);
}

TEST_F(Horizons, GoIntoHarmonicsToo)
{
  const auto image = ImageOf<vtkDoubleArray>(HillsWithHoles(70, 90));
  vtkNew<vtkOpenGLHeightFieldTransfer> gpu;
  gpu->SetDevice(this->Device);
  vtkNew<vtkHeightFieldTransfer> host;
  for (vtkHeightFieldTransfer* filter :
    { static_cast<vtkHeightFieldTransfer*>(gpu), host.GetPointer() })
  {
    filter->SetInputData(image);
    filter->SetNumberOfAzimuths(10);
    filter->Update();
  }
  EXPECT_TRUE(gpu->IsOnDevice());
  constexpr double coefficients = 1.0e-5; // as in TestGpuHarmonics
  EXPECT_LT(Difference(ArrayOf(gpu, "TransferSH"), ArrayOf(host, "TransferSH")), coefficients);
}

} // namespace
} // namespace testing
} // namespace skyline
