// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/CubeMap.h"

#include "LightMapTesting.h"
#include "Shared/Constants.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

/// The error of sums of some thousand pixels in double precision.
constexpr double SumBound = 1.0e-10;

/// The position of a face in the image, and the direction (east, north, up) of its pixel at u to
/// the right of the centre and v below it, both -1 to 1.
struct Face
{
  int Column, Row;
  LightMapDirection (*Direction)(double u, double v);
};

/// The four layouts, face by face, from the descriptions in CubeMap.h and in OpenEXR's ImfEnvmap.h:
/// X west, Y up, Z north.
const std::vector<Face>& Faces(CubeLayout layout)
{
  static const std::vector<Face> vertical{
    { 0, 0,
      [](double u, double v) {
        return LightMapDirection{ -1, u, -v };
      } }, // +X: (1, -v, u)
    { 0, 1,
      [](double u, double v) {
        return LightMapDirection{ 1, -u, -v };
      } }, // -X: (-1, -v, -u)
    { 0, 2,
      [](double u, double v) {
        return LightMapDirection{ -u, -v, 1 };
      } }, // +Y: (u, 1, -v)
    { 0, 3,
      [](double u, double v) {
        return LightMapDirection{ -u, v, -1 };
      } }, // -Y: (u, -1, v)
    { 0, 4,
      [](double u, double v) {
        return LightMapDirection{ u, 1, -v };
      } }, // +Z: (-u, -v, 1)
    { 0, 5,
      [](double u, double v) {
        return LightMapDirection{ -u, -1, -v };
      } } // -Z: (u, -v, -1)
  };
  const auto east = [](double u, double v) { return LightMapDirection{ 1, -u, -v }; };
  const auto west = [](double u, double v) { return LightMapDirection{ -1, u, -v }; };
  const auto up = [](double u, double v) { return LightMapDirection{ u, v, 1 }; };
  const auto down = [](double u, double v) { return LightMapDirection{ u, -v, -1 }; };
  const auto north = [](double u, double v) { return LightMapDirection{ u, 1, -v }; };
  const auto south = [](double u, double v) { return LightMapDirection{ -u, -1, -v }; };
  const auto turned = [](double u, double v) { return LightMapDirection{ u, -1, v }; };
  static const std::vector<Face> horizontal{ { 0, 0, east }, { 1, 0, west }, { 2, 0, up },
    { 3, 0, down }, { 4, 0, north }, { 5, 0, south } };
  static const std::vector<Face> lying{ { 2, 1, east }, { 0, 1, west }, { 1, 0, up },
    { 1, 2, down }, { 1, 1, north }, { 3, 1, south } };
  static const std::vector<Face> upright{ { 2, 1, east }, { 0, 1, west }, { 1, 0, up },
    { 1, 2, down }, { 1, 1, north }, { 1, 3, turned } };
  switch (layout)
  {
    case CubeLayout::VerticalStrip:
      return vertical;
    case CubeLayout::HorizontalStrip:
      return horizontal;
    case CubeLayout::HorizontalCross:
      return lying;
    default:
      return upright;
  }
}

struct OwnedCube
{
  OwnedCube(CubeLayout layout, std::ptrdiff_t size)
    : Layout(layout)
    , Size(size)
  {
    const bool strip = layout == CubeLayout::VerticalStrip;
    this->Across = strip                      ? 1
      : layout == CubeLayout::HorizontalStrip ? 6
      : layout == CubeLayout::HorizontalCross ? 4
                                              : 3;
    this->Down = strip                        ? 6
      : layout == CubeLayout::HorizontalStrip ? 1
      : layout == CubeLayout::HorizontalCross ? 3
                                              : 4;
    this->Values.resize(static_cast<std::size_t>(3 * this->Across * this->Down * size * size));
  }

  float* Pixel(std::ptrdiff_t row, std::ptrdiff_t column)
  {
    return &this->Values[static_cast<std::size_t>(3 * (row * this->Across * this->Size + column))];
  }

