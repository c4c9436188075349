// SPDX-License-Identifier: BSD-3-Clause
// The mode RECEIVER of the mapper: objects above the terrain, drawn in its shadow and compared
// pixel by pixel.
#include "MapperTesting.h"

#include "vtkHeightFieldShadowHeight.h"
#include "vtkHeightFieldShadowReceiver.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkPoints.h"

#include "vtkCellArray.h"
#include "vtkSphereSource.h"

#include <memory>

namespace skyline
{
namespace testing
{
namespace
{

constexpr int Columns = 90, Rows = 60;
constexpr double Azimuth = 90.0, Elevation = 20.0, Radius = 2.0;
constexpr double West = 5.0e5, South = 4.0e6;
constexpr double Sun = 2.0, Sky = 0.1; // irradiance of a plane facing the sun, radiance

/// The arc cosine of Mesa's shaders has an error of 2e-4 of the light: one more code.
constexpr int PenumbraTolerance = CodeTolerance + 1;

/// A sphere of 180 faces around: the normals of its faces differ by a degree.
constexpr int FacetTolerance = 5;

const Rgb White{ { 1.0f, 1.0f, 1.0f } };

double Sine()
{
  return std::sin(Elevation * Pi / 180.0);
}

/// The codes of a white plane that a part of the sun lights at the given cosine.
Byte3 Shown(double lit, double cosine)
{
  const auto e = static_cast<float>(Sun * lit * cosine + Pi * Sky);
  return Seen(White, Rgb{ { e, e, e } });
}

/// Hills, and a ridge in the east, far from the origin of the coordinates.
double HeightAt(int column, int row)
{
  const double hill = 3.0 * std::sin(0.31 * column + 0.17 * row) * std::cos(0.23 * row);
  return column >= Columns - 4 ? 30.0 : hill;
}

class ReceiverMode : public Drawing
{
protected:
  void SetUp() override
  {
    Drawing::SetUp();
    if (this->IsSkipped())
    {
      return;
    }
    this->Image = Terrain(Columns, Rows, HeightAt, 1.0, West, South);
    this->Map->SetInputData(this->Image);
    this->Map->SetSunAzimuth(Azimuth);
    this->Map->SetSunElevation(Elevation);
    this->Map->SetSunAngularRadius(Radius);
    this->Map->SoftOn();
    this->Scene = std::make_unique<MapScene>(this->Image);
    this->Mapper->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    this->Actor = this->Scene->Add(this->Mapper);
    this->Actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    vtkSkylineSoftShadowShader* shader = this->Mapper->GetShader();
    shader->SetHeightFieldConnection(this->Map->GetOutputPort());
    shader->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    shader->SetMode(vtkSkylineSoftShadowShader::RECEIVER);
    shader->SetSunIrradiance(Sun, Sun, Sun);
    shader->SetUniformLight(Sky, Sky, Sky);
  }

  /// A level roof over the whole scene, one pixel wider on each side.
  vtkSmartPointer<vtkPolyData> Roof(double z)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->InsertNextPoint(West - 1.0, South - 1.0, z);
    points->InsertNextPoint(West + Columns, South - 1.0, z);
    points->InsertNextPoint(West + Columns, South + Rows, z);
    points->InsertNextPoint(West - 1.0, South + Rows, z);
    vtkNew<vtkCellArray> faces;
    const vtkIdType corners[4] = { 0, 1, 2, 3 };
    faces->InsertNextCell(4, corners);
    auto roof = vtkSmartPointer<vtkPolyData>::New();
    roof->SetPoints(points);
    roof->SetPolys(faces);
    return roof;
  }

  /// The visible part of the sun that the filter finds for a point over each post. heights: those
  /// of the points.
  std::vector<double> LitByFilter(
    const std::function<double(int, int)>& heights, double depth = 0.0)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int row = 0; row < Rows; ++row)
    {
      for (int column = 0; column < Columns; ++column)
      {
        points->InsertNextPoint(West + column, South + row, heights(column, row));
      }
    }
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(points);
    vtkNew<vtkHeightFieldShadowReceiver> receiver;
    receiver->SetInputData(cloud);
    receiver->SetShadowConnection(this->Map->GetOutputPort());
    receiver->SetPenumbraDepth(depth);
    receiver->Update();
    auto* output = vtkPointSet::SafeDownCast(receiver->GetOutputDataObject(0));
    vtkDataArray* lit = output->GetPointData()->GetArray("SunVisibility");
    std::vector<double> values;
    for (vtkIdType post = 0; post < lit->GetNumberOfTuples(); ++post)
    {
      values.push_back(lit->GetComponent(post, 0));
    }
    return values;
  }

