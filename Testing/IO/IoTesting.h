// SPDX-License-Identifier: BSD-3-Clause
// Makes small rasters, and collects the messages of a reader or writer that fails.
#ifndef skyline_IoTesting_h
#define skyline_IoTesting_h

#include "Data/ImageGeoreference.h"
#include "vtkHeightFieldReader.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace skyline_test
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Collects the errors of an algorithm during its lifetime. Nothing is printed.
class Errors
{
public:
  explicit Errors(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
    this->Own->SetClientData(this);
    this->Own->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<Errors*>(self)->Texts.emplace_back(static_cast<const char*>(text)); });
    algorithm->AddObserver(vtkCommand::ErrorEvent, this->Own);
    algorithm->AddObserver(vtkCommand::WarningEvent, this->Executive); // for TestReaderDoubts
    // Ignores the message "returned failure", which VTK's executive adds.
    this->Executive->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Executive);
  }
  ~Errors()
  {
    this->Algorithm->RemoveObserver(this->Own);
    this->Algorithm->RemoveObserver(this->Executive);
    this->Algorithm->GetExecutive()->RemoveObserver(this->Executive);
  }
  Errors(const Errors&) = delete;
  Errors& operator=(const Errors&) = delete;

  std::size_t Count() const { return this->Texts.size(); }

  /// The first message, without the file, line and class that VTK adds.
  std::string First() const
  {
    if (this->Texts.empty())
    {
      return "";
    }
    const std::string& text = this->Texts.front();
    const std::size_t object = text.find("): ");
    std::string message = object == std::string::npos ? text : text.substr(object + 3);
    message.erase(message.find_last_not_of('\n') + 1);
    return message;
  }

private:
  vtkAlgorithm* Algorithm;
  vtkNew<vtkCallbackCommand> Own, Executive;
  std::vector<std::string> Texts;
};

inline std::string OutputPath(const std::string& name)
{
  return std::string(SKYLINE_TEST_OUTPUT) + "/" + name;
}

inline std::string DataPath(const std::string& name)
{
  return std::string(SKYLINE_TEST_DATA) + "/" + name;
}

/// Makes an empty folder for this test alone.
inline std::string FreshFolder(const std::string& name)
{
  const std::string folder = OutputPath(name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::vector<std::string> FilesIn(const std::string& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

/// Describes a raster. Value is a function of column and line; line 0 is the first of the file.
struct Recipe
{
  int Columns = 5, Lines = 4;
  GDALDataType Type = GDT_Float32;
  int Bands = 1;
  std::string Crs;
  std::vector<double> Transform; ///< empty: none
  std::function<double(int, int)> Value = [](int column, int line) { return 10.0 * line + column; };
  double Nodata = 0.0;
  bool HasNodata = false;
  double Scale = 1.0, Offset = 0.0;
  std::string Unit;
  std::string Description;
};

inline OGRSpatialReference CrsFrom(const std::string& text)
{
  OGRSpatialReference crs;
  EXPECT_EQ(crs.SetFromUserInput(text.c_str()), OGRERR_NONE) << text;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

/// Writes the data of an open dataset and closes it.
inline void Fill(GDALDataset* dataset, const Recipe& recipe)
{
  if (!recipe.Crs.empty())
  {
    const OGRSpatialReference crs = CrsFrom(recipe.Crs);
    dataset->SetSpatialRef(&crs);
  }
  if (!recipe.Transform.empty())
  {
    std::vector<double> transform = recipe.Transform;
    dataset->SetGeoTransform(transform.data());
  }
  for (int number = 1; number <= recipe.Bands; ++number)
  {
    GDALRasterBand* band = dataset->GetRasterBand(number);
    if (recipe.HasNodata)
    {
      band->SetNoDataValue(recipe.Nodata);
    }
    if (recipe.Scale != 1.0 || recipe.Offset != 0.0)
    {
      band->SetScale(recipe.Scale);
      band->SetOffset(recipe.Offset);
    }
    if (!recipe.Unit.empty())
    {
      band->SetUnitType(recipe.Unit.c_str());
    }
    band->SetDescription(recipe.Description.c_str());
    std::vector<double> line(static_cast<std::size_t>(recipe.Columns));
    for (int j = 0; j < recipe.Lines; ++j)
    {
      for (int i = 0; i < recipe.Columns; ++i)
      {
        line[static_cast<std::size_t>(i)] = recipe.Value(i, j) + 1000.0 * (number - 1);
      }
      EXPECT_EQ(band->RasterIO(GF_Write, 0, j, recipe.Columns, 1, line.data(), recipe.Columns, 1,
                  GDT_Float64, 0, 0, nullptr),
        CE_None);
    }
  }
  GDALClose(dataset);
}

/// Makes a GeoTIFF and returns its name.
inline std::string Make(const Recipe& recipe, const std::string& name = "/vsimem/made.tif")
{
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  Fill(
    driver->Create(name.c_str(), recipe.Columns, recipe.Lines, recipe.Bands, recipe.Type, nullptr),
    recipe);
  return name;
}

/// Reads a file, and checks that this succeeds.
inline vtkSmartPointer<vtkHeightFieldReader> Read(const std::string& file, int band = 1)
{
  auto reader = vtkSmartPointer<vtkHeightFieldReader>::New();
  const Errors errors(reader);
  reader->SetFileName(file.c_str());
  reader->SetBand(band);
  reader->Update();
  EXPECT_EQ(errors.First(), "");
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError);
  return reader;
}

inline vtkSmartPointer<vtkImageData> ReadImage(const Recipe& recipe)
{
  return Read(Make(recipe))->GetOutput();
}

inline double HeightAt(vtkImageData* image, int column, int row)
{
  int point[3] = { column, row, 0 };
  return image->GetPointData()
    ->GetArray("Elevation")
    ->GetComponent(image->ComputePointId(point), 0);
}

} // namespace skyline_test

#endif
