// SPDX-License-Identifier: BSD-3-Clause
// Compares whole scenes with stored pictures. TestSoftShadowLight tests the numbers.
#include "BaselineTesting.h"
#include "MapperTesting.h"

#include "CameraFit.h"
#include "Color/ColorMaps.h"
#include "Harmonics/SphericalHarmonics.h"
#include "vtkHeightFieldTransfer.h"
#include "vtkHeightFieldVisibility.h"

#include "vtkColorTransferFunction.h"
#include "vtkPlane.h"

namespace skyline
{
namespace testing
{
namespace
{

// A volcano with a crater on a rough plain: slopes in all directions, and shadows in the crater.
vtkSmartPointer<vtkImageData> Volcano()
{
  return Terrain(
    96, 80,
    [](int column, int row)
    {
      const double x = (column - 52.0) / 30.0;
      const double y = (row - 42.0) / 30.0;
      const double r = std::sqrt(x * x + y * y);
      const double cone = 900.0 * std::exp(-1.8 * r) - 500.0 * std::exp(-14.0 * r * r);
      return cone + 25.0 * std::sin(0.31 * column) * std::cos(0.27 * row + 0.02 * column);
    },
    30.0);
}

class SoftShadowImages : public Drawing
{
protected:
  // The volcano with the array of the filter.
  template <typename Filter>
  static vtkSmartPointer<vtkImageData> See()
  {
    vtkNew<Filter> filter;
    filter->SetInputData(Volcano());
    filter->SetNumberOfAzimuths(32);
    filter->Update();
    return vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  }

  // From the south, with the whole terrain in the picture.
  static void Look(MapScene& scene, vtkSkylineSoftShadowPolyDataMapper* mapper)
  {
    scene.Window->SetSize(240, 150);
    scene.Renderer->SetBackground(0.6, 0.7, 0.85);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
    mapper->GetInput()->GetPoints()->Modified();
    FitCamera(scene.Renderer->GetActiveCamera(), { mapper->GetInput()->GetPoints() }, Standpoint());
    scene.Renderer->ResetCameraClippingRange();
    scene.Render();
  }

  // A warm light from the west and a blue light from the whole sky.
  static void Shine(vtkSkylineSoftShadowShader* shader)
  {
    std::array<double, 16> key{};
    std::array<double, 4> zonal{};
    for (int l = 0; l < 4; ++l)
    {
      zonal[static_cast<std::size_t>(l)] = CapZonal(l, std::cos(0.3));
    }
    RotateZonal(4, zonal.data(), -0.8, 0.0, 0.6, key.data());
    for (int i = 0; i < 16; ++i)
    {
      const double k = 10.0 * key[static_cast<std::size_t>(i)];
      const double sky = i == 0 ? 0.35 * std::sqrt(4.0 * Pi) : 0.0;
      shader->SetLightCoefficient(i, k + 0.7 * sky, 0.85 * k + 0.9 * sky, 0.6 * k + 1.2 * sky);
    }
  }
};

TEST_F(SoftShadowImages, TheComparisonSeesWhatVtksDoesNot)
{
  const auto volcano = Volcano();
  AddArray(volcano, "Irradiance", 3,
    [](int column, int row) {
      return std::vector<double>{ 0.03 * column, 0.03 * row, 1.0 + std::sin(0.5 * column) };
    });
  MapScene scene(volcano);
  const auto mapper = MapperOf(volcano);
  scene.Add(mapper);
  Look(scene, mapper);
  const auto picture = PictureOf(scene.Window);
  EXPECT_EQ(Difference(picture, picture), 0.0);
  mapper->GetShader()->SetExposure(-0.1);
  scene.Render();
  EXPECT_GT(Difference(PictureOf(scene.Window), picture), RimPixels) << "7 % less light";
  mapper->GetShader()->SetExposure(0.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->Yaw(0.1); // half a pixel
  scene.Render();
  EXPECT_GT(Difference(PictureOf(scene.Window), picture), RimPixels);
}

TEST_F(SoftShadowImages, TransferWithColorsOfHeights)
{
  const auto seen = See<vtkHeightFieldTransfer>();
  MapScene scene(seen);
  const auto mapper = MapperOf(seen, 2);
  mapper->GetShader()->SetMode(vtkSkylineSoftShadowShader::TRANSFER);
  Shine(mapper->GetShader());
  vtkNew<vtkColorTransferFunction> colors;
  const ColorMap& map = *FindColorMap("hypsometric");
  for (std::size_t k = 0; k < map.Count; ++k)
  {
    const unsigned int code = map.Colors[k];
    colors->AddRGBPoint(50.0 * static_cast<double>(k), (code >> 16) / 255.0,
      ((code >> 8) & 255u) / 255.0, (code & 255u) / 255.0);
  }
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->ScalarVisibilityOn();
  scene.Add(mapper);
  Look(scene, mapper);
  ExpectBaseline(scene.Window, "SoftShadowTransfer");
}

TEST_F(SoftShadowImages, VisibilityWithALampAndACut)
{
  const auto seen = See<vtkHeightFieldVisibility>();
  AddArray(seen, "LampIrradiance", 1,
    [](int column, int row)
    {
      const double x = column - 30.0;
      const double y = row - 15.0;
      return std::vector<double>{ 8.0 / (1.0 + 0.03 * (x * x + y * y)) };
    });
  MapScene scene(seen);
  const auto mapper = MapperOf(seen);
  mapper->GetShader()->SetMode(vtkSkylineSoftShadowShader::VISIBILITY);
  Shine(mapper->GetShader());
  mapper->GetShader()->SetExposure(-1.0);
  mapper->GetShader()->SetLampRadiance(0, 1.0, 0.6, 0.2);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(80.0 * 30.0, 0.0, 0.0);
  plane->SetNormal(-1.0, 0.3, 0.0);
  mapper->AddClippingPlane(plane);
  scene.Add(mapper)->GetProperty()->SetColor(0.8, 0.8, 0.8);
  Look(scene, mapper);
  ExpectBaseline(scene.Window, "SoftShadowVisibility");
}

} // namespace
} // namespace testing
} // namespace skyline
