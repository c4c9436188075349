// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "Shapes.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkHeightFieldReader.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace skyline
{
namespace benchmark
{

namespace
{

std::string Describe(const oracle::OracleField& field, const std::string& what)
{
  std::size_t missing = 0;
  for (const double height : field.Heights)
  {
    missing += std::isfinite(height) ? 0 : 1;
  }
  char text[160];
  std::snprintf(text, sizeof text, "%s, %td x %td posts, %.4g x %.4g m, %.1f %% missing",
    what.c_str(), field.Columns, field.Rows, field.SpacingX, field.SpacingY,
    100.0 * static_cast<double>(missing) / static_cast<double>(field.Heights.size()));
  return text;
}

Scene Fractal(const std::string& name, std::ptrdiff_t size, double roughness)
{
  char what[80];
  std::snprintf(what, sizeof what, "fractal, 1500 m of relief, roughness %.2f", roughness);
  Scene scene{ name, "", shapes::Fractal(size, size, 30.0, 1500.0, 1, roughness) };
  scene.Description = Describe(scene.Field, what);
  return scene;
}

Scene Walls(std::ptrdiff_t size)
{
  // 3000 boxes on a thousand posts squared, as many for the area on any other size.
  const double part = static_cast<double>(size) / 1024.0;
  const auto count = std::max<std::ptrdiff_t>(1, std::lround(3000.0 * part * part));
  Scene scene{ "walls", "", shapes::RandomBoxes(size, size, 1.0, count, 40, 60.0, 1) };
  scene.Description =
    Describe(scene.Field, std::to_string(count) + " random boxes up to 60 m high");
  return scene;
}

// A house with a gable roof along the longer side, posts [i0, i1) x [j0, j1).
void AddHouse(oracle::OracleField& field, std::ptrdiff_t i0, std::ptrdiff_t j0, std::ptrdiff_t i1,
  std::ptrdiff_t j1, double eaves, double ridge)
{
  const double ground = field.At((i0 + i1) / 2, (j0 + j1) / 2);
  for (std::ptrdiff_t j = j0; j < j1; ++j)
  {
    for (std::ptrdiff_t i = i0; i < i1; ++i)
    {
      const bool across = i1 - i0 < j1 - j0;
      const std::ptrdiff_t place = across ? i - i0 : j - j0;
      const std::ptrdiff_t last = (across ? i1 - i0 : j1 - j0) - 1;
      const double middle = 0.5 * static_cast<double>(last);
      const double roof =
        1.0 - std::abs(static_cast<double>(place) - middle) / std::max(1.0, middle);
      field.At(i, j) = ground + eaves + (ridge - eaves) * roof;
    }
  }
}

// A crown of leaves: half an ellipsoid, ragged.
void AddTree(oracle::OracleField& field, std::ptrdiff_t column, std::ptrdiff_t row, double radius,
  double height, shapes::Random& random)
{
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(radius));
  const double ground = field.At(column, row);
  for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(0, row - reach);
       j <= std::min(field.Rows - 1, row + reach); ++j)
  {
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, column - reach);
         i <= std::min(field.Columns - 1, column + reach); ++i)
    {
      const double d =
        std::hypot(static_cast<double>(i - column), static_cast<double>(j - row)) / radius;
      if (d < 1.0)
      {
        const double crown = height * (0.4 + 0.6 * std::sqrt(1.0 - d * d)) - 1.5 * random();
        field.At(i, j) = std::max(field.At(i, j), ground + crown);
      }
    }
  }
}

// What an airborne laser sees of a village, a post a metre: ground, roofs, trees, and its noise.
Scene Village(std::ptrdiff_t size)
{
  Scene scene{ "lidar", "", shapes::Fractal(size, size, 1.0, 0.06 * static_cast<double>(size), 3) };
  oracle::OracleField& field = scene.Field;
  shapes::Random random(5);
  const std::ptrdiff_t houses = std::max<std::ptrdiff_t>(1, size * size / 1200);
  for (std::ptrdiff_t k = 0; k < houses; ++k)
  {
    const std::ptrdiff_t i0 = random.Below(size - 1), j0 = random.Below(size - 1);
    const std::ptrdiff_t i1 = std::min(size, i0 + 8 + random.Below(10));
    const std::ptrdiff_t j1 = std::min(size, j0 + 8 + random.Below(14));
    const double eaves = 3.0 + 5.0 * random();
    AddHouse(field, i0, j0, i1, j1, eaves, eaves + 4.0);
  }
  for (std::ptrdiff_t k = 0; k < 2 * houses; ++k)
  {
    const std::ptrdiff_t column = random.Below(size);
    const double radius = 2.0 + 3.0 * random();
    AddTree(field, column, random.Below(size), radius, 6.0 + 14.0 * random(), random);
  }
  constexpr double noise = 0.05; // metres, of a good survey
  for (double& height : field.Heights)
  {
    height += noise * (2.0 * random() - 1.0);
  }
  scene.Description =
    Describe(field, "surface as a laser sees it, " + std::to_string(houses) + " houses, trees");
  return scene;
}

