// SPDX-License-Identifier: BSD-3-Clause
// Numbers read from pixels: compares the three modes with closed forms and with the kernels.
#include "MapperTesting.h"

#include "Harmonics/HarmonicProduct.h"
#include "Harmonics/SphericalHarmonics.h"
#include "vtkHeightFieldShading.h"

#include <limits>
#include <random>

namespace skyline
{
namespace testing
{
namespace
{

constexpr int Count = 16;

using Coefficients = std::vector<double>;

// Max(0, n.d) around the unit normal n.
Coefficients CosineAround(double x, double y, double z)
{
  Coefficients zonal;
  for (int l = 0; l < 4; ++l)
  {
    zonal.push_back(ClampedCosineZonal(l));
  }
  Coefficients cosine(Count);
  RotateZonal(4, zonal.data(), x, y, z, cosine.data());
  return cosine;
}

// The visible upper hemisphere.
Coefficients OpenSky()
{
  Coefficients sky(Count, 0.0);
  for (int l = 0; l < 4; ++l)
  {
    sky[static_cast<std::size_t>(l * l + l)] = HemisphereZonal(l);
  }
  return sky;
}

void SetLight(vtkSkylineSoftShadowShader* shader, const std::vector<Coefficients>& rgb)
{
  for (int i = 0; i < Count; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    shader->SetLightCoefficient(i, rgb[0][k], rgb[1][k], rgb[2][k]);
  }
}

class SoftShadowLight : public Drawing
{
};

// Albedo * E / pi after the tone curve, for the whole range of albedo and light.
TEST_F(SoftShadowLight, FlatGroundShowsAlbedoTimesIrradianceOverPi)
{
  const auto flat = Terrain(8, 6, [](int, int) { return 3.0; });
  AddArray(flat, "Irradiance", 3,
    [](int column, int) {
      return std::vector<double>{ 0.2 * column * Pi, 0.4 * Pi, 0.1 * column * column };
    });
  MapScene scene(flat);
  const auto mapper = MapperOf(flat);
  const auto actor = scene.Add(mapper);
  for (double code : { 1.0, 0.6, 0.2, 0.01 })
  {
    actor->GetProperty()->SetColor(code, 0.5, 1.0);
    scene.Render();
    const Rgb albedo{ { DecodeSrgb(static_cast<float>(code)), DecodeSrgb(0.5f), 1.0f } };
    for (int column = 0; column < 7; ++column)
    {
      const Rgb light{ { static_cast<float>(0.2 * column * Pi), static_cast<float>(0.4 * Pi),
        static_cast<float>(0.1 * column * column) } };
      ExpectNear(scene.Pixel(column, 3), Seen(albedo, light), std::to_string(column));
    }
  }
}

// White furnace test: with a uniform radiance of 1, open level ground gets pi in each mode.
TEST_F(SoftShadowLight, UniformLightGivesPiInEveryMode)
{
  const auto flat = Terrain(5, 5, [](int, int) { return 0.0; });
  const Coefficients cosine = CosineAround(0.0, 0.0, 1.0);
  AddArray(flat, "Irradiance", 3, [](int, int) { return std::vector<double>{ Pi, Pi, Pi }; });
  AddArray(flat, "TransferSH", Count, [&](int, int) { return cosine; });
  AddArray(flat, "VisibilitySH", Count, [](int, int) { return OpenSky(); });
  // Truncation has no effect here: the half sky has no band 2, and the cosine has no band 3.
  double held = 0.0;
  const Coefficients sky = OpenSky();
  for (std::size_t i = 0; i < Count; ++i)
  {
    held += sky[i] * cosine[i];
  }
  EXPECT_NEAR(held, Pi, 1e-6 * Pi);
  MapScene scene(flat);
  const auto mapper = MapperOf(flat);
  scene.Add(mapper)->GetProperty()->SetColor(0.5, 0.5, 0.5);
  const Rgb albedo{ { DecodeSrgb(0.5f), DecodeSrgb(0.5f), DecodeSrgb(0.5f) } };
  for (int mode : { 0, 1, 2 })
  {
    mapper->GetShader()->SetMode(mode);
    scene.Render();
    const float e = static_cast<float>(mode == 2 ? held : Pi);
    ExpectNear(scene.Pixel(2, 2), Seen(albedo, { { e, e, e } }), "mode " + std::to_string(mode));
  }
}

// For any light, visibility and normals, the product in the shader is that of the kernel.
TEST_F(SoftShadowLight, VisibilityTimesCosineTimesLightIsTheTripleIntegral)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0.0, 0.25);
  const auto noise = [&]
  {
    Coefficients values(Count);
    for (double& value : values)
    {
      value = normal(random);
    }
    values[0] += 3.0;
    return values;
  };
  const double a = 0.8;
  const double b = -0.5;
  const auto plane = Terrain(
    4, 4, [&](int column, int row) { return 2.0 * (a * column + b * row); }, 2.0);
  const Coefficients visible = noise();
  AddArray(plane, "VisibilitySH", Count, [&](int, int) { return visible; });
  MapScene scene(plane);
  const auto mapper = MapperOf(plane);
  mapper->GetShader()->SetMode(vtkSkylineSoftShadowShader::VISIBILITY);
  mapper->GetShader()->ToneMappingOff();
  scene.Add(mapper)->GetProperty()->SetColor(1.0, 1.0, 1.0);
  const double length = std::sqrt(1.0 + a * a + b * b);
  const Coefficients cosine = CosineAround(-a / length, -b / length, 1.0 / length);
  const HarmonicProduct& product = HarmonicProduct::ForBands(4);
  for (int turn = 0; turn < 5; ++turn)
  {
    std::vector<Coefficients> light{ noise(), noise(), noise() };
    Byte3 expected;
    for (std::size_t c = 0; c < 3; ++c)
    {
      // A strength with which the codes lie in the middle of their range.
      const double raw =
        product.TripleIntegral(visible.data(), cosine.data(), light[c].data()) / Pi;
      for (double& value : light[c])
      {
        value *= (0.2 + 0.2 * static_cast<double>(c)) / raw;
      }
      const double e = product.TripleIntegral(visible.data(), cosine.data(), light[c].data());
      expected[c] = SrgbByte(static_cast<float>(e / Pi));
    }
    SetLight(mapper->GetShader(), light);
    scene.Render();
    ExpectNear(scene.Pixel(1, 2), expected, "light " + std::to_string(turn));
  }
}

TEST_F(SoftShadowLight, TransferTimesLightIsTheirDotProduct)
{
  const auto flat = Terrain(4, 4, [](int, int) { return 0.0; });
  Coefficients transfer(Count);
  std::vector<Coefficients> light(3, Coefficients(Count));
  std::array<double, 3> e{};
  for (std::size_t i = 0; i < Count; ++i)
  {
    transfer[i] = std::sin(1.0 + 3.0 * static_cast<double>(i));
    for (std::size_t c = 0; c < 3; ++c)
    {
      light[c][i] = (0.1 + 0.1 * static_cast<double>(c)) * transfer[i] +
        0.01 * std::cos(2.0 * static_cast<double>(i));
      e[c] += light[c][i] * transfer[i];
    }
  }
  AddArray(flat, "TransferSH", Count, [&](int, int) { return transfer; });
  MapScene scene(flat);
  const auto mapper = MapperOf(flat);
  mapper->GetShader()->SetMode(vtkSkylineSoftShadowShader::TRANSFER);
  SetLight(mapper->GetShader(), light);
  scene.Add(mapper)->GetProperty()->SetColor(1.0, 1.0, 1.0);
  scene.Render();
  ExpectNear(scene.Pixel(2, 1),
    Seen({ { 1.0f, 1.0f, 1.0f } },
      { { static_cast<float>(e[0]), static_cast<float>(e[1]), static_cast<float>(e[2]) } }));
}

// The picture of the CPU filter, post by post: the same light, colours and tone curve.
TEST_F(SoftShadowLight, MapViewEqualsTheShadingFilter)
{
  const auto hills = Terrain(
    60, 50,
    [](int column, int row) { return 90.0 * std::sin(0.2 * column) * std::cos(0.15 * row); }, 30.0,
    500000.0, 5100000.0);
  vtkNew<vtkHeightFieldShading> shading;
  shading->SetInputData(hills);
  shading->Update();
  vtkImageData* shaded = shading->GetOutput();
  vtkDataArray* radiance = shaded->GetPointData()->GetArray("Radiance");
  AddArray(hills, "Irradiance", 3,
    [&](int column, int row)
    {
      std::vector<double> rgb(3);
      radiance->GetTuple(row * 60 + column, rgb.data());
      for (double& c : rgb)
      {
        c *= Pi; // the radiance contains the colours, so the ground is white
      }
      return rgb;
    });
  MapScene scene(hills);
  const auto mapper = MapperOf(hills);
  scene.Add(mapper)->GetProperty()->SetColor(1.0, 1.0, 1.0);
  mapper->GetShader()->SetExposure(shading->GetUsedExposure());
  scene.Render();
  vtkDataArray* picture = shaded->GetPointData()->GetArray("Picture");
  for (int row = 1; row < 49; ++row)
  {
    for (int column = 1; column < 59; ++column)
    {
      const vtkIdType post = row * 60 + column;
      ExpectNear(scene.Pixel(column, row),
        { { static_cast<int>(picture->GetComponent(post, 0)),
          static_cast<int>(picture->GetComponent(post, 1)),
          static_cast<int>(picture->GetComponent(post, 2)) } },
        std::to_string(post));
    }
  }
}

// Two triangles show the light of all posts.
TEST_F(SoftShadowLight, ADecimatedMeshKeepsTheResolutionOfTheLight)
{
  const auto flat = Terrain(33, 33, [](int, int) { return 0.0; });
  const auto light = [](int column, int row)
  { return (column + row) % 2 == 0 ? 0.3 * Pi : 0.7 * Pi; };
  AddArray(flat, "Irradiance", 3,
    [&](int column, int row) { return std::vector<double>(3, light(column, row)); });
  MapScene scene(flat);
  const auto mapper = MapperOf(flat, 32);
  EXPECT_EQ(mapper->GetInput()->GetNumberOfCells(), 2);
  scene.Add(mapper)->GetProperty()->SetColor(1.0, 1.0, 1.0);
  scene.Render();
  for (int i = 1; i < 32; ++i)
  {
    const float e = static_cast<float>(light(i, 7));
    ExpectNear(scene.Pixel(i, 7), Seen({ { 1.0f, 1.0f, 1.0f } }, { { e, e, e } }));
  }
}

// A float cannot represent a northing of 5100000 m to the centimetre. The light must stay in place
// nevertheless.
TEST_F(SoftShadowLight, FarFromTheOriginEveryPostKeepsItsLight)
{
  const auto flat = Terrain(
    40, 40, [](int, int) { return 0.0; }, 0.05, 500000.0, 5100000.0);
  AddArray(flat, "Irradiance", 3,
    [](int column, int row) {
      return std::vector<double>{ (column % 3) * 0.3 * Pi, (row % 3) * 0.3 * Pi, 0.2 * Pi };
    });
  MapScene scene(flat);
  const auto mapper = MapperOf(flat, 39);
  scene.Add(mapper)->GetProperty()->SetColor(1.0, 1.0, 1.0);
  scene.Render();
  for (int i = 1; i < 39; ++i)
  {
    const Rgb light{ { static_cast<float>((i % 3) * 0.3 * Pi),
      static_cast<float>(((39 - i) % 3) * 0.3 * Pi), static_cast<float>(0.2 * Pi) } };
    ExpectNear(scene.Pixel(i, 39 - i), Seen({ { 1.0f, 1.0f, 1.0f } }, light), std::to_string(i));
  }
}

TEST_F(SoftShadowLight, MissingPostsTakeNothingFromTheirNeighbours)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto hole = [](int column, int row)
  { return column >= 3 && column <= 6 && row >= 4 && row <= 6; };
  const auto flat =
    Terrain(12, 12, [&](int column, int row) { return hole(column, row) ? nan : 1.0; });
  AddArray(flat, "Irradiance", 3,
    [&](int column, int row)
    { return std::vector<double>(3, hole(column, row) ? nan : 0.5 * Pi); });
  MapScene scene(flat);
  const auto mapper = MapperOf(flat);
  scene.Add(mapper)->GetProperty()->SetColor(1.0, 1.0, 1.0);
  scene.Renderer->SetBackground(1.0, 0.0, 0.0);
  scene.Render();
  const float e = static_cast<float>(0.5 * Pi);
  const Byte3 lit = Seen({ { 1.0f, 1.0f, 1.0f } }, { { e, e, e } });
  for (int row = 1; row < 11; ++row)
  {
    for (int column = 1; column < 11; ++column)
    {
      const Byte3 seen = scene.Pixel(column, row);
      if (seen != Byte3{ { 255, 0, 0 } })
      {
        ExpectNear(seen, lit, std::to_string(column) + " " + std::to_string(row));
      }
    }
  }
  EXPECT_EQ(scene.Pixel(4, 5), (Byte3{ { 255, 0, 0 } })) << "no cell over a missing post";
  // A mesh that covers the hole gets light everywhere.
  vtkNew<vtkHeightFieldSurface> closed;
  closed->SetInputData(Terrain(12, 12, [](int, int) { return 1.0; }));
  closed->Update();
  mapper->SetInputData(closed->GetOutput());
  scene.Render();
  ExpectNear(scene.Pixel(4, 5), lit);
}

TEST_F(SoftShadowLight, LampsAddTheirLight)
{
  const auto flat = Terrain(6, 6, [](int, int) { return 0.0; });
  AddArray(flat, "Irradiance", 3, [](int, int) { return std::vector<double>{ 0.1, 0.2, 0.3 }; });
  AddArray(flat, "LampIrradiance", 2, [](int, int) { return std::vector<double>{ 0.5, 0.25 }; });
  MapScene scene(flat);
  const auto mapper = MapperOf(flat);
  scene.Add(mapper)->GetProperty()->SetColor(1.0, 1.0, 1.0);
  mapper->GetShader()->SetLampRadiance(0, 1.0, 0.5, 0.0);
  mapper->GetShader()->SetLampRadiance(1, 0.0, 2.0, 4.0);
  mapper->GetShader()->SetExposure(1.5);
  scene.Render();
  const float gain = static_cast<float>(std::exp2(1.5));
  ExpectNear(scene.Pixel(3, 3),
    Seen({ { gain, gain, gain } }, { { 0.1f + 0.5f, 0.2f + 0.25f + 0.5f, 0.3f + 1.0f } }));
}

} // namespace
} // namespace testing
} // namespace skyline
