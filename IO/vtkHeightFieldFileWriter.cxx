// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldFileWriter.h"

#include "AtomicFile.h"
#include "IoFailure.h"
#include "SourceFiles.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cctype>
#include <new>

vtkHeightFieldFileWriter::vtkHeightFieldFileWriter() = default;

vtkHeightFieldFileWriter::~vtkHeightFieldFileWriter()
{
  this->SetFileName(nullptr);
}

int vtkHeightFieldFileWriter::Write()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->Written = false;
  if (this->GetNumberOfInputConnections(0) < 1)
  {
    vtkErrorMacro(<< "no input to write; call SetInputConnection or SetInputData first");
    this->SetErrorCode(vtkErrorCode::UnknownError);
    return 0;
  }
  this->Modified(); // the file is written again even if the data did not change
  // vtkWriter::Write is not used: it executes a failed input a second time, and then returns 1.
  auto* pipeline = vtkStreamingDemandDrivenPipeline::SafeDownCast(this->GetExecutive());
  if (pipeline->UpdateInformation())
  {
    pipeline->Update();
  }
  if (!this->Written && this->GetErrorCode() == vtkErrorCode::NoError)
  {
    this->SetErrorCode(vtkErrorCode::UnknownError); // the input failed and reported why
  }
  return this->Written ? 1 : 0;
}

int vtkHeightFieldFileWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

vtkTypeBool vtkHeightFieldFileWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    vtkInformation* info = inputVector[0]->GetInformationObject(0);
    int whole[6];
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

void vtkHeightFieldFileWriter::WriteData()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->Written = false;
  try
  {
    if (!this->FileName || !*this->FileName)
    {
      throw skyline::IoFailure(
        vtkErrorCode::NoFileNameError, "no file to write to; call SetFileName first");
    }
    auto* image = vtkImageData::SafeDownCast(this->GetInput());
    this->Check(image);
    skyline::RefuseOverlap(this->FileName, skyline::LoadSourceFiles(image));
    skyline::AtomicFile file(this->FileName);
    this->WriteImage(image, file);
    file.Commit();
    this->Written = true;
    this->UpdateProgress(1.0);
  }
  catch (const skyline::IoAborted&)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
  }
  catch (const skyline::IoFailure& failure)
  {
    vtkErrorMacro(<< failure.what());
    this->SetErrorCode(failure.GetCode());
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro(<< "cannot write '" << this->FileName << "': not enough memory");
    this->SetErrorCode(vtkErrorCode::UnknownError);
  }
  catch (const std::exception& failure)
  {
    vtkErrorMacro(<< "cannot write '" << this->FileName
                  << "': " << skyline::FirstLine(failure.what()));
    this->SetErrorCode(vtkErrorCode::UnknownError);
  }
}

void vtkHeightFieldFileWriter::Check(vtkImageData* image) const
{
  if (!image || image->GetNumberOfPoints() < 1)
  {
    this->Refuse("the input has no posts; connect a height field");
  }
  const int* dimensions = image->GetDimensions();
  if (dimensions[2] != 1)
  {
    this->Refuse("the input has " + std::to_string(dimensions[2]) +
      " layers; give an image with one (z extent 0 0)");
  }
}

vtkDataArray* vtkHeightFieldFileWriter::FindArray(
  vtkImageData* image, const std::string& name) const
{
  vtkPointData* points = image->GetPointData();
  vtkDataArray* array = name.empty() ? points->GetScalars() : points->GetArray(name.c_str());
  if (!array && name.empty() && points->GetNumberOfArrays() == 1)
  {
    array = points->GetArray(0);
  }
  if (array)
  {
    return array;
  }
  std::string names;
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    const char* other = points->GetArrayName(i);
    names += (names.empty() ? "" : ", ") + std::string(other ? other : "(unnamed)");
  }
  this->Refuse("the input has no " +
    (name.empty() ? std::string("active scalars") : "point array '" + name + "'") +
    "; choose from: " + (names.empty() ? "(none)" : names));
}

void vtkHeightFieldFileWriter::Report(double part)
{
  this->UpdateProgress(part);
  if (this->GetAbortExecute())
  {
    throw skyline::IoAborted();
  }
}

void vtkHeightFieldFileWriter::Refuse(const std::string& reason) const
{
  throw skyline::IoFailure(vtkErrorCode::FileFormatError,
    "cannot write '" + std::string(this->FileName ? this->FileName : "") + "': " + reason);
}

std::string vtkHeightFieldFileWriter::GetExtension() const
{
  const std::string name = this->FileName ? this->FileName : "";
  const std::size_t dot = name.find_last_of("./");
  if (dot == std::string::npos || name[dot] != '.')
  {
    return "";
  }
  std::string extension = name.substr(dot + 1);
  for (char& c : extension)
  {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return extension;
}

void vtkHeightFieldFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