  /// Compares all pixels inside the rim with the visible parts of the sun.
  void ExpectPicture(const std::vector<double>& lit, double cosine)
  {
    this->Scene->Render();
    int wrong = 0, dark = 0, partly = 0, whole = 0;
    for (int row = 1; row + 1 < Rows; ++row)
    {
      for (int column = 1; column + 1 < Columns; ++column)
      {
        const double part = lit[static_cast<std::size_t>(row * Columns + column)];
        const Byte3 seen = this->Scene->Pixel(column, row);
        const Byte3 wanted = Shown(part, cosine);
        wrong += std::abs(seen[0] - wanted[0]) > PenumbraTolerance ? 1 : 0;
        dark += part <= 0.0 ? 1 : 0;
        whole += part >= 1.0 ? 1 : 0;
        partly += part > 0.0 && part < 1.0 ? 1 : 0;
      }
    }
    EXPECT_EQ(wrong, 0) << dark << " dark, " << partly << " partly, " << whole << " lit";
    EXPECT_GT(dark, 0);
    EXPECT_GT(whole, 0);
    this->Partly = partly;
  }

  vtkSmartPointer<vtkImageData> Image;
  vtkNew<vtkHeightFieldShadowHeight> Map;
  vtkNew<vtkSkylineSoftShadowPolyDataMapper> Mapper;
  vtkNew<ErrorCatcher> Errors;
  std::unique_ptr<MapScene> Scene;
  vtkSmartPointer<vtkActor> Actor;
  int Partly = 0;
};

TEST_F(ReceiverMode, ARoofInTheShadowOfARidge)
{
  this->Mapper->SetInputData(this->Roof(8.0));
  this->ExpectPicture(this->LitByFilter([](int, int) { return 8.0; }), Sine());
  EXPECT_GT(this->Partly, 500);
  // Edges are drawn with a geometry shader. They lie outside; a few pixels of the diagonal are
  // visible.
  const Byte3 lit = this->Scene->Pixel(80, 10), dark = this->Scene->Pixel(30, 50);
  EXPECT_NE(lit, dark);
  this->Actor->GetProperty()->EdgeVisibilityOn();
  this->Scene->Render();
  EXPECT_EQ(this->Scene->Pixel(80, 10), lit);
  EXPECT_EQ(this->Scene->Pixel(30, 50), dark);
  EXPECT_EQ(this->Errors->Text, "");
}

TEST_F(ReceiverMode, APointSunAndAPublishedPenumbra)
{
  this->Map->SoftOff();
  this->Mapper->SetInputData(this->Roof(8.0));
  this->ExpectPicture(this->LitByFilter([](int, int) { return 8.0; }), Sine());
  EXPECT_EQ(this->Partly, 0);
  this->Mapper->GetShader()->SetPenumbraDepth(6.0);
  this->ExpectPicture(this->LitByFilter([](int, int) { return 8.0; }, 6.0), Sine());
  EXPECT_GT(this->Partly, 500);
}

// The ground as a receiver: points have no normals, so each post shows its visible part of the sun.
TEST_F(ReceiverMode, TheGroundIsLitAsTheSunVisibilityHasIt)
{
  vtkNew<vtkHeightFieldSurface> surface;
  surface->SetInputData(this->Image);
  surface->Update();
  this->Mapper->SetInputData(surface->GetOutput());
  this->Mapper->ScalarVisibilityOff();
  this->Actor->GetProperty()->SetRepresentationToPoints();
  this->ExpectPicture(this->LitByFilter(HeightAt), 1.0);
  EXPECT_GT(this->Partly, 200);

  this->Map->SoftOff();
  vtkNew<vtkHeightFieldSunShadow> truth;
  truth->SetInputData(this->Image);
  truth->SetSunAzimuth(Azimuth);
  truth->SetSunElevation(Elevation);
  truth->SetSunAngularRadius(0.0);
  truth->Update();
  vtkDataArray* visible = truth->GetOutput()->GetPointData()->GetArray("SunVisibility");
  std::vector<double> lit;
  for (vtkIdType post = 0; post < visible->GetNumberOfTuples(); ++post)
  {
    lit.push_back(visible->GetComponent(post, 0));
  }
  this->ExpectPicture(lit, 1.0);
}

