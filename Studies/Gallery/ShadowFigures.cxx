// SPDX-License-Identifier: BSD-3-Clause
// Lee & Kim (SHM): objects in the shadow of the terrain, and objects that cast a shadow. Timonen &
// Westerholm (2010), TW10, figure 8: lights of three sizes in a light map.
#include "Sheet.h"
#include "Sky/LightMap.h"
#include "Studio.h"

#include "Reference/FieldImage.h"
#include "vtkHeightFieldCap.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldShadowHeight.h"
#include "vtkHeightFieldSurface.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineSoftShadowPolyDataMapper.h"
#include "vtkSkylineSoftShadowShader.h"
#include "vtkSkylineSunLight.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace skyline
{
namespace gallery
{

namespace
{

constexpr double Degree = RadiansPerDegree;

// Dusk: the sun is low in the west, and the sky is dim.
constexpr double SunAzimuth = 255.0, SunElevation = 9.0;
constexpr std::array<double, 3> SunLight{ { 4.6, 2.7, 1.3 } };
constexpr std::array<double, 3> SkyLight{ { 0.20, 0.26, 0.40 } };

constexpr double Metres = 360.0; // width of the valley

/// A hilly valley with a ridge in the west, smooth where the village stands.
oracle::OracleField Valley(std::ptrdiff_t columns)
{
  const double spacing = Metres / static_cast<double>(columns);
  oracle::OracleField field = shapes::Fractal(columns, columns * 5 / 8, spacing, 16.0, 11, 0.45);
  for (std::ptrdiff_t row = 0; row < field.Rows; ++row)
  {
    for (std::ptrdiff_t column = 0; column < field.Columns; ++column)
    {
      const double x = static_cast<double>(column) * spacing;
      const double y = static_cast<double>(row) * spacing;
      const double crest = 34.0 + 7.0 * std::sin(0.031 * y) + 5.0 * std::sin(0.083 * y + 1.0);
      const double aside = (x - 55.0 - 9.0 * std::sin(0.02 * y)) / 34.0;
      const double smooth = 1.0 / (1.0 + std::exp((x - 120.0) / 12.0));
      double& height = field.At(column, row);
      height = crest * std::exp(-aside * aside) + height * (0.25 + 0.75 * smooth);
    }
  }
  return field;
}

/// The bilinear height at a position in metres.
double HeightAt(const oracle::OracleField& field, double x, double y)
{
  const double u = x / field.SpacingX, v = y / field.SpacingY;
  const auto column = static_cast<std::ptrdiff_t>(u), row = static_cast<std::ptrdiff_t>(v);
  const double s = u - static_cast<double>(column), t = v - static_cast<double>(row);
  return (1.0 - t) * ((1.0 - s) * field.At(column, row) + s * field.At(column + 1, row)) +
    t * ((1.0 - s) * field.At(column, row + 1) + s * field.At(column + 1, row + 1));
}

/// Polygons, built corner by corner.
class Mesh
{
public:
  Mesh() { this->Points->SetDataTypeToDouble(); }

  void Add(const std::vector<std::array<double, 3>>& corners)
  {
    this->Faces->InsertNextCell(static_cast<int>(corners.size()));
    for (const auto& corner : corners)
    {
      this->Faces->InsertCellPoint(this->Points->InsertNextPoint(corner.data()));
    }
  }

  vtkSmartPointer<vtkPolyData> Get() const
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(this->Points);
    data->SetPolys(this->Faces);
    return data;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Faces;
};

/// A house with a gable roof, turned by an angle. Sizes are half lengths in metres; the walls begin
/// below the ground.
void AddHouse(Mesh& mesh, double x, double y, double ground, double turn)
{
  constexpr double length = 7.0, width = 4.5, eaves = 5.0, ridge = 8.5, cellar = 3.0;
  const auto at = [&](double along, double across, double up)
  {
    return std::array<double, 3>{ { x + along * std::cos(turn) - across * std::sin(turn),
      y + along * std::sin(turn) + across * std::cos(turn), ground + up } };
  };
  for (const double side : { -1.0, 1.0 })
  {
    mesh.Add({ at(-length, side * width, -cellar), at(length, side * width, -cellar),
      at(length, side * width, eaves), at(-length, side * width, eaves) });
    mesh.Add({ at(-length, side * width, eaves), at(length, side * width, eaves),
      at(length, 0.0, ridge), at(-length, 0.0, ridge) });
    mesh.Add({ at(side * length, -width, -cellar), at(side * length, width, -cellar),
      at(side * length, width, eaves), at(side * length, 0.0, ridge),
      at(side * length, -width, eaves) });
  }
}

/// Three rows of houses, which leave the shadow of the ridge one after the other.
vtkSmartPointer<vtkPolyData> Village(const oracle::OracleField& field)
{
  Mesh mesh;
  shapes::Random random(5);
  for (int street = 0; street < 6; ++street)
  {
    for (int number = 0; number < 6; ++number)
    {
      const double x = 145.0 + 34.0 * street + static_cast<double>(random.Below(7));
      const double y = 24.0 + 32.0 * number + static_cast<double>(random.Below(9));
      const double turn = 0.1 * static_cast<double>(random.Below(7)) + (street % 2 ? 0.2 : 1.6);
      AddHouse(mesh, x, y, HeightAt(field, x, y), turn);
    }
  }
  return mesh.Get();
}

/// An aircraft of 60 m with a body, wings and a tail, which points along +x.
vtkSmartPointer<vtkPolyData> Aircraft()
{
  Mesh mesh;
  constexpr int sides = 16;
  constexpr double body = 2.6;
  const auto ring = [&](double x, double radius, int side)
  {
    const double angle = 2.0 * Pi * side / sides;
    return std::array<double, 3>{ { x, radius * std::cos(angle), radius * std::sin(angle) } };
  };
  constexpr std::array<std::array<double, 2>, 7> hull{ { { { -30.0, 0.2 } },
    { { -18.0, 0.8 * body } }, { { -10.0, body } }, { { 18.0, body } }, { { 24.0, 0.85 * body } },
    { { 28.0, 0.5 * body } }, { { 30.0, 0.05 } } } };
  for (std::size_t k = 0; k + 1 < hull.size(); ++k)
  {
    for (int side = 0; side < sides; ++side)
    {
      mesh.Add({ ring(hull[k][0], hull[k][1], side), ring(hull[k + 1][0], hull[k + 1][1], side),
        ring(hull[k + 1][0], hull[k + 1][1], side + 1), ring(hull[k][0], hull[k][1], side + 1) });
    }
  }
  for (const double side : { -1.0, 1.0 })
  {
    for (const double thick : { -0.25, 0.25 })
    {
      mesh.Add({ { { 8.0, 0.0, thick } }, { { -6.0, side * 30.0, 2.0 } },
        { { -10.0, side * 30.0, 2.0 } }, { { -3.0, 0.0, thick } } });
      mesh.Add({ { { -22.0, 0.0, 1.0 + thick } }, { { -28.0, side * 10.0, 1.5 } },
        { { -30.0, side * 10.0, 1.5 } }, { { -28.0, 0.0, 1.0 + thick } } });
    }
  }
  mesh.Add({ { { -21.0, 0.0, 1.5 } }, { { -28.0, 0.0, 11.0 } }, { { -31.0, 0.0, 11.0 } },
    { { -29.0, 0.0, 0.5 } } });
  return mesh.Get();
}

vtkSmartPointer<vtkActor> ActorOf(vtkPolyData* mesh, vtkHeightFieldShadowHeight* shadow,
  double exposure, const std::array<double, 3>& color)
{
  vtkNew<vtkSkylineSoftShadowPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkSkylineSoftShadowShader* shader = mapper->GetShader();
  shader->SetMode(vtkSkylineSoftShadowShader::RECEIVER);
  shader->SetHeightFieldConnection(shadow->GetOutputPort());
  shader->SetSunIrradiance(SunLight[0], SunLight[1], SunLight[2]);
  shader->SetUniformLight(SkyLight[0], SkyLight[1], SkyLight[2]);
  shader->SetExposure(exposure);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  return actor;
}

/// The ground of a field in the light of another field of the same size, which may include houses.
vtkSmartPointer<vtkActor> GroundOf(
  vtkImageData* ground, vtkImageData* occluders, double exposure, vtkPoints* points)
{
  vtkNew<vtkSkylineSunLight> sun;
  sun->SetAzimuth(SunAzimuth);
  sun->SetElevation(SunElevation);
  sun->SetIrradiance(SunLight[0], SunLight[1], SunLight[2]);
  vtkNew<vtkSkylineEnvironmentLight> sky;
  sky->SetRadiance(SkyLight[0], SkyLight[1], SkyLight[2]);
  vtkNew<vtkHeightFieldIrradiance> light;
  light->SetInputData(occluders);
  light->SetNumberOfAzimuths(32);
  light->AddLight(sun);
  light->AddLight(sky);
  light->Update();
  vtkNew<vtkHeightFieldSurface> surface;
  surface->SetInputData(ground);
  surface->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
  surface->Update();
  points->ShallowCopy(surface->GetOutput()->GetPoints());
  vtkNew<vtkSkylineSoftShadowPolyDataMapper> mapper;
  mapper->SetInputData(surface->GetOutput());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkImageData> lit;
  lit->ShallowCopy(light->GetOutput());
  mapper->GetShader()->SetHeightField(lit);
  mapper->GetShader()->SetExposure(exposure);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.62, 0.68, 0.55);
  return actor;
}

Figure Dusk(Studio& studio, const Scale& scale)
{
  constexpr double exposure = 0.9;
  const oracle::OracleField field = Valley(scale.Posts(720));
  const auto image = testing::ImageOf<vtkDoubleArray>(field);
  const auto village = Village(field);
  vtkNew<vtkHeightFieldCap> cap;
  cap->SetInputData(image);
  cap->SetObjectsData(village);
  cap->Update();
  vtkNew<vtkHeightFieldShadowHeight> shadow;
  shadow->SetInputData(image);
  shadow->SetSunAzimuth(SunAzimuth);
  shadow->SetSunElevation(SunElevation);
  shadow->SoftOn();

  Figure figure;
  figure.Title = "SHM: a village and an aircraft in the shadow of a ridge at dusk";
  Look look;
  look.From.Azimuth = 160.0;
  look.From.Elevation = 30.0;
  look.Width = scale.Pixels(520);
  look.Height = scale.Pixels(270);
  look.From.Filled = 1.45; // the corners of the field may lie outside
  const struct
  {
    const char* Label;
    const char* Caption;
    vtkImageData* Occluders;
  } rows[2] = { { "receivers only", "houses and aircraft shaded by the terrain's shadow height",
                  image },
    { "capped onto the height field", "the houses cast shadows on the ground, too",
      cap->GetOutput() } };
  for (const auto& row : rows)
  {
    vtkNew<vtkPoints> points;
    std::vector<vtkSmartPointer<vtkActor>> actors{ GroundOf(
      image, row.Occluders, exposure, points) };
    actors.push_back(ActorOf(village, shadow, exposure, { { 0.86, 0.80, 0.74 } }));
    const auto aircraft = ActorOf(Aircraft(), shadow, exposure, { { 0.9, 0.9, 0.92 } });
    aircraft->SetPosition(225.0, 80.0, 21.0);
    aircraft->SetOrientation(0.0, 0.0, 8.0);
    actors.push_back(aircraft);
    figure.Rows.push_back({ row.Label, { { row.Caption, studio.Draw(actors, points, look) } } });
  }
  return figure;
}

/// A light map with a dim sky and a disc of the given radius. A plane that faces the disc has the
/// same irradiance for all radii.
vtkSmartPointer<vtkImageData> MapWithLight(double radius)
{
  constexpr int columns = 720, rows = 360;
  constexpr double azimuth = 300.0 * Degree, elevation = 25.0 * Degree, facing = 2.6;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  vtkNew<vtkFloatArray> radiance;
  radiance->SetName("Radiance");
  radiance->SetNumberOfComponents(3);
  radiance->SetNumberOfTuples(static_cast<vtkIdType>(columns) * rows);
  image->GetPointData()->SetScalars(radiance);
  // The rows of the image begin at the nadir.
  const auto direction = [&](double column, double row)
  {
    const double a = (column / columns - 0.5) * 2.0 * Pi;
    const double e = (row / rows - 0.5) * Pi;
    return std::array<double, 3>{ { std::cos(e) * std::sin(a), std::cos(e) * std::cos(a),
      std::sin(e) } };
  };
  const std::array<double, 3> centre{ { std::cos(elevation) * std::sin(azimuth),
    std::cos(elevation) * std::cos(azimuth), std::sin(elevation) } };
  constexpr int inside = 4; // samples per pixel in each direction
  std::vector<double> cover(static_cast<std::size_t>(columns) * rows, 0.0);
  double whole = 0.0;
  for (int row = 0; row < rows; ++row)
  {
    const double angle =
      (std::sin(((row + 1.0) / rows - 0.5) * Pi) - std::sin((1.0 * row / rows - 0.5) * Pi)) * 2.0 *
      Pi / columns;
    for (int column = 0; column < columns; ++column)
    {
      double& part = cover[static_cast<std::size_t>(row) * columns + column];
      for (int k = 0; k < inside * inside; ++k)
      {
        const auto d =
          direction(column + (k % inside + 0.5) / inside, row + (k / inside + 0.5) / inside);
        const double cosine = d[0] * centre[0] + d[1] * centre[1] + d[2] * centre[2];
        if (cosine > std::cos(radius))
        {
          part += 1.0 / (inside * inside);
          whole += angle * cosine / (inside * inside);
        }
      }
    }
  }
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const vtkIdType pixel = static_cast<vtkIdType>(row) * columns + column;
      const double light = facing / whole * cover[static_cast<std::size_t>(pixel)];
      const double low = std::exp(-4.0 * std::max(0.0, direction(column, row + 0.5)[2]));
      radiance->SetTuple3(pixel, 0.06 + 0.05 * low + 1.00 * light, 0.09 + 0.05 * low + 0.88 * light,
        0.16 + 0.05 * low + 0.70 * light);
    }
  }
  return image;
}

