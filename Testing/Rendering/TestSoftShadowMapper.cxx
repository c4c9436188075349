// SPDX-License-Identifier: BSD-3-Clause
// The mapper as a VTK mapper: behaviour that all mappers share, uploads, and errors.
#include "MapperTesting.h"

#include "vtkHeightFieldVisibility.h"

#include "vtkHardwareSelector.h"
#include "vtkLookupTable.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkSelection.h"
#include "vtkTexture.h"
#include "vtkTextureObject.h"
#include "vtkTrivialProducer.h"

#include <memory>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

constexpr int Size = 9;

const Rgb White{ { 1.0f, 1.0f, 1.0f } };

Rgb Light(double e)
{
  const float f = static_cast<float>(e);
  return { { f, f, f } };
}

Rgb Decode(double red, double green, double blue)
{
  return { { DecodeSrgb(static_cast<float>(red)), DecodeSrgb(static_cast<float>(green)),
    DecodeSrgb(static_cast<float>(blue)) } };
}

// A picture of one colour, used as a draped texture.
vtkSmartPointer<vtkImageData> PlainTexture(int red, int green, int blue)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int c = 0; c < 3; ++c)
  {
    image->GetPointData()->GetScalars()->FillComponent(c, c == 0 ? red : c == 1 ? green : blue);
  }
  return image;
}

/// Counts events.
class Counter : public vtkCommand
{
public:
  static Counter* New() { return new Counter; }
  void Execute(vtkObject*, unsigned long, void*) override { ++this->Count; }
  int Count = 0;
};

// Level ground at a given height in uniform light, and its mapper.
class SoftShadowMapper : public Drawing
{
protected:
  void SetUp() override
  {
    Drawing::SetUp();
    if (this->IsSkipped())
    {
      return;
    }
    this->Ground = this->Level(0.0);
    this->Mapper = MapperOf(this->Ground);
    this->Mapper->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    this->Shader()->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    this->Scene = std::make_unique<MapScene>(this->Ground);
    this->Actor = this->Scene->Add(this->Mapper);
    this->Actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  }

  void TearDown() override { EXPECT_EQ(this->Errors->Text, ""); }

  vtkSmartPointer<vtkImageData> Level(double height)
  {
    auto image = Terrain(Size, Size, [height](int, int) { return height; });
    AddArray(image, "Irradiance", 3,
      [](int, int) {
        return std::vector<double>{ 0.5 * Pi, 0.5 * Pi, 0.5 * Pi };
      });
    std::vector<double> harmonics(16, 0.0);
    harmonics[0] = 0.5 * std::sqrt(Pi / 4.0); // with a uniform radiance of 1: 0.5 pi
    AddArray(image, "TransferSH", 16, [&](int, int) { return harmonics; });
    AddArray(image, "VisibilitySH", 16, [&](int, int) { return harmonics; });
    return image;
  }

  Byte3 Middle()
  {
    this->Scene->Render();
    return this->Scene->Pixel(Size / 2, Size / 2);
  }

  vtkSkylineSoftShadowShader* Shader() { return this->Mapper->GetShader(); }
  int Uploads() { return this->Shader()->GetNumberOfTextureUploads(); }
  bool TextHas(const char* word)
  {
    return this->Mapper->GetFragmentShaderText().find(word) != std::string::npos;
  }

  vtkSmartPointer<vtkImageData> Ground;
  vtkSmartPointer<vtkSkylineSoftShadowPolyDataMapper> Mapper;
  vtkNew<ErrorCatcher> Errors;
  std::unique_ptr<MapScene> Scene;
  vtkSmartPointer<vtkActor> Actor;
};

// The largest texture is a limit of the context, which a strip of level ground can exceed.
class SoftShadowErrors : public SoftShadowMapper
{
protected:
  void TearDown() override {}

