// SPDX-License-Identifier: BSD-3-Clause
#include "Files.h"

#include "AtomicFile.h"
#include "Data/ImageGeoreference.h"
#include "Failure.h"
#include "SourceFiles.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkHeightFieldPictureWriter.h"
#include "vtkHeightFieldReader.h"
#include "vtkHeightFieldWriter.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

namespace
{

std::string UnitOf(const std::string& array)
{
  if (array == "Irradiance")
  {
    return "W/m2";
  }
  if (array.rfind("ShadowHeight", 0) == 0)
  {
    return "m";
  }
  return array == "HorizonElevation" || array == "PositiveOpenness" ? "degree" : "1";
}

vtkImageData* ImageOf(vtkAlgorithm* source)
{
  return vtkImageData::SafeDownCast(source->GetOutputDataObject(0));
}

void SetBandTexts(
  vtkHeightFieldWriter* writer, vtkImageData* image, const std::string& name, int& band)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name.c_str());
  const int count = array ? array->GetNumberOfComponents() : 0;
  for (int i = 0; i < count; ++i)
  {
    std::string description = name;
    if (name == "HorizonElevation")
    {
      std::array<char, 32> azimuth;
      std::snprintf(azimuth.data(), azimuth.size(), " azimuth %.10g", 360.0 * i / count);
      description += azimuth.data();
    }
    if (name == "Irradiance")
    {
      description += i == 0 ? " red" : i == 1 ? " green" : " blue";
    }
    ++band;
    writer->SetBandDescription(band, description.c_str());
    writer->SetBandUnit(band, UnitOf(name).c_str());
  }
}

// Adds an alpha channel to linear light, as in EXR files: transparent black at missing posts.
vtkSmartPointer<vtkImageData> WithAlpha(vtkImageData* image)
{
  vtkDataArray* radiance = image->GetPointData()->GetArray("Radiance");
  vtkNew<vtkFloatArray> light;
  light->SetName("Light");
  light->SetNumberOfComponents(4);
  light->SetNumberOfTuples(radiance->GetNumberOfTuples());
  for (vtkIdType post = 0; post < radiance->GetNumberOfTuples(); ++post)
  {
    std::array<double, 3> c;
    radiance->GetTuple(post, c.data());
    const bool missing = std::isnan(c[0]);
    const std::array<float, 4> rgba{ { missing ? 0.0f : static_cast<float>(c[0]),
      missing ? 0.0f : static_cast<float>(c[1]), missing ? 0.0f : static_cast<float>(c[2]),
      missing ? 0.0f : 1.0f } };
    light->SetTypedTuple(post, rgba.data());
  }
  vtkNew<vtkImageData> copy;
  copy->CopyStructure(image);
  copy->GetPointData()->SetScalars(light);
  return copy;
}

// Distance from the middle, in posts, within which a height is searched first.
constexpr int FirstReach = 8;
constexpr int MostReach = 512;

// The extension of the file with its point, in lower case.
std::string ExtensionOf(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

// The one or two middle posts of `count`, and `reach` posts on both sides; at least two posts.
void Middle(int count, int reach, int& first, int& last)
{
  first = (count - 1) / 2;
  last = count / 2;
  const int more = std::max(reach, first == last ? 1 : 0);
  first = std::max(first - more, 0);
  last = std::min(last + more, count - 1);
}

// The smaller of the two spacings in metres.
double LeastStep(vtkImageData* terrain)
{
  return std::min(terrain->GetSpacing()[0], terrain->GetSpacing()[1]);
}

// Finds the height of the post nearest to the middle that has a height. Returns its distance in
// metres. If there is none within MostReach columns and rows, the height is 0 and the distance
// infinite.
double NearestHeight(vtkImageData* terrain, double& height)
{
  const int* size = terrain->GetDimensions();
  const double* spacing = terrain->GetSpacing();
  vtkDataArray* heights = terrain->GetPointData()->GetScalars();
  const int column = size[0] / 2, row = size[1] / 2;
  double least = std::numeric_limits<double>::infinity();
  height = 0.0;
  const auto look = [&](int i, int j)
  {
    if (i < 0 || j < 0 || i >= size[0] || j >= size[1])
    {
      return;
    }
    const double found = heights->GetComponent(static_cast<vtkIdType>(j) * size[0] + i, 0);
    const double away = std::hypot((i - column) * spacing[0], (j - row) * spacing[1]);
    if (std::isfinite(found) && away < least)
    {
      least = away;
      height = found;
    }
  };
  // Searches square after square, until no post of a larger square can be nearer.
  const double step = LeastStep(terrain);
  for (int ring = 0; ring <= MostReach && ring * step < least; ++ring)
  {
    for (int k = -ring; k <= ring; ++k)
    {
      look(column + k, row - ring);
      look(column + k, row + ring);
      look(column - ring, row + k);
      look(column + ring, row + k);
    }
  }
  return least;
}

vtkSmartPointer<vtkHeightFieldReader> MakeReader(const skyline::TerrainOptions& options)
{
  auto reader = vtkSmartPointer<vtkHeightFieldReader>::New();
  reader->SetFileName(options.File.c_str());
  reader->SetBand(options.Band);
  for (const double value : options.Nodata)
  {
    reader->AddNodata(value);
  }
  options.Sources.Apply(reader.Get());
  return reader;
}

} // namespace

