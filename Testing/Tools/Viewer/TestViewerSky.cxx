// SPDX-License-Identifier: BSD-3-Clause
// The sky behind the terrain: its position, and its brightness at night.
#include "ViewerTesting.h"

#include "Shared/Constants.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkSkylineSoftShadowShader.h"

#include <array>
#include <cmath>
#include <fstream>

namespace skyline
{
namespace testing
{
namespace
{

// Pixels between the centre of the sun's picture and its correct position.
constexpr double PlaceTolerance = 4.0;

// Degrees between the azimuth of the sun and that of the lit slopes, because slopes are not equally
// frequent in all directions.
constexpr double SlopeTolerance = 12.0;

// A map of 64 x 32 pixels with faint light and one bright pixel, as a Radiance file without run
// lengths.
constexpr int MapColumns = 64;
constexpr int MapRows = 32;
constexpr int SunColumn = 40;
constexpr int SunRow = 8;
constexpr double SunAzimuth = (SunColumn + 0.5) * 360.0 / MapColumns - 180.0;
constexpr double SunElevation = 90.0 - (SunRow + 0.5) * 180.0 / MapRows;

std::string WriteSunMap()
{
  const std::string name = std::string(SKYLINE_TEST_OUTPUT) + "/sun.hdr";
  std::ofstream file(name, std::ios::binary);
  file << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " << MapRows << " +X " << MapColumns << "\n";
  for (int row = 0; row < MapRows; ++row)
  {
    for (int column = 0; column < MapColumns; ++column)
    {
      const bool sun = row == SunRow && column == SunColumn;
      const unsigned char pixel[4] = { 128, 128, 128, static_cast<unsigned char>(sun ? 138 : 125) };
      file.write(reinterpret_cast<const char*>(pixel), 4);
    }
  }
  return name;
}

class ViewerSky : public ViewerTest
{
protected:
  // Looks from high above the terrain in a direction, degrees.
  void Look(double azimuth, double elevation)
  {
    const double a = azimuth * RadiansPerDegree;
    const double e = elevation * RadiansPerDegree;
    const double* bounds = this->View->GetScene().GetHeights()->GetBounds();
    const ScenePoint eye{ { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 2.0e4 } };
    vtkCamera* camera = this->View->GetScene().GetRenderer()->GetActiveCamera();
    camera->SetPosition(eye.data());
    camera->SetFocalPoint(eye[0] + 1.0e4 * std::cos(e) * std::sin(a),
      eye[1] + 1.0e4 * std::cos(e) * std::cos(a), eye[2] + 1.0e4 * std::sin(e));
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->View->Expose();
    this->Rest();
  }

  // The position of the brightest pixels in the middle of the picture, relative to its centre.
  std::array<double, 2> Brightest()
  {
    vtkNew<vtkUnsignedCharArray> pixels;
    const int x0 = 160;
    const int x1 = 479;
    const int y0 = 120;
    const int y1 = 279;
    this->Window->GetPixelData(x0, y0, x1, y1, 0, pixels, 0);
    std::array<double, 2> sum{ { 0.0, 0.0 } };
    double weights = 0.0;
    double peak = 0.0;
    for (vtkIdType k = 0; k < pixels->GetNumberOfTuples(); ++k)
    {
      peak = std::max(peak, pixels->GetComponent(k, 1));
    }
    for (vtkIdType k = 0; k < pixels->GetNumberOfTuples(); ++k)
    {
      const double weight = std::max(0.0, pixels->GetComponent(k, 1) - 0.8 * peak);
      sum[0] += weight * (static_cast<double>(x0 + k % (x1 - x0 + 1)) + 0.5 - 0.5 * Width);
      sum[1] += weight * (static_cast<double>(y0 + k / (x1 - x0 + 1)) + 0.5 - 0.5 * Height);
      weights += weight;
    }
    EXPECT_GT(peak, 230.0);
    return { { sum[0] / weights, sum[1] / weights } };
  }