  // Renders twice. The reason must be reported once, in one line, and nothing must be drawn.
  void ExpectRefused(const std::string& reason)
  {
    this->Errors->Text.clear();
    this->Errors->Count = 0;
    this->Scene->Render();
    EXPECT_EQ(this->Middle(), (Byte3{ { 0, 0, 0 } }));
    EXPECT_EQ(this->Errors->Count, 1);
    EXPECT_NE(this->Errors->Text.find(reason), std::string::npos) << this->Errors->Text;
  }
};

TEST_F(SoftShadowMapper, AChangedLightUploadsNoTextureAndKeepsTheShader)
{
  for (int mode : { 1, 2 })
  {
    this->Shader()->SetMode(mode);
    this->Shader()->SetUniformLight(1.0, 1.0, 1.0);
    const Byte3 before = this->Middle();
    const int uploads = this->Uploads();
    const vtkMTimeType text = this->Mapper->GetMTime();
    this->Shader()->SetUniformLight(0.2, 0.3, 0.4);
    this->Shader()->SetExposure(0.5);
    EXPECT_NE(this->Middle(), before);
    this->Shader()->SetLightCoefficient(0, 0.0, 0.0, 0.0);
    EXPECT_EQ(this->Middle(), (Byte3{ { 0, 0, 0 } }));
    EXPECT_EQ(this->Uploads(), uploads);
    EXPECT_EQ(this->Mapper->GetMTime(), text);
    this->Shader()->SetExposure(0.0);
  }
}

TEST_F(SoftShadowMapper, OnlyWhatChangedIsUploaded)
{
  this->Middle();
  EXPECT_EQ(this->Uploads(), 1);
  this->Scene->Render();
  EXPECT_EQ(this->Uploads(), 1);
  this->Shader()->SetMode(vtkSkylineSoftShadowShader::TRANSFER);
  this->Middle();
  EXPECT_EQ(this->Uploads(), 5);
  this->Shader()->SetMode(vtkSkylineSoftShadowShader::VISIBILITY);
  this->Middle();
  EXPECT_EQ(this->Uploads(), 10);
  this->Ground->GetPointData()->GetArray("Elevation")->Modified();
  this->Middle();
  EXPECT_EQ(this->Uploads(), 11) << "the normals alone";
  this->Shader()->SetMode(vtkSkylineSoftShadowShader::IRRADIANCE);
  vtkDataArray* light = this->Ground->GetPointData()->GetArray("Irradiance");
  light->FillComponent(0, 0.0);
  light->Modified();
  EXPECT_EQ(this->Middle()[0], 0);
  EXPECT_EQ(this->Uploads(), 12);
}

TEST_F(SoftShadowMapper, WhatIsNotThereIsNotInTheShader)
{
  this->Middle();
  for (const char* word : { "Lamp", "Harmonics", "Gradient", "skylineLight[" })
  {
    EXPECT_FALSE(this->TextHas(word)) << word;
  }
  EXPECT_TRUE(this->TextHas("skylineIrradiance"));
  this->Shader()->SetMode(vtkSkylineSoftShadowShader::TRANSFER);
  this->Middle();
  EXPECT_TRUE(this->TextHas("skylineHarmonics3"));
  EXPECT_FALSE(this->TextHas("skylineIrradiance") || this->TextHas("Gradient"));
  EXPECT_FALSE(this->TextHas("Lamp"));
  AddArray(this->Ground, "LampIrradiance", 1, [](int, int) { return std::vector<double>{ 1.0 }; });
  this->Middle();
  EXPECT_FALSE(this->TextHas("Lamp")) << "an array alone is no lamp";
  this->Shader()->SetLampRadiance(0, 1.0, 0.0, 0.0);
  this->Middle();
  EXPECT_TRUE(this->TextHas("SkylineLamps"));
  this->Shader()->SetLampRadiance(0, 0.0, 0.0, 0.0);
  this->Middle();
  EXPECT_FALSE(this->TextHas("Lamp"));
  EXPECT_TRUE(this->TextHas("ToneMap"));
  this->Shader()->ToneMappingOff();
  this->Middle();
  EXPECT_FALSE(this->TextHas("ToneMap"));
}

