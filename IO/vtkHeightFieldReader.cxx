// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldReader.h"

#include "Data/ImageGeoreference.h"
#include "Data/MemoryDemand.h"
#include "Data/Warnings.h"
#include "IoFailure.h"
#include "RasterSource.h"
#include "ReadGuard.h"
#include "SourceFiles.h"
#include "SourcePolicy.h"
#include "StreamSpool.h"

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
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{

/// Allocates the array for a window of heights. Throws IoFailure with the number of bytes and the
/// remedy if there is not enough memory.
vtkSmartPointer<vtkDataArray> Allocate(
  const std::string& file, const skyline::PostWindow& window, int type)
{
  try
  {
    auto heights = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    skyline::DemandMemory("the heights", window.Columns, window.Rows, heights->GetDataTypeSize());
    const vtkIdType posts = static_cast<vtkIdType>(window.Columns) * window.Rows;
    heights->SetName("Elevation");
    heights->SetNumberOfTuples(posts);
    if (heights->GetNumberOfTuples() != posts || !heights->GetVoidPointer(0))
    {
      // The allocation failed although the system reported enough free memory.
      skyline::DemandMemory(
        "the heights", window.Columns, window.Rows, heights->GetDataTypeSize(), 0);
    }
    return heights;
  }
  catch (const std::runtime_error& reason)
  {
    throw skyline::IoFailure(
      vtkErrorCode::UnknownError, "cannot read '" + file + "': " + reason.what());
  }
}

} // namespace

vtkStandardNewMacro(vtkHeightFieldReader);

struct vtkHeightFieldReader::Internal
{
  std::vector<std::string> Drivers;
  std::shared_ptr<skyline::StreamSpool> Spool;
  std::string SpooledFile;
};

vtkHeightFieldReader::vtkHeightFieldReader()
  : Parts(std::make_unique<Internal>())
{
  this->SetNumberOfInputPorts(0);
}

vtkHeightFieldReader::~vtkHeightFieldReader()
{
  this->SetFileName(nullptr);
}

void vtkHeightFieldReader::AddDriver(const char* name)
{
  if (name && *name)
  {
    this->Parts->Drivers.emplace_back(name);
    this->Modified();
  }
}

void vtkHeightFieldReader::AddNodata(double value)
{
  this->Nodata.push_back(value);
  this->Modified();
}

void vtkHeightFieldReader::RemoveAllNodata()
{
  if (!this->Nodata.empty())
  {
    this->Nodata.clear();
    this->Modified();
  }
}

void vtkHeightFieldReader::RemoveAllDrivers()
{
  if (!this->Parts->Drivers.empty())
  {
    this->Parts->Drivers.clear();
    this->Modified();
  }
}

int vtkHeightFieldReader::GetNumberOfDrivers()
{
  return static_cast<int>(this->Parts->Drivers.size());
}

const char* vtkHeightFieldReader::GetDriver(int index)
{
  return index >= 0 && index < this->GetNumberOfDrivers()
    ? this->Parts->Drivers[static_cast<std::size_t>(index)].c_str()
    : nullptr;
}

skyline::SourcePolicy vtkHeightFieldReader::MakePolicy() const
{
  return { this->AllowNetwork, this->AllowElsewhere, this->Parts->Drivers };
}

std::string vtkHeightFieldReader::Spool(const std::string& file)
{
  Internal& parts = *this->Parts;
  if (parts.SpooledFile != file)
  {
    parts.Spool.reset();
  }
  if (!skyline::StreamSpool::IsStream(file))
  {
    return "";
  }
  if (!parts.Spool)
  {
    parts.Spool = skyline::StreamSpool::Read(file,
      [this]
      {
        this->UpdateProgress(0.0);
        return !this->GetAbortExecute();
      });
    parts.SpooledFile = file;
  }
  return parts.Spool->GetName();
}

int vtkHeightFieldReader::GetNumberOfNodata()
{
  return static_cast<int>(this->Nodata.size());
}

double vtkHeightFieldReader::GetNodata(int index)
{
  return index >= 0 && index < this->GetNumberOfNodata()
    ? this->Nodata[static_cast<std::size_t>(index)]
    : std::numeric_limits<double>::quiet_NaN();
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
      const skyline::RasterSource source(
        file, this->Band, this->Nodata, this->MakePolicy(), this->Spool(file));
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
      skyline::RasterSource source(
        file, this->Band, this->Nodata, this->MakePolicy(), this->Spool(file));
      const skyline::PostWindow whole = source.GetWhole();
      int extent[6];
      info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
      extent[1] = std::min(extent[1], whole.Columns - 1); // the file may have shrunk since
      extent[3] = std::min(extent[3], whole.Rows - 1);
      const skyline::PostWindow window{ extent[0], extent[2], extent[1] - extent[0] + 1,
        extent[3] - extent[2] + 1 };
      if (window.Columns < 1 || window.Rows < 1)
      {
        return; // the requested extent is empty
      }

      image->SetExtent(extent);
      image->SetSpacing(source.GetSpacing()[0], source.GetSpacing()[1], 1.0);
      image->SetOrigin(source.GetOrigin()[0], source.GetOrigin()[1], 0.0);
      const vtkSmartPointer<vtkDataArray> heights = Allocate(file, window, source.GetVtkType());
      source.Read(window, heights->GetVoidPointer(0),
        [this](double part)
        {
          this->UpdateProgress(part);
          return !this->GetAbortExecute();
        });

      for (const skyline::Doubt& doubt : source.GetDoubts())
      {
        skyline::Warn(this, doubt);
      }
      image->GetPointData()->SetScalars(heights);
      skyline::StoreGeoreference(source.GetGeoreference(window), image);
      skyline::StoreSourceFiles(source.GetFiles(), image);
      if (source.HasNodata())
      {
        skyline::StoreNodataValue(source.GetNodata(), image);
      }
      else if (const auto finite = std::find_if(this->Nodata.begin(), this->Nodata.end(),
                 [](double value) { return std::isfinite(value); });
               finite != this->Nodata.end())
      {
        skyline::StoreNodataValue(*finite, image);
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
  os << indent << "AllowNetwork: " << (this->AllowNetwork ? "On" : "Off") << "\n";
  os << indent << "AllowElsewhere: " << (this->AllowElsewhere ? "On" : "Off") << "\n";
  os << indent << "Drivers:";
  for (const std::string& name : this->Parts->Drivers)
  {
    os << " " << name;
  }
  os << "\n";
  os << indent << "Nodata:";
  for (const double value : this->Nodata)
  {
    os << " " << value;
  }
  os << "\n";
}
