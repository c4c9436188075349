// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineSoftShadowGeometry.h"

#include "LightFieldData.h"
#include "vtkHeightFieldSurface.h"
#include "vtkSkylineSoftShadowShader.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkSkylineSoftShadowGeometry);

namespace
{

constexpr int MostComponents = 4; // of arrays that are copied to the surface: numbers, colours

// Copies the point arrays of the posts under the points of the surface.
void PassPoints(vtkImageData* image, vtkPolyData* surface)
{
  const std::array<int, 6> extent = [&]
  {
    std::array<int, 6> numbers{};
    image->GetExtent(numbers.data());
    return numbers;
  }();
  const vtkIdType columns = image->GetDimensions()[0];
  vtkNew<vtkIdTypeArray> posts;
  posts->SetName("vtkOriginalPointIds");
  posts->SetNumberOfTuples(surface->GetNumberOfPoints());
  for (vtkIdType id = 0; id < surface->GetNumberOfPoints(); ++id)
  {
    std::array<double, 3> point{};
    surface->GetPoint(id, point.data());
    std::array<vtkIdType, 2> place{};
    for (std::size_t k = 0; k < 2; ++k)
    {
      const int axis = static_cast<int>(k);
      place[k] = std::lround((point[k] - image->GetOrigin()[axis]) / image->GetSpacing()[axis]) -
        extent[2 * k];
    }
    posts->SetValue(id, place[1] * columns + place[0]);
  }
  vtkPointData* from = image->GetPointData();
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = from->GetAbstractArray(i);
    if (array && array->GetName() && array->GetNumberOfComponents() <= MostComponents)
    {
      const auto passed = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
      passed->SetName(array->GetName());
      passed->SetNumberOfComponents(array->GetNumberOfComponents());
      passed->SetNumberOfTuples(posts->GetNumberOfTuples());
      for (vtkIdType id = 0; id < posts->GetNumberOfTuples(); ++id)
      {
        passed->SetTuple(id, posts->GetValue(id), array);
      }
      surface->GetPointData()->AddArray(passed);
    }
  }
  surface->GetPointData()->AddArray(posts);
}

} // namespace

void vtkSkylineSoftShadowGeometry::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ElevationArray: " << this->ElevationArray << "\n"
     << indent << "Exaggeration: " << this->Exaggeration << "\n"
     << indent << "Stride: " << this->Stride << "\n"
     << indent << "Mode: " << this->Mode << "\n";
}

int vtkSkylineSoftShadowGeometry::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkSkylineSoftShadowGeometry::RequestData(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  vtkImageData* image = vtkImageData::GetData(in[0]);
  vtkPolyData* output = vtkPolyData::GetData(out);
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  if (!image || image->GetNumberOfPoints() == 0 ||
    (processes && processes->GetLocalProcessId() != 0))
  {
    return 1;
  }
  std::string name = this->ElevationArray;
  if (name.empty() || !image->GetPointData()->GetArray(name.c_str()))
  {
    vtkDataArray* heights = image->GetPointData()->GetArray("Elevation");
    heights = heights ? heights : image->GetPointData()->GetScalars();
    name = heights && heights->GetName() ? heights->GetName() : "";
  }
  vtkNew<vtkImageData> copy; // a separate input: requests do not reach the upstream pipeline
  copy->ShallowCopy(image);
  vtkNew<vtkHeightFieldSurface> surface;
  surface->SetInputDataObject(copy);
  surface->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name.c_str());
  surface->SetExaggeration(this->Exaggeration);
  surface->SetStride(this->Stride);
  surface->Update();
  output->ShallowCopy(surface->GetOutput());
  PassPoints(image, output);
  int mode = this->Mode;
  if (mode == AUTOMATIC)
  {
    vtkPointData* there = image->GetPointData();
    mode = there->HasArray("Irradiance") ? vtkSkylineSoftShadowShader::IRRADIANCE
      : there->HasArray("TransferSH")    ? vtkSkylineSoftShadowShader::TRANSFER
      : there->HasArray("VisibilitySH")  ? vtkSkylineSoftShadowShader::VISIBILITY
                                         : vtkSkylineSoftShadowShader::IRRADIANCE;
  }
  std::vector<std::string> arrays;
  switch (mode)
  {
    case vtkSkylineSoftShadowShader::TRANSFER:
      arrays = { "TransferSH" };
      break;
    case vtkSkylineSoftShadowShader::VISIBILITY:
      arrays = { "VisibilitySH", name };
      break;
    default:
      arrays = { "Irradiance" };
  }
  skyline::StoreLight(image, arrays, output);
  return 1;
}
