// SPDX-License-Identifier: BSD-3-Clause
// Small scenes for the mapper, seen from above, with one pixel per post.
#ifndef skyline_MapperTesting_h
#define skyline_MapperTesting_h

#include "Color/ToneMap.h"
#include "vtkHeightFieldSurface.h"
#include "vtkSkylineEGLWindow.h"
#include "vtkSkylineSoftShadowPolyDataMapper.h"
#include "vtkSkylineSoftShadowShader.h"

#include "Testing/Filters/FilterTesting.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace skyline
{
namespace testing
{

constexpr double Pi = 3.14159265358979323846;

/// Light and colours are 32-bit floats, harmonics 16-bit floats, and the shader uses the function
/// pow of the graphics processor. A code can differ by one.
constexpr int CodeTolerance = 1;

using Byte3 = std::array<int, 3>;
using Height = std::function<double(int column, int row)>;
using Values = std::function<std::vector<double>(int column, int row)>;

inline vtkSmartPointer<vtkImageData> Terrain(int columns, int rows, const Height& height,
  double spacing = 1.0, double originX = 0.0, double originY = 0.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  image->SetSpacing(spacing, spacing, 1.0);
  image->SetOrigin(originX, originY, 0.0);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Elevation");
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      heights->InsertNextValue(height(column, row));
    }
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

inline void AddArray(vtkImageData* image, const char* name, int components, const Values& values)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  const int* size = image->GetDimensions();
  for (int row = 0; row < size[1]; ++row)
  {
    for (int column = 0; column < size[0]; ++column)
    {
      array->InsertNextTuple(values(column, row).data());
    }
  }
  image->GetPointData()->AddArray(array);
}

/// The codes of a ground with the given albedo (linear) and irradiance, at an exposure of 0 stops.
inline Byte3 Seen(const Rgb& albedo, const Rgb& irradiance)
{
  Rgb light;
  for (std::size_t c = 0; c < 3; ++c)
  {
    light[c] = albedo[c] * irradiance[c] / static_cast<float>(Pi);
  }
  const Rgb tone = ToneMap(light);
  return { { SrgbByte(tone[0]), SrgbByte(tone[1]), SrgbByte(tone[2]) } };
}

/// A renderer that looks straight down at a height field: pixel (i, j) shows post (i, j). The
/// outermost posts lie on the rim of the mesh, where a pixel may not be drawn.
class MapScene
{
public:
  explicit MapScene(vtkImageData* image)
  {
    const int* size = image->GetDimensions();
    this->Window->SetSize(size[0], size[1]);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    std::array<double, 6> bounds;
    image->GetBounds(bounds.data());
    const double x = 0.5 * (bounds[0] + bounds[1]);
    const double y = 0.5 * (bounds[2] + bounds[3]);
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(x, y, 0.0);
    camera->SetPosition(x, y, 1e4);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetParallelScale(0.5 * size[1] * image->GetSpacing()[1]);
    camera->SetClippingRange(1.0, 2e4);
  }

  ~MapScene() { this->Window->Finalize(); }

  vtkSmartPointer<vtkActor> Add(vtkMapper* mapper)
  {
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor;
  }

  void Render() { this->Window->Render(); }

  Byte3 Pixel(int column, int row)
  {
    vtkNew<vtkUnsignedCharArray> pixel;
    this->Window->GetPixelData(column, row, column, row, 0, pixel, 0);
    return { { pixel->GetValue(0), pixel->GetValue(1), pixel->GetValue(2) } };
  }

  vtkNew<vtkSkylineEGLWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

/// A mapper that draws a height field with its own light, with a mesh whose corners are at every
/// stride-th post.
inline vtkSmartPointer<vtkSkylineSoftShadowPolyDataMapper> MapperOf(
  vtkImageData* image, int stride = 1)
{
  vtkNew<vtkHeightFieldSurface> surface;
  surface->SetInputData(image);
  surface->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
  surface->SetStride(stride);
  surface->Update();
  auto mapper = vtkSmartPointer<vtkSkylineSoftShadowPolyDataMapper>::New();
  mapper->SetInputData(surface->GetOutput());
  mapper->ScalarVisibilityOff();
  mapper->GetShader()->SetHeightField(image);
  return mapper;
}

inline void ExpectNear(const Byte3& seen, const Byte3& expected, const std::string& where = {})
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(seen[c], expected[c], CodeTolerance) << "channel " << c << " " << where;
  }
}

/// The base of all fixtures that draw. It skips the test if there is no OpenGL context.
class Drawing : public ::testing::Test
{
protected:
  void SetUp() override
  {
    vtkNew<vtkSkylineEGLWindow> probe;
    vtkNew<ErrorCatcher> silence;
    probe->AddObserver(vtkCommand::ErrorEvent, silence);
    if (!probe->SupportsOpenGL())
    {
      GTEST_SKIP() << "no OpenGL context without a window system: " << probe->GetReason();
    }
  }
};

} // namespace testing
} // namespace skyline

#endif
