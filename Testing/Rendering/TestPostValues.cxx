// SPDX-License-Identifier: BSD-3-Clause
// The gradients that the mapper shades with.
#include "PostValues.h"

#include "Data/ImageGeoreference.h"
#include "Reference/FieldImage.h"
#include "Reference/Shapes.h"
#include "Testing/Module/Geo/Places.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <GeographicLib/TransverseMercator.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

// The relative error that distances on the ground may have: DistanceTolerance of GroundMetric.h.
constexpr double ScaleBound = 1e-3;

// 1500 km from its meridian, UTM is 2.8 % too large. The map is conformal, so the slope of a plane
// on the map is multiplied by the scale of the map.
TEST(PostValues, GradientsAreThoseOnTheGround)
{
  constexpr int side = 21;
  constexpr double step = 100.0, x = 1.5e6, y = 5.0e6;
  const auto image = ImageOf<vtkFloatArray>(shapes::Plane(side, side, step, 0.3, -0.2));
  StoreGeoreference(OnMap(Utm(9.0), x, y, step, step, side, side), image);
  double latitude = 0.0, longitude = 0.0, convergence = 0.0, scale = 0.0;
  GeographicLib::TransverseMercator::UTM().Reverse(
    9.0, x + 1000.0, y + 1000.0, latitude, longitude, convergence, scale);
  ASSERT_GT(scale, 1.02);

  const std::vector<float> gradients = PostGradients(image, image->GetPointData()->GetScalars());
  ASSERT_EQ(gradients.size(), 2u * side * side);
  const double expected = scale * std::hypot(0.3, 0.2);
  for (std::size_t post = 0; post < gradients.size() / 2; ++post)
  {
    EXPECT_NEAR(
      std::hypot(gradients[2 * post], gradients[2 * post + 1]), expected, ScaleBound * expected);
  }
}

} // namespace
} // namespace testing
} // namespace skyline