  /// Sets each pixel of a face to radiance(direction at the pixel's centre, channel).
  template <typename Radiance>
  void Paint(const Radiance& radiance)
  {
    for (const Face& face : Faces(this->Layout))
    {
      for (std::ptrdiff_t row = 0; row < this->Size; ++row)
      {
        for (std::ptrdiff_t column = 0; column < this->Size; ++column)
        {
          LightMapDirection d = face.Direction(
            (2.0 * column + 1.0) / this->Size - 1.0, (2.0 * row + 1.0) / this->Size - 1.0);
          const double length = std::sqrt(d.X * d.X + d.Y * d.Y + d.Z * d.Z);
          d = { d.X / length, d.Y / length, d.Z / length };
          for (int c = 0; c < 3; ++c)
          {
            this->Pixel(face.Row * this->Size + row, face.Column * this->Size + column)[c] =
              static_cast<float>(radiance(d, c));
          }
        }
      }
    }
  }

  CubeMap View() const
  {
    return { this->Values.data(), 3 * this->Across * this->Size, this->Size, this->Layout };
  }

  CubeLayout Layout;
  std::ptrdiff_t Size, Across, Down;
  std::vector<float> Values;
};

OwnedMap Convert(const CubeMap& cube)
{
  OwnedMap map(4 * cube.Size, 2 * cube.Size);
  CubeToLightMap(cube, map.Columns, map.Rows, map.Rows / 3, map.Rows, map.Values.data());
  CubeToLightMap(cube, map.Columns, map.Rows, 0, map.Rows / 3, map.Values.data());
  return map;
}

/// A smooth function that differs at all sides and edges.
double Smooth(const LightMapDirection& d, int channel)
{
  return 2.0 + 0.7 * d.X + 0.4 * d.Y - 0.5 * d.Z + 0.3 * channel * d.X * d.Y + 0.2 * d.Y * d.Z;
}

class CubeMapLayouts : public ::testing::TestWithParam<CubeLayout>
{
};

std::string LayoutName(const ::testing::TestParamInfo<CubeLayout>& layout)
{
  const char* names[] = { "VerticalStrip", "HorizontalStrip", "HorizontalCross", "VerticalCross" };
  return names[static_cast<int>(layout.param)];
}

TEST_P(CubeMapLayouts, EveryFaceIsWhereItBelongs)
{
  OwnedCube cube(GetParam(), 32);
  cube.Paint(Smooth);
  const OwnedMap map = Convert(cube.View());
  const LightMap view = map.View();
  // Half a pixel of a face is 1/32. Beside an edge the radiance is that of the last pixel centre.
  const double pixelBound = 1.5 / 32.0;
  for (std::ptrdiff_t row = 0; row < view.Rows; ++row)
  {
    for (std::ptrdiff_t column = 0; column < view.Columns; ++column)
    {
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(
          view.Pixel(row, column)[c], Smooth(PixelDirection(view, row, column), c), pixelBound)
          << row << " " << column << " " << c;
      }
    }
  }
}

TEST_P(CubeMapLayouts, LayoutIsFound)
{
  const OwnedCube cube(GetParam(), 5);
  CubeLayout layout;
  std::ptrdiff_t size = 0;
  ASSERT_TRUE(FindCubeLayout(5 * cube.Across, 5 * cube.Down, layout, size));
  EXPECT_EQ(layout, GetParam());
  EXPECT_EQ(size, 5);
}

TEST_P(CubeMapLayouts, UniformLightStaysUniform)
{
  for (const std::ptrdiff_t size : { 1, 2, 7 })
  {
    OwnedCube cube(GetParam(), size);
    cube.Paint([](const LightMapDirection&, int channel) { return 0.1 + channel; });
    const std::array<double, 3> energy = CubeEnergy(cube.View());
    OwnedMap map = Convert(cube.View());
    KeepEnergy(energy, map.Columns, map.Rows, map.Values.data());
    for (std::size_t i = 0; i < map.Values.size(); ++i)
    {
      EXPECT_EQ(map.Values[i], static_cast<float>(0.1 + static_cast<double>(i % 3)));
    }
    EXPECT_NEAR(energy[1], 4.0 * Pi * static_cast<double>(1.1f), SumBound);
  }
}

