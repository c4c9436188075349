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
  Scene scene{ name, "", oracle::OracleField(size[0], size[1], spacing[0], spacing[1]) };
  for (std::size_t post = 0; post < scene.Field.Heights.size(); ++post)
  {
    scene.Field.Heights[post] = heights->GetComponent(static_cast<vtkIdType>(post), 0);
  }
  scene.Description = Describe(scene.Field, std::filesystem::path(file).filename().string());
  return scene;
}

} // namespace

const std::vector<std::string>& SceneNames()
{
  static const std::vector<std::string> names{ "smooth", "hills", "rough", "walls", "helens" };
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
  if (nameOrFile == "helens")
  {
    return FromRaster(nameOrFile, SKYLINE_BUNDLED_DEM "/SainteHelens.tif");
  }
  return FromRaster(std::filesystem::path(nameOrFile).stem().string(), nameOrFile);
}

} // namespace benchmark
} // namespace skyline
