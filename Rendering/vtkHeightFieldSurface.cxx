// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldSurface.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkHeightFieldSurface);

namespace
{

// 0, stride, 2 stride, ..., and the last one.
std::vector<vtkIdType> Steps(vtkIdType count, vtkIdType stride)
{
  std::vector<vtkIdType> steps;
  for (vtkIdType i = 0; i < count - 1; i += stride)
  {
    steps.push_back(i);
  }
  steps.push_back(count - 1);
  return steps;
}

// Points are made when the first cell asks for them.
class Mesh
{
public:
  Mesh(vtkImageData* image, vtkDataArray* heights, double exaggeration)
    : Image(image)
    , Heights(heights)
    , Exaggeration(exaggeration)
    , Place(static_cast<std::size_t>(image->GetNumberOfPoints()), -1)
  {
    this->Points->SetDataTypeToDouble();
    this->Elevation->SetName("Elevation");
  }

  bool Has(vtkIdType post) const { return std::isfinite(this->Heights->GetComponent(post, 0)); }

  vtkIdType PointOf(vtkIdType post)
  {
    vtkIdType& place = this->Place[static_cast<std::size_t>(post)];
    if (place < 0)
    {
      std::array<double, 3> position;
      this->Image->GetPoint(post, position.data());
      const double height = this->Heights->GetComponent(post, 0);
      place = this->Points->InsertNextPoint(position[0], position[1], this->Exaggeration * height);
      this->Elevation->InsertNextValue(static_cast<float>(height));
    }
    return place;
  }

  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const std::array<vtkIdType, 3> corners{ { this->PointOf(a), this->PointOf(b),
      this->PointOf(c) } };
    this->Triangles->InsertNextCell(3, corners.data());
  }

  void Fill(vtkPolyData* mesh)
  {
    mesh->SetPoints(this->Points);
    mesh->SetPolys(this->Triangles);
    mesh->GetPointData()->SetScalars(this->Elevation);
  }

private:
  vtkImageData* Image;
  vtkDataArray* Heights;
  double Exaggeration;
  std::vector<vtkIdType> Place;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Elevation;
  vtkNew<vtkCellArray> Triangles;
};

} // namespace

vtkHeightFieldSurface::vtkHeightFieldSurface()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkHeightFieldSurface::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkHeightFieldSurface::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkImageData* image = vtkImageData::GetData(input[0]);
  vtkDataArray* heights = this->GetInputArrayToProcess(0, input);
  const int* size = image->GetDimensions();
  if (size[2] != 1 || size[0] < 2 || size[1] < 2)
  {
    vtkErrorMacro("no surface: " << size[0] << " x " << size[1] << " x " << size[2]
                                 << " posts; a height field has at least 2 x 2 x 1");
    return 0;
  }
  if (!heights || heights->GetNumberOfComponents() != 1 ||
    heights->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    vtkErrorMacro("no heights: the image has no array of one number a post");
    return 0;
  }
  const vtkIdType width = size[0];
  const std::vector<vtkIdType> columns = Steps(width, this->Stride);
  const std::vector<vtkIdType> rows = Steps(size[1], this->Stride);
  Mesh mesh(image, heights, this->Exaggeration);
  for (std::size_t j = 0; j + 1 < rows.size() && !this->GetAbortExecute(); ++j)
  {
    for (std::size_t i = 0; i + 1 < columns.size(); ++i)
    {
      const vtkIdType southWest = rows[j] * width + columns[i];
      const vtkIdType southEast = rows[j] * width + columns[i + 1];
      const vtkIdType northWest = rows[j + 1] * width + columns[i];
      const vtkIdType northEast = rows[j + 1] * width + columns[i + 1];
      if (mesh.Has(southWest) && mesh.Has(southEast) && mesh.Has(northWest) && mesh.Has(northEast))
      {
        mesh.AddTriangle(southWest, southEast, northEast);
        mesh.AddTriangle(southWest, northEast, northWest);
      }
    }
    this->UpdateProgress(static_cast<double>(j + 1) / static_cast<double>(rows.size()));
  }
  mesh.Fill(vtkPolyData::GetData(output));
  return 1;
}

void vtkHeightFieldSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Stride: " << this->Stride << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
}