TEST_F(SoftShadowMapper, AMovedCameraCostsNothing)
{
  vtkNew<vtkHeightFieldVisibility> visibility;
  vtkNew<Counter> executions;
  visibility->AddObserver(vtkCommand::StartEvent, executions);
  visibility->SetInputData(this->Ground);
  visibility->SetNumberOfAzimuths(3);
  this->Shader()->SetHeightFieldConnection(visibility->GetOutputPort());
  this->Shader()->SetMode(vtkSkylineSoftShadowShader::VISIBILITY);
  this->Shader()->SetUniformLight(1.0, 1.0, 1.0);
  this->Middle();
  EXPECT_EQ(executions->Count, 1);
  const int uploads = this->Uploads();
  const vtkMTimeType text = this->Mapper->GetMTime();
  for (int frame = 0; frame < 3; ++frame)
  {
    this->Scene->Renderer->GetActiveCamera()->Azimuth(5.0);
    this->Scene->Render();
  }
  EXPECT_EQ(executions->Count, 1);
  EXPECT_EQ(this->Uploads(), uploads);
  EXPECT_EQ(this->Mapper->GetMTime(), text);
}

// In each mode, the shader contains code for lamps only while a lamp has light.
TEST_F(SoftShadowMapper, NoLampNoTextureAndNoText)
{
  AddArray(this->Ground, "LampIrradiance", 2,
    [](int, int) {
      return std::vector<double>{ 1.0, 2.0 };
    });
  for (const int mode : { vtkSkylineSoftShadowShader::IRRADIANCE,
         vtkSkylineSoftShadowShader::TRANSFER, vtkSkylineSoftShadowShader::VISIBILITY })
  {
    this->Shader()->SetMode(mode);
    this->Middle();
    const int uploads = this->Uploads();
    EXPECT_FALSE(this->TextHas("Lamp")) << mode;
    this->Shader()->SetLampRadiance(1, 0.5, 0.5, 0.5);
    this->Middle();
    EXPECT_TRUE(this->TextHas("SkylineLamps")) << mode;
    EXPECT_LE(this->Uploads(), uploads + 1) << mode;
    this->Shader()->SetLampRadiance(1, 0.0, 0.0, 0.0);
    this->Middle();
    EXPECT_FALSE(this->TextHas("Lamp")) << mode;
  }
}

TEST_F(SoftShadowMapper, VtksOwnLightsCountForNothing)
{
  const Byte3 lit = this->Middle();
  ExpectNear(lit, Seen(White, Light(0.5 * Pi)));
  this->Scene->Renderer->RemoveAllLights();
  this->Scene->Renderer->AutomaticLightCreationOff();
  EXPECT_EQ(this->Middle(), lit);
  this->Actor->GetProperty()->LightingOff();
  EXPECT_EQ(this->Middle(), lit);
  this->Actor->GetProperty()->SetInterpolationToPBR();
  EXPECT_EQ(this->Middle(), lit);
}

TEST_F(SoftShadowMapper, DrapedTexturesAreTheAlbedo)
{
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  places->SetNumberOfTuples(Size * Size);
  places->FillComponent(0, 0.5);
  places->FillComponent(1, 0.5);
  this->Mapper->GetInput()->GetPointData()->SetTCoords(places);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(PlainTexture(200, 100, 40));
  this->Actor->SetTexture(texture);
  const Rgb albedo = Decode(200.0 / 255.0, 100.0 / 255.0, 40.0 / 255.0);
  ExpectNear(this->Middle(), Seen(albedo, Light(0.5 * Pi)), "codes");
  // The same texture, as linear light.
  vtkNew<vtkTexture> linear;
  linear->SetInputData(PlainTexture(200, 100, 40));
  linear->UseSRGBColorSpaceOn();
  this->Actor->SetTexture(linear);
  ExpectNear(this->Middle(), Seen(albedo, Light(0.5 * Pi)), "light");
  // Without the texture again.
  this->Actor->SetTexture(nullptr);
  ExpectNear(this->Middle(), Seen(White, Light(0.5 * Pi)), "none");
}