TEST_F(ReceiverMode, NormalsOfPointsOrOfFaces)
{
  constexpr double size = 20.0, x = 40.0, y = 30.0;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(West + x, South + y, 100.0);
  sphere->SetRadius(size);
  sphere->SetThetaResolution(180);
  sphere->SetPhiResolution(180);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  this->Mapper->SetInputConnection(sphere->GetOutputPort());
  for (const bool flat : { false, true })
  {
    flat ? this->Actor->GetProperty()->SetInterpolationToFlat()
         : this->Actor->GetProperty()->SetInterpolationToGouraud();
    this->Scene->Render();
    for (const int east : { -12, -5, 0, 7, 14 })
    {
      for (const int north : { -9, 0, 11 })
      {
        const double up = std::sqrt(size * size - east * east - north * north);
        const double cosine =
          (east * std::cos(Elevation * Pi / 180.0) + up * Sine()) / size; // the sun is in the east
        const Byte3 seen = this->Scene->Pixel(40 + east, 30 + north);
        EXPECT_NEAR(seen[0], Shown(1.0, std::max(0.0, cosine))[0], FacetTolerance)
          << flat << " " << east << " " << north;
      }
    }
  }
}

TEST_F(ReceiverMode, TheSkyIsTheLightsHarmonics)
{
  this->Mapper->SetInputData(this->Roof(200.0));
  constexpr double zenith = 0.3; // coefficient of the harmonic l = 1, m = 0
  this->Mapper->GetShader()->SetLightCoefficient(2, zenith, zenith, zenith);
  this->Mapper->GetShader()->SetSunIrradiance(0.0, 0.0, 0.0);
  this->Scene->Render();
  const auto e =
    static_cast<float>(Pi * Sky + zenith * std::sqrt(3.0 / (4.0 * Pi)) * 2.0 * Pi / 3.0);
  ExpectNear(this->Scene->Pixel(40, 30), Seen(White, Rgb{ { e, e, e } }));
}

TEST_F(ReceiverMode, AnActorsMatrixMovesItThroughTheShadow)
{
  this->Mapper->SetInputData(this->Roof(8.0));
  this->Actor->SetPosition(0.0, 0.0, -3.0);
  this->ExpectPicture(this->LitByFilter([](int, int) { return 5.0; }), Sine());
  this->Actor->SetPosition(0.0, 0.0, 100.0);
  this->Scene->Render();
  ExpectNear(this->Scene->Pixel(80, 30), Shown(1.0, Sine()), "above all shadows");
}

TEST_F(ReceiverMode, OutsideTheFieldNothingShades)
{
  vtkNew<vtkImageData> west;
  west->DeepCopy(this->Image);
  west->SetOrigin(West + 45.0, South, 0.0);
  this->Map->SetInputData(west);
  this->Mapper->SetInputData(this->Roof(8.0));
  this->Scene->Render();
  ExpectNear(this->Scene->Pixel(40, 30), Shown(1.0, Sine()));
}

TEST_F(ReceiverMode, ASetSunLightsNothing)
{
  this->Map->SetSunElevation(-3.0);
  this->Mapper->SetInputData(this->Roof(8.0));
  this->Scene->Render();
  ExpectNear(this->Scene->Pixel(40, 30), Shown(0.0, 1.0));
}

TEST_F(ReceiverMode, WithoutShadowHeightsItSaysWhatToGive)
{
  this->Mapper->SetInputData(this->Roof(8.0));
  this->Mapper->GetShader()->SetHeightField(this->Image);
  this->Scene->Render();
  this->Scene->Render();
  EXPECT_EQ(this->Errors->Count, 1);
  EXPECT_NE(
    this->Errors->Text.find("give the output of vtkHeightFieldShadowHeight"), std::string::npos)
    << this->Errors->Text;
  EXPECT_EQ(this->Scene->Pixel(40, 30), (Byte3{ { 0, 0, 0 } }));
}

} // namespace
} // namespace testing
} // namespace skyline