// A sun in one pixel, anywhere on a face: the converted map has all of its energy, in the same
// direction.
TEST_P(CubeMapLayouts, HugeSunKeepsItsEnergy)
{
  for (const Face& face : Faces(GetParam()))
  {
    for (const auto& [row, column] :
      { std::array<int, 2>{ 0, 0 }, { 15, 16 }, { 31, 7 }, { 10, 31 } })
    {
      OwnedCube cube(GetParam(), 32);
      cube.Paint([](const LightMapDirection&, int) { return 1.0; });
      cube.Pixel(face.Row * 32 + row, face.Column * 32 + column)[1] = 1.0e5f;
      const std::array<double, 3> energy = CubeEnergy(cube.View());
      OwnedMap map = Convert(cube.View());
      // Interpolation alone has errors of some thousandths, and more at the poles of the map.
      EXPECT_NEAR(Energy(map.View())[1] / energy[1], 1.0, 2.0e-2) << row << " " << column;
      KeepEnergy(energy, map.Columns, map.Rows, map.Values.data());
      const double floatBound = 1.0e-6;
      EXPECT_NEAR(Energy(map.View())[1] / energy[1], 1.0, floatBound);
      EXPECT_NEAR(Energy(map.View())[0] / energy[0], 1.0, floatBound);

      const std::vector<double> light = ProjectLightMap(map.View(), 2);
      const LightMapDirection d =
        face.Direction((2.0 * column + 1.0) / 32.0 - 1.0, (2.0 * row + 1.0) / 32.0 - 1.0);
      const double length = std::sqrt(d.X * d.X + d.Y * d.Y + d.Z * d.Z);
      const double mean =
        std::sqrt(light[5] * light[5] + light[6] * light[6] + light[7] * light[7]);
      const double pixelBound = 1.0 / 32.0; // at the edge of a face a sun can move by half a pixel
      EXPECT_NEAR(light[4 + 3] / mean, d.X / length, pixelBound);
      EXPECT_NEAR(light[4 + 1] / mean, d.Y / length, pixelBound);
      EXPECT_NEAR(light[4 + 2] / mean, d.Z / length, pixelBound);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Layouts, CubeMapLayouts,
  ::testing::Values(CubeLayout::VerticalStrip, CubeLayout::HorizontalStrip,
    CubeLayout::HorizontalCross, CubeLayout::VerticalCross),
  LayoutName);

TEST(CubeMap, OtherShapesAreNone)
{
  CubeLayout layout;
  std::ptrdiff_t size = 0;
  for (const auto& [columns, rows] : { std::array<int, 2>{ 8, 4 }, { 0, 0 }, { 1, 5 }, { 7, 1 },
         { 5, 4 }, { 4, 4 }, { 13, 2 }, { 6, 5 } })
  {
    EXPECT_FALSE(FindCubeLayout(columns, rows, layout, size)) << columns << " x " << rows;
  }
}

TEST(CubeMap, APhotographIsNoCross)
{
  for (const CubeLayout layout : { CubeLayout::HorizontalCross, CubeLayout::VerticalCross })
  {
    OwnedCube cube(layout, 4);
    cube.Paint(Smooth);
    EXPECT_TRUE(UnusedPixelsAlike(cube.View()));
    cube.Pixel(cube.Down * 4 - 1, cube.Across * 4 - 1)[2] = 0.1f;
    EXPECT_FALSE(UnusedPixelsAlike(cube.View()));
  }
  OwnedCube strip(CubeLayout::VerticalStrip, 4);
  strip.Paint(Smooth);
  EXPECT_TRUE(UnusedPixelsAlike(strip.View()));
}

} // namespace
} // namespace testing
} // namespace skyline