TEST_F(SoftShadowMapper, ColorsOfScalarsAreTheAlbedo)
{
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 0.8, 0.4, 0.2);
  table->SetTableValue(1, 0.8, 0.4, 0.2);
  table->Build();
  this->Mapper->SetLookupTable(table);
  this->Mapper->ScalarVisibilityOn();
  this->Mapper->SetScalarRange(-1.0, 1.0);
  for (bool early : { false, true })
  {
    this->Mapper->SetInterpolateScalarsBeforeMapping(early);
    ExpectNear(this->Middle(), Seen(Decode(0.8, 0.4, 0.2), Light(0.5 * Pi)));
  }
}

TEST_F(SoftShadowMapper, ClippingPlanesCut)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5 * (Size - 1), 0.0, 0.0);
  plane->SetNormal(1.0, 0.0, 0.0);
  this->Mapper->AddClippingPlane(plane);
  this->Scene->Render();
  EXPECT_EQ(this->Scene->Pixel(1, 4), (Byte3{ { 0, 0, 0 } }));
  ExpectNear(this->Scene->Pixel(Size - 3, 4), Seen(White, Light(0.5 * Pi)));
}

TEST_F(SoftShadowMapper, EdgesAreDrawnByAGeometryShader)
{
  this->Actor->GetProperty()->EdgeVisibilityOn();
  this->Actor->GetProperty()->SetLineWidth(0.1f);
  this->Middle();
  this->Actor->GetProperty()->EdgeVisibilityOff();
  this->Actor->GetProperty()->SetRepresentationToWireframe();
  this->Actor->GetProperty()->SetLineWidth(5.0f);
  ExpectNear(this->Middle(), Seen(White, Light(0.5 * Pi)), "wide lines");
}

TEST_F(SoftShadowMapper, ActorsShareTheLightAndLeaveOthersAlone)
{
  // A second mesh over the same height field, higher, on the left half.
  vtkNew<vtkPlaneSource> left;
  left->SetOrigin(-1.0, -1.0, 5.0);
  left->SetPoint1(3.0, -1.0, 5.0);
  left->SetPoint2(-1.0, Size, 5.0);
  vtkNew<vtkSkylineSoftShadowPolyDataMapper> second;
  second->SetInputConnection(left->GetOutputPort());
  second->SetShader(this->Shader());
  this->Scene->Add(second)->GetProperty()->SetColor(0.5, 0.5, 0.5);
  // A mesh with an ordinary mapper on the right.
  vtkNew<vtkPlaneSource> right;
  right->SetOrigin(6.0, -1.0, 5.0);
  right->SetPoint1(Size, -1.0, 5.0);
  right->SetPoint2(6.0, Size, 5.0);
  vtkNew<vtkPolyDataMapper> ordinary;
  ordinary->SetInputConnection(right->GetOutputPort());
  vtkProperty* property = this->Scene->Add(ordinary)->GetProperty();
  property->SetColor(0.25, 0.5, 0.75);
  property->LightingOff();
  this->Scene->Render();
  ExpectNear(this->Scene->Pixel(1, 4), Seen(Decode(0.5, 0.5, 0.5), Light(0.5 * Pi)));
  ExpectNear(this->Scene->Pixel(4, 4), Seen(White, Light(0.5 * Pi)));
  ExpectNear(this->Scene->Pixel(7, 4), { { 64, 128, 191 } });
  EXPECT_EQ(this->Uploads(), 1) << "one texture for both";
}

