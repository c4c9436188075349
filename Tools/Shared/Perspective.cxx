// SPDX-License-Identifier: BSD-3-Clause
#include "Perspective.h"

#include "CameraFit.h"
#include "Color/ToneMap.h"
#include "Failure.h"
#include "OffscreenWindow.h"
#include "TerrainActors.h"
#include "Values.h"

#include "vtkCamera.h"
#include "vtkHeightFieldSurface.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSkylineSoftShadowPolyDataMapper.h"
#include "vtkUnsignedCharArray.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

namespace
{

/// Each pixel is the mean of this many columns and rows of samples. This gives smooth edges, and no
/// shimmer where many posts share a pixel.
constexpr int Samples = 2;

/// With Samples, this is the largest framebuffer that every OpenGL supports.
constexpr int LargestSide = 8192;

std::string CheckSize(const std::string& text)
{
  const std::string cure = "; give WxH, 1x1 to " + std::to_string(LargestSide) + "x" +
    std::to_string(LargestSide) + " pixels";
  const auto sides = skyline::ReadNumbers(text, 'x');
  if (!sides || sides->size() != 2 || (*sides)[0] != std::floor((*sides)[0]) ||
    (*sides)[1] != std::floor((*sides)[1]))
  {
    return text + " is not a size" + cure;
  }
  const auto [least, most] = std::minmax((*sides)[0], (*sides)[1]);
  return least < 1.0 || most > LargestSide ? text + " is out of range" + cure : "";
}

std::string CheckFrom(const std::string& text)
{
  const auto numbers = skyline::ReadNumbers(text);
  if (!numbers || numbers->size() != 2)
  {
    return (numbers ? text + " is not a direction" : skyline::NumbersError(text)) +
      "; give two numbers AZ,EL";
  }
  return (*numbers)[1] < 0.0 || (*numbers)[1] > 90.0
    ? "elevation " + skyline::NumberText((*numbers)[1]) + " is out of range; give 0 to 90 degrees"
    : "";
}

// Averages blocks of samples in linear light.
vtkSmartPointer<vtkImageData> Reduce(vtkUnsignedCharArray* samples, int width, int height)
{
  std::array<float, 256> linear{};
  for (std::size_t code = 0; code < linear.size(); ++code)
  {
    linear[code] = skyline::DecodeSrgb(static_cast<float>(code) / 255.0f);
  }
  vtkNew<vtkUnsignedCharArray> picture;
  picture->SetName("Picture");
  picture->SetNumberOfComponents(4);
  picture->SetNumberOfTuples(static_cast<vtkIdType>(width) * height);
  const unsigned char* from = samples->GetPointer(0);
  unsigned char* to = picture->GetPointer(0);
  const std::size_t line = 3 * static_cast<std::size_t>(width) * Samples;
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column, to += 4)
    {
      const unsigned char* block = from + Samples * static_cast<std::size_t>(row) * line +
        3 * Samples * static_cast<std::size_t>(column);
      for (std::size_t c = 0; c < 3; ++c)
      {
        float sum = 0.0f;
        for (std::size_t k = 0; k < Samples * Samples; ++k)
        {
          sum += linear[block[(k / Samples) * line + 3 * (k % Samples) + c]];
        }
        to[c] = skyline::SrgbByte(sum / (Samples * Samples));
      }
      to[3] = 255;
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->GetPointData()->SetScalars(picture);
  return image;
}

} // namespace

namespace skyline
{

void PerspectiveOptions::AddTo(CLI::App& command)
{
  command
    .add_option("--from", this->From,
      "Perspective: direction of the viewer from the terrain, azimuth and elevation in degrees;\n"
      "elevation 0 to 90")
    ->type_name("AZ,EL")
    ->check(Checked(CheckFrom))
    ->capture_default_str();
  command
    .add_option("--size", this->Size,
      "Perspective: width and height of the picture in pixels, 1x1 to 8192x8192")
    ->type_name("WxH")
    ->check(Checked(CheckSize))
    ->capture_default_str();
}

void PerspectiveOptions::Read(int& width, int& height, double& azimuth, double& elevation) const
{
  const auto size = *ReadNumbers(this->Size, 'x');
  width = static_cast<int>(size[0]);
  height = static_cast<int>(size[1]);
  const auto from = *ReadNumbers(this->From);
  azimuth = std::fmod(from[0], 360.0);
  elevation = from[1];
}

vtkSmartPointer<vtkImageData> DrawPerspective(vtkImageData* terrain, const PerspectiveLight& light,
  const PerspectiveOptions& options, const CommonOptions& common)
{
  std::string reason;
  const vtkSmartPointer<vtkRenderWindow> window = MakeOffscreenWindow(reason);
  if (!window)
  {
    throw Failure("a perspective view needs OpenGL: " + reason + "; --view map does not need it");
  }
  int width = 0;
  int height = 0;
  Standpoint standpoint;
  options.Read(width, height, standpoint.Azimuth, standpoint.Elevation);

  const auto surface = MakeMesh(terrain, MostMeshPosts);
  RunPass(surface, "mesh", common);
  vtkPolyData* mesh = surface->GetOutput();
  if (mesh->GetNumberOfCells() == 0)
  {
    throw Failure("every cell of the terrain has a missing post: there is nothing to see");
  }
  const auto skirt = MakeSkirt(terrain, MostMeshPosts, mesh);
  RunPass(skirt, "skirt", common);

  const auto mapper = MakeMapper(surface, terrain, light.Exposure);
  const auto wall = MakeMapper(skirt, terrain, light.Exposure);
  wall->SetShader(mapper->GetShader());

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(MakeActor(mapper, 1.0));
  renderer->AddActor(MakeActor(wall, SkirtColor));
  PaintSky(renderer, light.SkyRadiance, light.Exposure);
  standpoint.Aspect = static_cast<double>(width) / height;
  FitCamera(renderer->GetActiveCamera(), { mesh->GetPoints(), skirt->GetOutput()->GetPoints() },
    standpoint);
  renderer->ResetCameraClippingRange();

  window->SetMultiSamples(0);
  window->SetSize(Samples * width, Samples * height);
  window->AddRenderer(renderer);
  vtkNew<vtkUnsignedCharArray> samples;
  RunPass(mapper, "draw", common,
    [&]
    {
      window->Render();
      window->GetPixelData(0, 0, Samples * width - 1, Samples * height - 1, 0, samples, 0);
    });
  const vtkIdType wanted = 3 * static_cast<vtkIdType>(Samples) * Samples * width * height;
  if (samples->GetNumberOfValues() != wanted)
  {
    throw Failure("OpenGL returned no picture");
  }
  window->Finalize();
  return Reduce(samples, width, height);
}

} // namespace skyline
