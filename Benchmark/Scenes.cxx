// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "Data/ErrorReason.h"
#include "Reference/Shapes.h"
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
  // 3000 boxes on 1024 x 1024 posts, and the same density on any other size.
  const double part = static_cast<double>(size) / 1024.0;
  const auto count = std::max<std::ptrdiff_t>(1, std::lround(3000.0 * part * part));
  Scene scene{ "walls", "", shapes::RandomBoxes(size, size, 1.0, count, 40, 60.0, 1) };
  scene.Description =
    Describe(scene.Field, std::to_string(count) + " random boxes up to 60 m high");
  return scene;
}

// Stores the first reason of a failure, and prevents VTK from printing the messages.
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
    throw std::runtime_error(ErrorReason(reason));
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

// The path of a DEM that is delivered with the program, whether installed or in the build tree.
std::string BundledDem(const std::string& file)
{
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path beside = program.parent_path().parent_path() / "share" / "skyline" / file;
  return fs::exists(beside, none) ? beside.string() : SKYLINE_BUNDLED_DEM "/" + file;
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
  if (nameOrFile == "moving")
  {
    Scene scene{ nameOrFile, "", MovingTerrain(size, 0.0) };
    scene.Description = Describe(scene.Field, "hills under travelling waves, a frame of them");
    return scene;
  }
  if (nameOrFile == "helens")
  {
    return FromRaster(nameOrFile, BundledDem("SainteHelens.tif"));
  }
  if (nameOrFile == "lidar")
  {
    return FromRaster(nameOrFile, BundledDem("Frontignan.tif"));
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