  // The sum over the terrain of its light times the direction of its downward slope.
  std::array<double, 2> LitSlopes()
  {
    vtkImageData* lit = this->View->GetScene().GetShader()->GetHeightField();
    vtkDataArray* light = lit->GetPointData()->GetArray("Radiance");
    const int* size = lit->GetDimensions();
    std::array<double, 2> sum{ { 0.0, 0.0 } };
    vtkDataArray* heights = lit->GetPointData()->GetArray("Elevation");
    for (vtkIdType row = 1; row + 1 < size[1]; ++row)
    {
      for (vtkIdType column = 1; column + 1 < size[0]; ++column)
      {
        const vtkIdType post = row * size[0] + column;
        const double weight = light->GetComponent(post, 1);
        const double east = heights->GetComponent(post - 1, 0) - heights->GetComponent(post + 1, 0);
        const double north =
          heights->GetComponent(post - size[0], 0) - heights->GetComponent(post + size[0], 0);
        if (std::isfinite(weight * (east + north)))
        {
          sum[0] += weight * east;
          sum[1] += weight * north;
        }
      }
    }
    return sum;
  }
};

TEST_F(ViewerSky, SunOfAMapStandsWhereItsLightComesFrom)
{
  ViewerOptions options = Quick();
  options.Lights.Sun.Time.clear();
  options.Lights.Sky = SkyOfFile(WriteSunMap());
  this->Open(options);
  for (int k = 0; k < 3; ++k)
  {
    this->View->KeyPress('R', Plain); // to 30 degrees
  }
  this->Look(SunAzimuth + 30.0, SunElevation);
  const auto place = this->Brightest();
  EXPECT_NEAR(place[0], 0.0, PlaceTolerance);
  EXPECT_NEAR(place[1], 0.0, PlaceTolerance);

  // The light of the map, compared with that of the map turned by 180 degrees, so that colours have
  // no effect.
  const auto here = this->LitSlopes();
  for (int k = 0; k < 18; ++k)
  {
    this->View->KeyPress('R', Plain);
  }
  this->Rest();
  const auto there = this->LitSlopes();
  const double azimuth = std::atan2(here[0] - there[0], here[1] - there[1]) / RadiansPerDegree;
  EXPECT_NEAR(std::remainder(azimuth - SunAzimuth - 30.0, 360.0), 0.0, SlopeTolerance);
}

TEST_F(ViewerSky, SunsDiscStandsInItsDirection)
{
  ViewerOptions options = Quick();
  options.Lights.Sun.Time.clear();
  options.Lights.Sun.Direction = SunAngles{ 250.0, 20.0 };
  this->Open(options);
  this->Look(250.0, 20.0);
  const auto place = this->Brightest();
  EXPECT_NEAR(place[0], 0.0, PlaceTolerance);
  EXPECT_NEAR(place[1], 0.0, PlaceTolerance);
}

TEST_F(ViewerSky, NightIsDarkButNotBlack)
{
  ViewerOptions options = Quick();
  options.Lights.Sun.Time.clear();
  options.Lights.Sun.Direction = SunAngles{ 0.0, 20.0 };
  this->Open(options);
  const auto ground = [this] { return Brightness(this->Window, 220, 140, 420, 240); };
  const double day = ground();
  this->View->GetState().Elevation = -20.0;
  this->Rest();
  const double night = ground();
  EXPECT_LT(night, 0.5 * day);
  EXPECT_GT(night, 8.0);
  EXPECT_NE(this->View->GetHud().Status.find("exposure auto"), std::string::npos);
  this->View->KeyPress('A', Plain);
  this->View->GetState().Elevation = 20.0;
  this->Rest();
  EXPECT_GT(ground(), 1.3 * day) << "the night's exposure by day";
  EXPECT_NE(this->View->GetHud().Status.find("exposure fixed"), std::string::npos);
}

// A pixel of the scale bar, compared with two positions on the ground near the middle of the
// picture.
TEST_F(ViewerSky, ScaleBarHoldsInTheMiddle)
{
  this->Open();
  this->View->MouseMove(300, 250);
  this->DragTo(330, 290, MouseButton::Middle); // away from the middle of the terrain
  this->Rest();
  ScenePoint west;
  ScenePoint east;
  const double step = 3.0;
  ASSERT_TRUE(this->View->GetScene().FindPlace(0.5 * Width - step, 0.5 * Height, west));
  ASSERT_TRUE(this->View->GetScene().FindPlace(0.5 * Width + step, 0.5 * Height, east));
  const double across = std::abs(east[0] - west[0]); // the camera looks north
  EXPECT_NEAR(
    this->View->GetHud().MetresPerPixel, across / (2.0 * step), 0.03 * across / (2.0 * step));
}

} // namespace
} // namespace testing
} // namespace skyline