// Keeps the first reason of a failure, and VTK from printing all of them.
void KeepReason(vtkObject*, unsigned long, void* reason, void* message)
{
  auto& text = *static_cast<std::string*>(reason);
  text = text.empty() ? static_cast<const char*>(message) : text;
}

Scene FromRaster(const std::string& name, const std::string& file)
{
  std::string reason;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetCallback(KeepReason);
  keep->SetClientData(&reason);
  vtkNew<vtkHeightFieldReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, keep);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, keep);
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  if (reader->GetErrorCode() != vtkErrorCode::NoError || heights == nullptr)
  {
    // VTK puts the place in its source and the object before the reason.
    const std::size_t object = reason.find("): ");
    const std::size_t begin = object == std::string::npos ? 0 : object + 3;
    throw std::runtime_error(reason.substr(begin, reason.find_last_not_of('\n') + 1 - begin));
  }
  const int* size = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  const std::ptrdiff_t columns = std::min<std::ptrdiff_t>(size[0], LargestSide);
  const std::ptrdiff_t rows = std::min<std::ptrdiff_t>(size[1], LargestSide);
  const std::ptrdiff_t west = (size[0] - columns) / 2, south = (size[1] - rows) / 2;
  Scene scene{ name, "", oracle::OracleField(columns, rows, spacing[0], spacing[1]) };
  for (std::ptrdiff_t row = 0; row < rows; ++row)
  {
    for (std::ptrdiff_t column = 0; column < columns; ++column)
    {
      scene.Field.At(column, row) =
        heights->GetComponent((south + row) * size[0] + west + column, 0);
    }
  }
  const bool whole = columns == size[0] && rows == size[1];
  scene.Description = Describe(
    scene.Field, (whole ? "" : "middle of ") + std::filesystem::path(file).filename().string());
  return scene;
}

// The bundled DEM beside the program, installed or not; else where it was built.
std::string BundledDem()
{
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path beside =
    program.parent_path().parent_path() / "share" / "skyline" / "SainteHelens.tif";
  return fs::exists(beside, none) ? beside.string() : SKYLINE_BUNDLED_DEM "/SainteHelens.tif";
}

} // namespace

const std::vector<std::string>& SceneNames()
{
  static const std::vector<std::string> names{ "smooth", "hills", "rough", "walls", "helens",
    "cone", "bowl", "lidar", "moving" };
  return names;
}

Scene MakeScene(const std::string& nameOrFile, std::ptrdiff_t size)
{
  if (nameOrFile == "smooth")
  {
    return Fractal(nameOrFile, size, 0.50);
  }
  if (nameOrFile == "hills")
  {
    return Fractal(nameOrFile, size, 0.55);
  }
  if (nameOrFile == "rough")
  {
    return Fractal(nameOrFile, size, 0.65);
  }
  if (nameOrFile == "walls")
  {
    return Walls(size);
  }
  const auto side = static_cast<double>(size);
  if (nameOrFile == "cone")
  {
    Scene scene{ nameOrFile, "", shapes::Cone(size, size, 10.0, 4.0 * side, 2.0 * side) };
    scene.Description = Describe(scene.Field, "a cone on level ground");
    return scene;
  }
  if (nameOrFile == "bowl")
  {
    Scene scene{ nameOrFile, "", shapes::Bowl(size, size, 10.0, 4.0 * side, 0.4 * Pi) };
    scene.Description = Describe(scene.Field, "a spherical bowl in level ground");
    return scene;
  }
  if (nameOrFile == "lidar")
  {
    return Village(size);
  }
  if (nameOrFile == "moving")
  {
    Scene scene{ nameOrFile, "", MovingTerrain(size, 0.0) };
    scene.Description = Describe(scene.Field, "hills under travelling waves, a frame of them");
    return scene;
  }
  if (nameOrFile == "helens")
  {
    return FromRaster(nameOrFile, BundledDem());
  }
  return FromRaster(std::filesystem::path(nameOrFile).stem().string(), nameOrFile);
}

oracle::OracleField MovingTerrain(std::ptrdiff_t size, double time)
{
  oracle::OracleField field = shapes::Fractal(size, size, 30.0, 800.0, 2);
  for (std::ptrdiff_t row = 0; row < size; ++row)
  {
    for (std::ptrdiff_t column = 0; column < size; ++column)
    {
      const double phase =
        0.11 * static_cast<double>(column) + 0.05 * static_cast<double>(row) - time;
      field.At(column, row) += 60.0 * std::sin(phase);
    }
  }
  return field;
}

} // namespace benchmark
} // namespace skyline