// Two layers of half opacity: the upper one counts half, in sRGB codes as everywhere in VTK.
TEST_F(SoftShadowMapper, DepthPeelingBlendsLitVeils)
{
  const auto higher = this->Level(3.0);
  const auto veil = MapperOf(higher);
  const auto top = this->Scene->Add(veil);
  top->GetProperty()->SetColor(1.0, 0.0, 0.0);
  top->GetProperty()->SetOpacity(0.5);
  this->Actor->GetProperty()->SetColor(0.0, 1.0, 0.0);
  this->Actor->GetProperty()->SetOpacity(0.5);
  this->Scene->Renderer->UseDepthPeelingOn();
  this->Scene->Renderer->SetMaximumNumberOfPeels(8);
  this->Scene->Renderer->SetOcclusionRatio(0.0);
  const Byte3 seen = this->Middle();
  const int red = Seen({ { 1.0f, 0.0f, 0.0f } }, Light(0.5 * Pi))[0];
  const int green = Seen({ { 0.0f, 1.0f, 0.0f } }, Light(0.5 * Pi))[1];
  ExpectNear(seen, { { red / 2, green / 4, 0 } });
  // The actors in the other order give the same picture.
  this->Scene->Renderer->RemoveActor(this->Actor);
  this->Scene->Renderer->AddActor(this->Actor);
  EXPECT_EQ(this->Middle(), seen);
}

TEST_F(SoftShadowMapper, PickingFindsTheActor)
{
  this->Scene->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(this->Scene->Renderer);
  selector->SetArea(3, 3, 5, 5);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  vtkSmartPointer<vtkSelection> picked = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  ASSERT_NE(picked, nullptr);
  EXPECT_EQ(picked->GetNumberOfNodes(), 1u);
}

// A window that is released also releases its textures.
TEST_F(SoftShadowMapper, AnotherWindowGetsItsOwnTextures)
{
  const Byte3 lit = this->Middle();
  this->Scene->Renderer->RemoveActor(this->Actor);
  this->Scene = std::make_unique<MapScene>(this->Ground);
  this->Actor = this->Scene->Add(this->Mapper);
  this->Actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  EXPECT_EQ(this->Middle(), lit);
  EXPECT_EQ(this->Uploads(), 2);
  this->Scene->Window->Finalize();
  EXPECT_EQ(this->Middle(), lit);
  EXPECT_EQ(this->Uploads(), 3);
}

TEST_F(SoftShadowMapper, ThePipelineOfTheLightIsUpdated)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(this->Ground);
  this->Shader()->SetHeightFieldConnection(producer->GetOutputPort());
  ExpectNear(this->Middle(), Seen(White, Light(0.5 * Pi)));
  EXPECT_EQ(this->Shader()->GetHeightField(), this->Ground.Get());
}

// Light that was computed on the graphics processor stays there.
TEST_F(SoftShadowMapper, ATextureOfTheWindowIsTakenAsItIs)
{
  this->Scene->Render(); // makes the context
  std::vector<float> light(3 * Size * Size, static_cast<float>(0.25 * Pi));
  vtkNew<vtkTextureObject> texture;
  texture->SetContext(this->Scene->Window);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  ASSERT_TRUE(texture->Create2DFromRaw(Size, Size, 3, VTK_FLOAT, light.data()));
  this->Shader()->SetIrradianceTexture(texture);
  this->Shader()->SetIrradianceArrayName("None");
  ExpectNear(this->Middle(), Seen(White, Light(0.25 * Pi)));
  EXPECT_EQ(this->Uploads(), 1) << "that of the first picture";
  // The owner of the texture still has it after the mapper no longer uses it.
  this->Shader()->SetIrradianceTexture(nullptr);
  this->Shader()->SetIrradianceArrayName("Irradiance");
  ExpectNear(this->Middle(), Seen(White, Light(0.5 * Pi)));
  EXPECT_NE(texture->GetHandle(), 0u);
  texture->ReleaseGraphicsResources(this->Scene->Window);
}

TEST_F(SoftShadowErrors, ATextureWithoutAWindow)
{
  vtkNew<vtkTextureObject> texture;
  this->Shader()->SetIrradianceTexture(texture);
  this->ExpectRefused("the irradiance texture is not one of this window's");
}

