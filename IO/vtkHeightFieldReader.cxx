// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldReader.h"

#include "RasterSource.h"
#include "ReadGuard.h"
#include "SourceFiles.h"
#include "vtkSkylineGeoreference.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkHeightFieldReader);

vtkHeightFieldReader::vtkHeightFieldReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkHeightFieldReader::~vtkHeightFieldReader()
{
  this->SetFileName(nullptr);
}

template <typename Work>
bool vtkHeightFieldReader::Try(const Work& work)
{
  this->SetErrorCode(skyline::GuardRead(this, this->FileName, "read a smaller extent", work));
  return this->GetErrorCode() == vtkErrorCode::NoError;
}

int vtkHeightFieldReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return this->Try(
    [&](const std::string& file)
    {
      const skyline::RasterSource source(file, this->Band);
      const skyline::PostWindow whole = source.GetWhole();
      const int extent[6] = { 0, whole.Columns - 1, 0, whole.Rows - 1, 0, 0 };
      const double spacing[3] = { source.GetSpacing()[0], source.GetSpacing()[1], 1.0 };
      const double origin[3] = { source.GetOrigin()[0], source.GetOrigin()[1], 0.0 };

      vtkInformation* info = outputVector->GetInformationObject(0);
      info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
      info->Set(vtkDataObject::SPACING(), spacing, 3);
      info->Set(vtkDataObject::ORIGIN(), origin, 3);
      info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
      vtkDataObject::SetPointDataActiveScalarInfo(info, source.GetVtkType(), 1);
    });
}

int vtkHeightFieldReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  const bool done = this->Try(
    [&](const std::string& file)
    {
      skyline::RasterSource source(file, this->Band);
      const skyline::PostWindow whole = source.GetWhole();
      int extent[6];
      info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
      extent[1] = std::min(extent[1], whole.Columns - 1); // the file may have shrunk meanwhile
      extent[3] = std::min(extent[3], whole.Rows - 1);
      const skyline::PostWindow window{ extent[0], extent[2], extent[1] - extent[0] + 1,
        extent[3] - extent[2] + 1 };
      if (window.Columns < 1 || window.Rows < 1)
      {
        return; // nothing asked for
      }

      image->SetExtent(extent);
      image->SetSpacing(source.GetSpacing()[0], source.GetSpacing()[1], 1.0);
      image->SetOrigin(source.GetOrigin()[0], source.GetOrigin()[1], 0.0);
      const auto heights =
        vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(source.GetVtkType()));
      heights->SetName("Elevation");
      heights->SetNumberOfTuples(static_cast<vtkIdType>(window.Columns) * window.Rows);
      source.Read(window, heights->GetVoidPointer(0),
        [this](double part)
        {
          this->UpdateProgress(part);
          return !this->GetAbortExecute();
        });

      image->GetPointData()->SetScalars(heights);
      skyline::StoreGeoreference(source.GetGeoreference(window), image);
      skyline::StoreSourceFiles(source.GetFiles(), image);
      if (source.HasNodata())
      {
        skyline::StoreNodataValue(source.GetNodata(), image);
      }
    });
  if (!done)
  {
    image->Initialize();
  }
  return done;
}

void vtkHeightFieldReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Band: " << this->Band << "\n";
}
