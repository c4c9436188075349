// SPDX-License-Identifier: BSD-3-Clause
#include "GpuTesting.h"

#include "vtkOpenGLHeightFieldIrradiance.h"

#include "vtkHeightFieldSurface.h"
#include "vtkSkylineEGLWindow.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineKeyLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSkylineSoftShadowPolyDataMapper.h"
#include "vtkSkylineSoftShadowShader.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

namespace skyline
{
namespace testing
{
namespace
{

// Sixteen coefficients, each with an error of at most 6e-7 (TestGpuHarmonics), times those of a
// light with an irradiance of 1. The greatest difference found is 2e-7.
constexpr double RoundingTolerance = 5.0e-6;

class Irradiance : public GpuTest
{
protected:
  void SetUp() override
  {
    this->GpuTest::SetUp();
    this->Key->SetAzimuth(120.0);
    this->Key->SetElevation(35.0);
    this->Key->SetAngularRadius(8.0);
    this->Gpu->SetDevice(this->Device);
    this->Configure(this->Gpu);
    this->Configure(this->Host);
    this->Host->SetLightMethodToHarmonics();
  }

  void Configure(vtkHeightFieldIrradiance* filter)
  {
    filter->SetMethodToPyramid();
    filter->SetNumberOfAzimuths(10);
    filter->AddLight(this->Key);
  }

  double Parity(vtkImageData* image)
  {
    this->Gpu->SetInputData(image);
    this->Host->SetInputData(image);
    this->Gpu->Update();
    this->Host->Update();
    EXPECT_TRUE(this->Gpu->IsOnDevice());
    EXPECT_FALSE(this->Gpu->GetTexture() && this->Device->GetTextureLimit() == 32);
    return Difference(ArrayOf(this->Gpu, "Irradiance"), ArrayOf(this->Host, "Irradiance"));
  }

  vtkNew<vtkSkylineKeyLight> Key;
  vtkNew<vtkOpenGLHeightFieldIrradiance> Gpu;
  vtkNew<vtkHeightFieldIrradiance> Host;
};

TEST_F(Irradiance, IsThatOfTheHost)
{
  EXPECT_LT(this->Parity(ImageOf<vtkDoubleArray>(HillsWithHoles(90, 70))), RoundingTolerance);
  this->Gpu->HorizontalOn();
  this->Host->HorizontalOn();
  EXPECT_LT(this->Parity(ImageOf<vtkDoubleArray>(Hills(60, 70))), RoundingTolerance);
}

TEST_F(Irradiance, OfTiles)
{
  this->Device->SetTextureLimit(32);
  EXPECT_LT(this->Parity(ImageOf<vtkDoubleArray>(Hills(60, 70))), RoundingTolerance);
}

TEST_F(Irradiance, ChangedLightsTakeNoHorizons)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(60, 50));
  this->Parity(image);
  EXPECT_EQ(this->Gpu->GetEnvironmentPasses(), 1);
  vtkTextureObject* texture = this->Gpu->GetTexture();
  this->Key->SetAzimuth(200.0);
  EXPECT_LT(this->Parity(image), RoundingTolerance);
  EXPECT_EQ(this->Gpu->GetEnvironmentPasses(), 0);
  EXPECT_EQ(this->Gpu->GetTexture(), texture);
  image->GetPointData()->GetScalars()->SetTuple1(77, 9000.0);
  image->GetPointData()->GetScalars()->Modified();
  image->Modified();
  EXPECT_LT(this->Parity(image), RoundingTolerance);
  EXPECT_EQ(this->Gpu->GetEnvironmentPasses(), 1);
}

TEST_F(Irradiance, LampsAreTheHosts)
{
  vtkNew<vtkSkylineLampLight> lamp;
  lamp->SetPosition(800.0, 700.0, 2000.0);
  lamp->SetRadius(50.0);
  this->Gpu->AddLight(lamp);
  this->Host->AddLight(lamp);
  this->Gpu->ReadBackOff();
  EXPECT_LT(this->Parity(ImageOf<vtkDoubleArray>(Hills(60, 50))), RoundingTolerance);
}

TEST_F(Irradiance, TablesAreTheHosts)
{
  this->Gpu->SetLightMethodToTable();
  this->Gpu->SetInputData(ImageOf<vtkDoubleArray>(Hills(30, 20)));
  this->Gpu->Update();
  EXPECT_FALSE(this->Gpu->IsOnDevice());
  EXPECT_NE(ArrayOf(this->Gpu, "Irradiance"), nullptr);
}

/// The terrain from above, one pixel per post, in the light of the graphics processor or of the
/// host.
class Picture
{
public:
  explicit Picture(vtkImageData* image)
  {
    const int* size = image->GetDimensions();
    this->Window->SetSize(size[0], size[1]);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    double bounds[6];
    image->GetBounds(bounds);
    const double x = 0.5 * (bounds[0] + bounds[1]);
    const double y = 0.5 * (bounds[2] + bounds[3]);
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(x, y, 0.0);
    camera->SetPosition(x, y, 1.0e5);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetParallelScale(0.5 * size[1] * image->GetSpacing()[1]);
    camera->SetClippingRange(1.0, 2.0e5);
    vtkNew<vtkHeightFieldSurface> surface;
    surface->SetInputData(image);
    surface->Update();
    this->Mapper->SetInputData(surface->GetOutput());
    this->Mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(actor);
  }
  ~Picture() { this->Window->Finalize(); }

