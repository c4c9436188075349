// SPDX-License-Identifier: BSD-3-Clause
#include "Files.h"

#include "AtomicFile.h"
#include "Failure.h"
#include "SourceFiles.h"
#include "vtkSkylineGeoreference.h"

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

// Linear light with alpha, as EXR files have it: nothing where posts are missing.
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

// The middle post or two of `count`, and a neighbour more where one would be alone.
void Middle(int count, int& first, int& last)
{
  first = (count - 1) / 2;
  last = count / 2;
  if (first == last && count > 2)
  {
    --first;
    ++last;
  }
}

} // namespace

namespace skyline
{

vtkSmartPointer<vtkImageData> ReadTerrain(
  const TerrainOptions& options, const Talk& talk, const std::string& output)
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(options.File.c_str());
  reader->SetBand(options.Band);
  RunPass(reader, "read", talk);
  if (!output.empty())
  {
    RefuseOverlap(output, LoadSourceFiles(reader->GetOutput()));
  }
  return reader->GetOutput();
}

Center CenterOf(vtkImageData* terrain)
{
  Center center;
  center.Place = LoadGeoreference(terrain);
  const int* size = terrain->GetDimensions();
  const vtkIdType post = static_cast<vtkIdType>(size[1] / 2) * size[0] + size[0] / 2;
  const double height = terrain->GetPointData()->GetScalars()->GetComponent(post, 0);
  center.Height = std::isfinite(height) ? height : 0.0;
  if (center.Place.OnBody())
  {
    center.Place.LonLatAt(
      0.5 * (size[0] - 1), 0.5 * (size[1] - 1), center.Longitude, center.Latitude);
    center.Longitude = std::remainder(center.Longitude, 360.0);
  }
  return center;
}

Center ReadCenter(const TerrainOptions& options, const Talk& talk)
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(options.File.c_str());
  reader->SetBand(options.Band);
  RunPass(reader, "read", talk,
    [&]
    {
      reader->UpdateInformation();
      int whole[6];
      reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
      int extent[6] = { 0, 0, 0, 0, 0, 0 };
      Middle(whole[1] + 1, extent[0], extent[1]);
      Middle(whole[3] + 1, extent[2], extent[3]);
      reader->UpdateExtent(extent);
    });
  return CenterOf(reader->GetOutput());
}

void CheckOutput(const std::string& output, const std::vector<std::string>& inputs)
{
  RefuseOverlap(output, inputs);
  const AtomicFile probe(output); // throws where nothing can be written
}

void WriteRaster(vtkAlgorithm* source, const std::vector<std::string>& arrays,
  const OutputOptions& options, const Talk& talk)
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
  RunPass(writer, "write", talk);
}

PictureFormat FormatOf(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
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
  throw Failure("cannot write '" + file + "': a picture's name ends in .png, .exr or .tif");
}

void WritePicture(
  vtkAlgorithm* source, PictureFormat format, const OutputOptions& options, const Talk& talk)
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
    RunPass(writer, "write", talk);
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
  RunPass(writer, "write", talk);
}

} // namespace skyline