TEST_F(SoftShadowErrors, MissingArraysAreNamed)
{
  this->Shader()->SetIrradianceArrayName("Sunshine");
  this->ExpectRefused("no point array Sunshine of 3 components");
  this->Shader()->SetIrradianceArrayName("Elevation");
  this->ExpectRefused("no point array Elevation of 3 components");
  this->Shader()->SetMode(vtkSkylineSoftShadowShader::TRANSFER);
  this->Shader()->SetTransferArrayName("T");
  this->ExpectRefused("no point array T of 16 components");
  this->Shader()->SetMode(vtkSkylineSoftShadowShader::VISIBILITY);
  this->Shader()->SetVisibilityArrayName("V");
  this->ExpectRefused("no point array V of 16 components");
  this->Shader()->SetVisibilityArrayName("VisibilitySH");
  this->Ground->GetPointData()->RemoveArray("Elevation");
  this->ExpectRefused("no point array Elevation of 1 components");
  this->Shader()->SetMode(vtkSkylineSoftShadowShader::IRRADIANCE);
  this->Shader()->SetIrradianceArrayName("Irradiance");
  this->Shader()->SetLampRadiance(2, 1.0, 1.0, 1.0);
  this->ExpectRefused("no point array LampIrradiance of 1 to 4 components");
  // After the correction the mapper draws.
  this->Shader()->SetLampRadiance(2, 0.0, 0.0, 0.0);
  ExpectNear(this->Middle(), Seen(White, Light(0.5 * Pi)));
}

TEST_F(SoftShadowErrors, NoHeightField)
{
  this->Shader()->SetHeightField(nullptr);
  this->ExpectRefused("no height field");
  vtkNew<vtkImageData> empty;
  this->Shader()->SetHeightField(empty);
  this->Middle();
  vtkNew<vtkImageData> solid;
  solid->SetDimensions(3, 3, 3);
  this->Shader()->SetHeightField(solid);
  this->ExpectRefused("not a 2-D image");
}

TEST_F(SoftShadowErrors, BeyondTheLargestTexture)
{
  this->Middle();
  const int limit = vtkTextureObject::GetMaximumTextureSize(this->Scene->Window);
  const auto strip = Terrain(limit + 1, 2, [](int, int) { return 0.0; });
  AddArray(strip, "Irradiance", 3, [](int, int) { return std::vector<double>(3, 1.0); });
  this->Shader()->SetHeightField(strip);
  this->ExpectRefused("exceed the largest texture of this OpenGL");
}

TEST_F(SoftShadowErrors, NoContext)
{
  // A renderer whose window has no context.
  vtkNew<vtkSkylineEGLWindow> dead;
  vtkNew<vtkRenderer> renderer;
  dead->AddRenderer(renderer);
  this->Errors->Count = 0;
  this->Mapper->RenderPiece(renderer, this->Actor);
  this->Mapper->RenderPiece(renderer, this->Actor);
  EXPECT_EQ(this->Errors->Count, 1);
  EXPECT_NE(this->Errors->Text.find("no OpenGL context"), std::string::npos);
  vtkNew<vtkRenderer> alone;
  this->Mapper->RenderPiece(alone, this->Actor);
  EXPECT_EQ(this->Errors->Count, 1);
}

TEST_F(SoftShadowErrors, CoefficientsAndLampsHaveARange)
{
  this->Shader()->SetLightCoefficient(16, 1.0, 1.0, 1.0);
  EXPECT_NE(this->Errors->Text.find("no light coefficient 16: 0 to 15"), std::string::npos);
  this->Shader()->SetLampRadiance(-1, 1.0, 1.0, 1.0);
  EXPECT_NE(this->Errors->Text.find("no lamp -1: 0 to 3"), std::string::npos);
}

} // namespace
} // namespace testing
} // namespace skyline