  vtkSmartPointer<vtkUnsignedCharArray> Draw()
  {
    this->Window->Render();
    auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
    const int* size = this->Window->GetSize();
    this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels, 0);
    return pixels;
  }

  vtkNew<vtkSkylineEGLWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkSkylineSoftShadowPolyDataMapper> Mapper;
};

// Several frames from heights to pixels, without arrays in between.
TEST_F(Irradiance, GoesToTheMapperWithoutReadBack)
{
  if (!vtkSkylineEGLWindow::IsSupported())
  {
    GTEST_SKIP() << "EGL gives no context";
  }
  const auto image = ImageOf<vtkDoubleArray>(Hills(64, 48));
  Picture mine(image);
  Picture theirs(image);
  vtkNew<vtkOpenGLHeightFieldDevice> device;
  device->SetRenderWindow(mine.Window);
  this->Gpu->SetDevice(device);
  this->Gpu->ReadBackOff();
  this->Gpu->SetInputData(image);
  this->Host->SetInputData(image);
  for (int frame = 0; frame < 3; ++frame)
  {
    for (vtkIdType post = 0; frame > 0 && post < image->GetNumberOfPoints(); ++post)
    {
      vtkDataArray* heights = image->GetPointData()->GetScalars();
      heights->SetComponent(post, 0, 0.8 * heights->GetComponent(post, 0));
    }
    image->GetPointData()->GetScalars()->Modified();
    image->Modified();
    this->Gpu->Update();
    this->Host->Update();
    EXPECT_EQ(ArrayOf(this->Gpu, "Irradiance"), nullptr);
    ASSERT_NE(this->Gpu->GetTexture(), nullptr);
    mine.Mapper->GetShader()->SetHeightField(image);
    mine.Mapper->GetShader()->SetIrradianceTexture(this->Gpu->GetTexture());
    theirs.Mapper->GetShader()->SetHeightField(this->Host->GetOutput());
    const auto seen = mine.Draw();
    const auto expected = theirs.Draw();
    ASSERT_EQ(seen->GetNumberOfValues(), expected->GetNumberOfValues());
    int greatest = 0;
    int lit = 0;
    for (vtkIdType i = 0; i < seen->GetNumberOfValues(); ++i)
    {
      greatest = std::max(greatest, std::abs(seen->GetValue(i) - expected->GetValue(i)));
      lit += seen->GetValue(i) > 20 ? 1 : 0;
    }
    EXPECT_LE(greatest, 1); // a code can round to its neighbour
    EXPECT_GT(lit, seen->GetNumberOfValues() / 5);
  }
}

} // namespace
} // namespace testing
} // namespace skyline