namespace skyline
{

vtkSmartPointer<vtkImageData> ReadTerrain(
  const TerrainOptions& options, const CommonOptions& common, const std::string& output)
{
  const auto reader = MakeReader(options);
  RunPass(reader, "read", common);
  if (!output.empty())
  {
    RefuseOverlap(output, LoadSourceFiles(reader->GetOutput()));
  }
  return reader->GetOutput();
}

Center CenterOf(vtkImageData* terrain, const CommonOptions& common)
{
  Center center;
  center.Place = LoadGeoreference(terrain);
  const int* size = terrain->GetDimensions();
  if (std::isinf(NearestHeight(terrain, center.Height)))
  {
    PrintWarning(Doubt{ "no post within " + std::to_string(MostReach) +
                     " posts of the DEM's centre has a height",
                   "a height of 0 m there", "" },
      common);
  }
  if (center.Place.OnBody())
  {
    center.Place.LonLatAt(
      0.5 * (size[0] - 1), 0.5 * (size[1] - 1), center.Longitude, center.Latitude);
    center.Longitude = std::remainder(center.Longitude, 360.0);
  }
  return center;
}

Center ReadCenter(const TerrainOptions& options, const CommonOptions& common)
{
  const auto reader = MakeReader(options);
  int whole[6] = { 0, 0, 0, 0, 0, 0 };
  // The reader does not fail if all heights of the part are missing, so the part can grow.
  for (int reach = 0; reach <= MostReach; reach = reach == 0 ? FirstReach : 8 * reach)
  {
    RunPass(reader, "read", common,
      [&]
      {
        reader->UpdateInformation();
        reader->GetOutputInformation(0)->Get(
          vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
        int extent[6] = { 0, 0, 0, 0, 0, 0 };
        Middle(whole[1] + 1, reach, extent[0], extent[1]);
        Middle(whole[3] + 1, reach, extent[2], extent[3]);
        reader->UpdateExtent(extent);
      });
    double height = 0.0;
    if (NearestHeight(reader->GetOutput(), height) <= reach * LeastStep(reader->GetOutput()))
    {
      break; // posts outside this part are not nearer
    }
  }
  return CenterOf(reader->GetOutput(), common);
}

void CheckOutput(const std::string& output, const std::vector<std::string>& inputs)
{
  RefuseOverlap(output, inputs);
  const AtomicFile probe(output); // throws if the file cannot be written
}

void CheckRasterOutput(const std::string& output, const std::vector<std::string>& inputs)
{
  CheckOutput(output, inputs);
  const std::string extension = ExtensionOf(output);
  if (!extension.empty() && extension != ".tif" && extension != ".tiff")
  {
    throw WrongUsage("--output: cannot write '" + output +
      "': a raster is written as GeoTIFF; end its name in .tif");
  }
}

void WriteRaster(vtkAlgorithm* source, const std::vector<std::string>& arrays,
  const OutputOptions& options, const CommonOptions& common)
{
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetFileName(options.File.c_str());
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetCloudOptimized(options.CloudOptimized);
  int band = 0;
  for (const std::string& name : arrays)
  {
    writer->AddArray(name.c_str());
    SetBandTexts(writer, ImageOf(source), name, band);
  }
  RunPass(writer, "write", common);
}

PictureFormat FormatOf(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  if (extension == ".png")
  {
    return PictureFormat::Png;
  }
  if (extension == ".exr")
  {
    return PictureFormat::Exr;
  }
  if (extension == ".tif" || extension == ".tiff")
  {
    return PictureFormat::Tiff;
  }
  throw WrongUsage(
    "--output: cannot write '" + file + "': a picture's name ends in .png, .exr or .tif");
}

void WritePicture(vtkAlgorithm* source, PictureFormat format, const OutputOptions& options,
  const CommonOptions& common)
{
  if (format == PictureFormat::Tiff)
  {
    vtkNew<vtkHeightFieldWriter> writer;
    writer->SetFileName(options.File.c_str());
    writer->SetInputConnection(source->GetOutputPort());
    writer->SetCloudOptimized(options.CloudOptimized);
    writer->AddArray("Picture");
    int band = 0;
    for (const char* color : { "Red", "Green", "Blue", "Alpha" })
    {
      writer->SetBandDescription(++band, color);
    }
    RunPass(writer, "write", common);
    return;
  }
  vtkNew<vtkHeightFieldPictureWriter> writer;
  writer->SetFileName(options.File.c_str());
  if (format == PictureFormat::Exr)
  {
    writer->SetInputData(WithAlpha(ImageOf(source)));
  }
  else
  {
    writer->SetInputConnection(source->GetOutputPort());
    writer->SetArrayName("Picture");
  }
  RunPass(writer, "write", common);
}

} // namespace skyline
