// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineLightMapReader.h"

#include "Data/LightMapImage.h"
#include "Data/Warnings.h"
#include "ImageLibrary.h"
#include "ReadGuard.h"

#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <string>

vtkStandardNewMacro(vtkSkylineLightMapReader);

vtkSkylineLightMapReader::vtkSkylineLightMapReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkSkylineLightMapReader::~vtkSkylineLightMapReader()
{
  this->SetFileName(nullptr);
}

namespace
{

/// Raises a warning about pixels that were corrected, if there are any.
void DoubtPixels(
  vtkObject* reader, const std::string& file, const skyline::LightMapDefects& defects)
{
  std::string found, used;
  const auto add = [](std::string& text, const std::string& part)
  { text += (text.empty() ? "" : ", ") + part; };
  if (defects.Negative > 0)
  {
    add(found, std::to_string(defects.Negative) + " negative");
  }
  if (defects.NotNumbers > 0)
  {
    add(found, std::to_string(defects.NotNumbers) + " not a number");
  }
  if (!found.empty())
  {
    used = "0 for them";
  }
  if (defects.Infinite > 0)
  {
    add(found, std::to_string(defects.Infinite) + " infinite");
    add(used, "the greatest finite value of their channel for the infinite ones");
  }
  if (!found.empty())
  {
    skyline::Warn(reader, { "'" + file + "' has invalid pixels: " + found, used, "" });
  }
}

} // namespace

template <typename Work>
bool vtkSkylineLightMapReader::Try(const Work& work)
{
  this->SetErrorCode(skyline::GuardRead(this, this->FileName, "give a smaller map",
    [&](const std::string& file)
    {
      const auto source = skyline::ImageLibrary::Get().OpenLightMap(file);
      work(*source);
    }));
  return this->GetErrorCode() == vtkErrorCode::NoError;
}

int vtkSkylineLightMapReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return this->Try(
    [&](const skyline::LightMapFile& source)
    {
      const int extent[6] = { 0, source.GetColumns() - 1, 0, source.GetRows() - 1, 0, 0 };
      const double spacing[3] = { 360.0 / source.GetColumns(), 180.0 / source.GetRows(), 1.0 };
      const double origin[3] = { -180.0 + 0.5 * spacing[0], -90.0 + 0.5 * spacing[1], 0.0 };
      vtkInformation* info = outputVector->GetInformationObject(0);
      info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
      info->Set(vtkDataObject::SPACING(), spacing, 3);
      info->Set(vtkDataObject::ORIGIN(), origin, 3);
      vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 3);
    });
}

int vtkSkylineLightMapReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkImageData* image = vtkImageData::GetData(outputVector);
  this->NumberOfNegativePixels = this->NumberOfNaNPixels = this->NumberOfInfinitePixels = 0;
  const bool done = this->Try(
    [&](skyline::LightMapFile& source)
    {
      const int columns = source.GetColumns(), rows = source.GetRows();
      image->SetExtent(0, columns - 1, 0, rows - 1, 0, 0);
      image->SetSpacing(360.0 / columns, 180.0 / rows, 1.0);
      image->SetOrigin(-180.0 + 180.0 / columns, -90.0 + 90.0 / rows, 0.0);
      vtkNew<vtkFloatArray> radiance;
      radiance->SetName(skyline::RadianceArrayName);
      radiance->SetNumberOfComponents(3);
      radiance->SetNumberOfTuples(static_cast<vtkIdType>(columns) * rows);
      const skyline::LightMapDefects defects = source.Read(radiance->GetPointer(0),
        [this](double part)
        {
          this->UpdateProgress(part);
          return !this->GetAbortExecute();
        });
      this->NumberOfNegativePixels = defects.Negative;
      this->NumberOfNaNPixels = defects.NotNumbers;
      this->NumberOfInfinitePixels = defects.Infinite;
      image->GetPointData()->SetScalars(radiance);
      DoubtPixels(this, this->FileName, defects);
    });
  if (!done)
  {
    image->Initialize();
  }
  return done;
}

void vtkSkylineLightMapReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "NumberOfNegativePixels: " << this->NumberOfNegativePixels << "\n";
  os << indent << "NumberOfNaNPixels: " << this->NumberOfNaNPixels << "\n";
  os << indent << "NumberOfInfinitePixels: " << this->NumberOfInfinitePixels << "\n";
}
