// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/CubeMap.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace skyline
{

namespace
{

/// Number of directions along each side of a pixel of the converted map. A pixel at the corner of a
/// face then contains at least 20 of them.
constexpr int Samples = 8;

enum Side
{
  East,
  West,
  Up,
  Down,
  North,
  South
};

/// The position of a face in the image, in faces from the top left, and whether it is upside down.
struct Place
{
  int Column, Row;
  bool Turned;
};

Place FindPlace(CubeLayout layout, Side side)
{
  constexpr Place verticalCross[6] = { { 2, 1, false }, { 0, 1, false }, { 1, 0, false },
    { 1, 2, false }, { 1, 1, false }, { 1, 3, true } };
  constexpr Place horizontalCross[6] = { { 2, 1, false }, { 0, 1, false }, { 1, 0, false },
    { 1, 2, false }, { 1, 1, false }, { 3, 1, false } };
  switch (layout)
  {
    case CubeLayout::VerticalStrip:
      // The X axis of OpenEXR points west. Its faces up and down have west to the right, rotated by
      // half a turn from those of the crosses.
      return { 0, side == East ? 1 : side == West ? 0 : side, side == Up || side == Down };
    case CubeLayout::HorizontalStrip:
      return { side, 0, false };
    case CubeLayout::HorizontalCross:
      return horizontalCross[side];
    default:
      return verticalCross[side];
  }
}

/// An upright face, oriented as in the crosses: the lower edge of the face up, and the upper edge
/// of the face down, touch north.
struct FaceView
{
  const float* First;          ///< the pixel at the top left
  std::ptrdiff_t Right, Below; ///< floats to the next pixel
};

using FaceViews = std::array<FaceView, 6>;

FaceViews ViewFaces(const CubeMap& cube)
{
  FaceViews faces;
  for (const Side side : { East, West, Up, Down, North, South })
  {
    const Place place = FindPlace(cube.Layout, side);
    const std::ptrdiff_t turned = place.Turned ? cube.Size - 1 : 0;
    faces[side].First = cube.Values + (place.Row * cube.Size + turned) * cube.RowStride +
      3 * (place.Column * cube.Size + turned);
    faces[side].Right = place.Turned ? -3 : 3;
    faces[side].Below = place.Turned ? -cube.RowStride : cube.RowStride;
  }
  return faces;
}

struct FacePoint
{
  Side Face;
  double Right, Below; ///< position on the upright face, -1 to 1
};

/// The point where a direction meets the cube.
FacePoint Meet(double x, double y, double z)
{
  const double east = std::abs(x), north = std::abs(y), up = std::abs(z);
  if (north >= east && north >= up)
  {
    return { y > 0.0 ? North : South, x / y, -z / north };
  }
  if (east >= up)
  {
    return { x > 0.0 ? East : West, -y / x, -z / east };
  }
  return { z > 0.0 ? Up : Down, x / up, y / z };
}

/// Interpolates radiance bilinearly between the centres of pixels. Within half a pixel of the edges
/// of a face it is constant, so that each pixel keeps its share of the whole.
void Interpolate(const FaceViews& faces, double size, const FacePoint& point, double* sum)
{
  const FaceView& face = faces[point.Face];
  const double u = std::clamp((0.5 + 0.5 * point.Right) * size - 0.5, 0.0, size - 1.0);
  const double v = std::clamp((0.5 + 0.5 * point.Below) * size - 0.5, 0.0, size - 1.0);
  const auto column = static_cast<std::ptrdiff_t>(u);
  const auto row = static_cast<std::ptrdiff_t>(v);
  const double s = u - static_cast<double>(column), t = v - static_cast<double>(row);
  const float* corner = face.First + row * face.Below + column * face.Right;
  const std::ptrdiff_t right = s > 0.0 ? face.Right : 0; // the last pixel has no neighbour
  const std::ptrdiff_t below = t > 0.0 ? face.Below : 0;
  for (int c = 0; c < 3; ++c)
  {
    // With this form, equal corners give exactly their value.
    const double upper = corner[c] + s * (double(corner[right + c]) - corner[c]);
    const double lower =
      corner[below + c] + s * (double(corner[below + right + c]) - corner[below + c]);
    sum[c] += upper + t * (lower - upper);
  }
}

/// Solid angle of the part [0, u] x [0, v] of a face at distance 1: atan(u v / sqrt(1 + u^2 + v^2)).
double CornerAngle(double u, double v)
{
  return std::atan2(u * v, std::sqrt(1.0 + u * u + v * v));
}

} // namespace

bool FindCubeLayout(
  std::ptrdiff_t columns, std::ptrdiff_t rows, CubeLayout& layout, std::ptrdiff_t& size)
{
  struct Shape
  {
    CubeLayout Layout;
    std::ptrdiff_t Across, Down;
  };
  constexpr Shape shapes[] = { { CubeLayout::VerticalStrip, 1, 6 },
    { CubeLayout::HorizontalStrip, 6, 1 }, { CubeLayout::HorizontalCross, 4, 3 },
    { CubeLayout::VerticalCross, 3, 4 } };
  for (const Shape& shape : shapes)
  {
    if (columns > 0 && columns % shape.Across == 0 && columns / shape.Across * shape.Down == rows)
    {
      layout = shape.Layout;
      size = columns / shape.Across;
      return true;
    }
  }
  return false;
}

bool UnusedPixelsAlike(const CubeMap& cube)
{
  if (cube.Layout == CubeLayout::VerticalStrip || cube.Layout == CubeLayout::HorizontalStrip)
  {
    return true;
  }
  const bool lying = cube.Layout == CubeLayout::HorizontalCross;
  const std::ptrdiff_t across = lying ? 4 : 3, down = lying ? 3 : 4;
  for (std::ptrdiff_t row = 0; row < down * cube.Size; ++row)
  {
    const float* pixels = cube.Values + row * cube.RowStride;
    for (std::ptrdiff_t column = 0; column < across * cube.Size; ++column)
    {
      // In both crosses, the second column and the second row contain faces.
      const bool face = column / cube.Size == 1 || row / cube.Size == 1;
      if (!face && !std::equal(cube.Values, cube.Values + 3, pixels + 3 * column))
      {
        return false;
      }
    }
  }
  return true;
}

std::array<double, 3> CubeEnergy(const CubeMap& cube)
{
  const FaceViews faces = ViewFaces(cube);
  std::array<double, 3> energy{};
  for (std::ptrdiff_t row = 0; row < cube.Size; ++row)
  {
    for (std::ptrdiff_t column = 0; column < cube.Size; ++column)
    {
      const double left = 2.0 * column / cube.Size - 1.0,
                   right = 2.0 * (column + 1) / cube.Size - 1.0;
      const double top = 2.0 * row / cube.Size - 1.0, bottom = 2.0 * (row + 1) / cube.Size - 1.0;
      const double solid = CornerAngle(right, bottom) - CornerAngle(left, bottom) -
        CornerAngle(right, top) + CornerAngle(left, top);
      for (const FaceView& face : faces)
      {
        const float* pixel = face.First + row * face.Below + column * face.Right;
        for (int c = 0; c < 3; ++c)
        {
          energy[c] += solid * pixel[c];
        }
      }
    }
  }
  return energy;
}

void CubeToLightMap(const CubeMap& cube, std::ptrdiff_t columns, std::ptrdiff_t rows,
  std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, float* pixels)
{
  const FaceViews faces = ViewFaces(cube);
  const auto size = static_cast<double>(cube.Size);
  const double height = Pi / (rows * Samples), width = 2.0 * Pi / (columns * Samples);
  std::vector<double> circle; // sine and cosine of each azimuth
  circle.reserve(static_cast<std::size_t>(2 * columns * Samples));
  for (std::ptrdiff_t j = 0; j < columns * Samples; ++j)
  {
    circle.push_back(std::sin((j + 0.5) * width - Pi));
    circle.push_back(std::cos((j + 0.5) * width - Pi));
  }
  for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
  {
    for (std::ptrdiff_t column = 0; column < columns; ++column)
    {
      double sum[3] = {}, weights = 0.0;
      for (int i = 0; i < Samples; ++i)
      {
        const double polar = (row * Samples + i + 0.5) * height;
        const double level = std::sin(polar), z = std::cos(polar);
        double part[3] = {};
        for (int j = 0; j < Samples; ++j)
        {
          const double* azimuth = &circle[static_cast<std::size_t>(2 * (column * Samples + j))];
          Interpolate(faces, size, Meet(level * azimuth[0], level * azimuth[1], z), part);
        }
        for (int c = 0; c < 3; ++c)
        {
          sum[c] += level * part[c];
        }
        weights += Samples * level;
      }
      for (int c = 0; c < 3; ++c)
      {
        pixels[3 * (row * columns + column) + c] = static_cast<float>(sum[c] / weights);
      }
    }
  }
}

void KeepEnergy(
  const std::array<double, 3>& energy, std::ptrdiff_t columns, std::ptrdiff_t rows, float* pixels)
{
  const LightMap map = ViewTopDown(pixels, columns, rows);
  double now[3] = {};
  for (std::ptrdiff_t row = 0; row < rows; ++row)
  {
    double sum[3] = {};
    for (std::ptrdiff_t column = 0; column < columns; ++column)
    {
      const float* pixel = map.Pixel(row, column);
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += pixel[c];
      }
    }
    const double solid = PixelSolidAngle(map, row);
    for (int c = 0; c < 3; ++c)
    {
      now[c] += solid * sum[c];
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    const double scale = now[c] > 0.0 ? energy[c] / now[c] : 1.0;
    // A difference due only to the rounding of sums is ignored, so that uniform light stays exactly
    // uniform.
    if (std::abs(scale - 1.0) < 1.0e-9)
    {
      continue;
    }
    for (std::ptrdiff_t i = c; i < 3 * columns * rows; i += 3)
    {
      pixels[i] = static_cast<float>(pixels[i] * scale);
    }
  }
}

} // namespace skyline