vtkSmartPointer<vtkFloatArray> LightOf(vtkImageData* terrain, vtkImageData* map, int azimuths)
{
  vtkNew<vtkSkylineEnvironmentLight> environment;
  environment->SetImage(map);
  vtkNew<vtkHeightFieldIrradiance> light;
  light->SetInputData(terrain);
  light->SetNumberOfAzimuths(azimuths);
  light->AddLight(environment);
  light->Update();
  vtkFloatArray* found = testing::ArrayOf(light, "Irradiance");
  if (!found)
  {
    throw std::runtime_error("no irradiance");
  }
  return found;
}

Figure ThreeSizes(Studio& studio, const Scale& scale)
{
  const std::ptrdiff_t columns = scale.Posts(512);
  oracle::OracleField field =
    shapes::Fractal(columns, columns * 3 / 4, 256.0 / static_cast<double>(columns), 34.0, 4, 0.36);
  shapes::AddCone(field, 0.30 * static_cast<double>(columns), 0.30 * static_cast<double>(columns),
    8.0 / field.SpacingX, 60.0);
  shapes::AddCone(field, 0.62 * static_cast<double>(columns), 0.42 * static_cast<double>(columns),
    8.0 / field.SpacingX, 60.0);
  const auto image = testing::ImageOf<vtkDoubleArray>(field);
  Figure figure;
  figure.Title = "TW10, figure 8: one light in three sizes, from a map of 720 x 360 pixels";
  figure.Rows = { PanelRow{
    "irradiance by light tables, 64 azimuths and those that the map adds", {} } };
  Look look;
  look.From.Azimuth = 200.0;
  look.From.Elevation = 55.0;
  look.From.Filled = 1.1;
  look.Width = scale.Pixels(290);
  look.Height = scale.Pixels(230);
  look.Exposure = 0.6;
  for (const double radius : { 0.5, 5.0, 20.0 })
  {
    char name[32];
    std::snprintf(name, sizeof(name), "radius %g degrees", radius);
    const auto map = MapWithLight(radius * Degree);
    const auto truth = LightOf(image, map, 1024);
    const std::vector<float> right(
      truth->GetPointer(0), truth->GetPointer(truth->GetNumberOfValues()));
    double squares = 0.0;
    for (const float value : right)
    {
      squares += static_cast<double>(value) * static_cast<double>(value);
    }
    const double unit = std::sqrt(squares / static_cast<double>(right.size()));
    for (const int azimuths : { 16, 64, 128 })
    {
      const auto light = LightOf(image, map, azimuths);
      const std::vector<float> found(
        light->GetPointer(0), light->GetPointer(light->GetNumberOfValues()));
      figure.Table.push_back({ std::string(name) + ", " + std::to_string(azimuths) + " azimuths",
        "1024 azimuths", ErrorsOf(found, right, unit) });
      if (azimuths == 64)
      {
        figure.Rows[0].Panels.push_back({ name, studio.Draw(field, found, look) });
      }
    }
  }
  return figure;
}

} // namespace

std::vector<FigureMaker> ShadowFigures()
{
  return { { "shm-8", Dusk }, { "tw10-8", ThreeSizes } };
}

} // namespace gallery
} // namespace skyline
