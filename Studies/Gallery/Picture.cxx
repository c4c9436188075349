// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Color/ToneMap.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace skyline
{
namespace gallery
{

namespace
{

// The ends of the colour scale of differences, in linear light.
constexpr std::array<double, 3> TooBright{ { 0.75, 0.01, 0.02 } };
constexpr std::array<double, 3> TooDark{ { 0.01, 0.08, 0.70 } };

constexpr int Dpi = 72; // makes a point of the font one pixel

bool DrawText(const std::string& text, int size, vtkImageData* image, std::array<int, 2>& drawn)
{
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  if (!renderer || text.empty())
  {
    return false;
  }
  renderer->SetScaleToPowerOfTwo(false);
  vtkNew<vtkTextProperty> style;
  style->SetFontFamilyToArial();
  style->SetFontSize(size);
  style->SetColor(0.0, 0.0, 0.0);
  return renderer->RenderString(style, text, image, drawn.data(), Dpi);
}

} // namespace

void Paste(Picture& picture, const Picture& part, int x, int y)
{
  const int width = std::min(part.Width, picture.Width - x);
  const int height = std::min(part.Height, picture.Height - y);
  for (int row = 0; row < height && width > 0; ++row)
  {
    std::copy_n(part.At(0, row), 3 * width, picture.At(x, y + row));
  }
}

int TextWidth(const std::string& text, int size)
{
  vtkNew<vtkImageData> image;
  std::array<int, 2> drawn{};
  return DrawText(text, size, image, drawn) ? drawn[0] : 0;
}

void WriteText(Picture& picture, const std::string& text, int x, int y, int size)
{
  vtkNew<vtkImageData> image;
  std::array<int, 2> drawn{};
  if (!DrawText(text, size, image, drawn))
  {
    return;
  }
  // The pixels are relative to the anchor at (0, 0). Descenders lie below it.
  std::array<int, 6> extent{};
  image->GetExtent(extent.data());
  for (int j = extent[2]; j <= extent[3]; ++j)
  {
    for (int i = extent[0]; i <= extent[1]; ++i)
    {
      if (x + i < 0 || y + j < 0 || x + i >= picture.Width || y + j >= picture.Height)
      {
        continue;
      }
      const auto* ink = static_cast<const unsigned char*>(image->GetScalarPointer(i, j, 0));
      unsigned char* to = picture.At(x + i, y + j);
      for (int c = 0; c < 3; ++c)
      {
        to[c] = static_cast<unsigned char>((to[c] * (255 - ink[3]) + ink[c] * ink[3]) / 255);
      }
    }
  }
}

Picture DifferenceMap(
  const std::vector<float>& values, int columns, int rows, double full, int width, int height)
{
  const auto range = [](int pixel, int pixels, int posts)
  {
    const int begin = static_cast<int>(static_cast<std::int64_t>(pixel) * posts / pixels);
    const int end = static_cast<int>(static_cast<std::int64_t>(pixel + 1) * posts / pixels);
    return std::array<int, 2>{ { begin, std::max(end, begin + 1) } };
  };
  Picture map(width, height, 0);
  for (int y = 0; y < height; ++y)
  {
    const auto north = range(y, height, rows);
    for (int x = 0; x < width; ++x)
    {
      const auto east = range(x, width, columns);
      double sum = 0.0;
      for (int row = north[0]; row < north[1]; ++row)
      {
        for (int column = east[0]; column < east[1]; ++column)
        {
          sum += static_cast<double>(values[static_cast<std::size_t>(row) * columns + column]);
        }
      }
      const double mean = sum / ((north[1] - north[0]) * (east[1] - east[0]));
      const double part = std::min(std::abs(mean) / full, 1.0);
      const auto& end = mean > 0.0 ? TooBright : TooDark;
      for (std::size_t c = 0; c < 3; ++c)
      {
        map.At(x, y)[c] = SrgbByte(static_cast<float>(0.96 + part * (end[c] - 0.96)));
      }
    }
  }
  return map;
}

bool WritePng(const Picture& picture, const std::string& path)
{
  vtkNew<vtkUnsignedCharArray> codes;
  codes->SetNumberOfComponents(3);
  codes->SetNumberOfTuples(static_cast<vtkIdType>(picture.Width) * picture.Height);
  std::copy(picture.Codes.begin(), picture.Codes.end(), codes->GetPointer(0));
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.Width, picture.Height, 1);
  image->GetPointData()->SetScalars(codes);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->SetCompressionLevel(9);
  writer->Write();
  return writer->GetErrorCode() == 0;
}

} // namespace gallery
} // namespace skyline
