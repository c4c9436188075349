// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldSurface.h"

#include "HeightArray.h"
#include "WholeField.h"

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
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeightFieldSurface);

namespace
{

// 0, stride, 2 stride, ..., and the last index.
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

// The cells between chosen columns and rows. A point is made when the first cell uses it.
class Mesh
{
public:
  Mesh(vtkImageData* image, vtkDataArray* heights, int stride, double exaggeration)
    : Image(image)
    , Heights(heights)
    , Columns(Steps(image->GetDimensions()[0], stride))
    , Rows(Steps(image->GetDimensions()[1], stride))
    , Exaggeration(exaggeration)
    , Place(static_cast<std::size_t>(image->GetNumberOfPoints()), -1)
  {
    this->Points->SetDataTypeToDouble();
    this->Elevation->SetName("Elevation");
  }

  std::ptrdiff_t CellRows() const { return static_cast<std::ptrdiff_t>(this->Rows.size()) - 1; }

  // Adds the triangles of a row of cells.
  void AddSurface(std::ptrdiff_t j)
  {
    for (std::ptrdiff_t i = 0; i < this->CellColumns(); ++i)
    {
      if (this->HasCell(i, j))
      {
        this->AddTriangle(this->Post(i, j), this->Post(i + 1, j), this->Post(i + 1, j + 1));
        this->AddTriangle(this->Post(i, j), this->Post(i + 1, j + 1), this->Post(i, j + 1));
      }
    }
  }

  // Adds the walls under the sides of a row of cells that have no neighbour.
  void AddSkirt(std::ptrdiff_t j, double base)
  {
    for (std::ptrdiff_t i = 0; i < this->CellColumns(); ++i)
    {
      if (!this->HasCell(i, j))
      {
        continue;
      }
      const std::array<vtkIdType, 4> corner{ { this->Post(i, j), this->Post(i + 1, j),
        this->Post(i + 1, j + 1), this->Post(i, j + 1) } };
      const std::array<bool, 4> open{ { !this->HasCell(i, j - 1), !this->HasCell(i + 1, j),
        !this->HasCell(i, j + 1), !this->HasCell(i - 1, j) } };
      for (std::size_t k = 0; k < open.size(); ++k)
      {
        if (open[k])
        {
          this->AddWall(corner[k], corner[(k + 1) % 4], base);
        }
      }
    }
  }

  void Fill(vtkPolyData* mesh)
  {
    mesh->SetPoints(this->Points);
    mesh->SetPolys(this->Cells);
    mesh->GetPointData()->SetScalars(this->Elevation);
  }

private:
  std::ptrdiff_t CellColumns() const
  {
    return static_cast<std::ptrdiff_t>(this->Columns.size()) - 1;
  }

  vtkIdType Post(std::ptrdiff_t i, std::ptrdiff_t j) const
  {
    return this->Rows[static_cast<std::size_t>(j)] * this->Image->GetDimensions()[0] +
      this->Columns[static_cast<std::size_t>(i)];
  }

  bool HasPost(std::ptrdiff_t i, std::ptrdiff_t j) const
  {
    return std::isfinite(this->Heights->GetComponent(this->Post(i, j), 0));
  }

  bool HasCell(std::ptrdiff_t i, std::ptrdiff_t j) const
  {
    return i >= 0 && i < this->CellColumns() && j >= 0 && j < this->CellRows() &&
      this->HasPost(i, j) && this->HasPost(i + 1, j) && this->HasPost(i, j + 1) &&
      this->HasPost(i + 1, j + 1);
  }

  vtkIdType MakePoint(vtkIdType post, double z)
  {
    std::array<double, 3> position;
    this->Image->GetPoint(post, position.data());
    this->Elevation->InsertNextValue(static_cast<float>(this->Heights->GetComponent(post, 0)));
    return this->Points->InsertNextPoint(position[0], position[1], z);
  }

  vtkIdType PointOf(vtkIdType post)
  {
    vtkIdType& place = this->Place[static_cast<std::size_t>(post)];
    if (place < 0)
    {
      place = this->MakePoint(post, this->Exaggeration * this->Heights->GetComponent(post, 0));
    }
    return place;
  }

  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const std::array<vtkIdType, 3> corners{ { this->PointOf(a), this->PointOf(b),
      this->PointOf(c) } };
    this->Cells->InsertNextCell(3, corners.data());
  }

  void AddWall(vtkIdType a, vtkIdType b, double base)
  {
    const std::array<vtkIdType, 4> corners{ { this->PointOf(a), this->MakePoint(a, base),
      this->MakePoint(b, base), this->PointOf(b) } };
    this->Cells->InsertNextCell(4, corners.data());
  }

  vtkImageData* Image;
  vtkDataArray* Heights;
  std::vector<vtkIdType> Columns;
  std::vector<vtkIdType> Rows;
  double Exaggeration;
  std::vector<vtkIdType> Place; // index of the point of each post, -1 before it is made
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Elevation;
  vtkNew<vtkCellArray> Cells;
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

// A piece would have edges of its own.
int vtkHeightFieldSurface::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  skyline::RequestWhole(input[0]->GetInformationObject(0));
  return 1;
}

int vtkHeightFieldSurface::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  if (!skyline::IsFirstPiece(output->GetInformationObject(0)))
  {
    return 1;
  }
  vtkImageData* image = vtkImageData::GetData(input[0]);
  vtkDataArray* heights = this->GetInputArrayToProcess(0, input);
  const std::string failure = skyline::ReasonOfFailure(image,
    [&]
    {
      skyline::CheckSurface(image);
      skyline::CheckHeights(image, heights);
      skyline::CheckWhole(input[0]->GetInformationObject(0));
    });
  if (!failure.empty())
  {
    vtkErrorMacro(<< failure);
    return 0;
  }
  Mesh mesh(image, heights, this->Stride, this->Exaggeration);
  for (std::ptrdiff_t j = 0; j < mesh.CellRows() && !this->GetAbortExecute(); ++j)
  {
    if (this->Skirt)
    {
      mesh.AddSkirt(j, this->SkirtBase);
    }
    else
    {
      mesh.AddSurface(j);
    }
    this->UpdateProgress(static_cast<double>(j + 1) / static_cast<double>(mesh.CellRows()));
  }
  mesh.Fill(vtkPolyData::GetData(output));
  return 1;
}

void vtkHeightFieldSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Stride: " << this->Stride << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
  os << indent << "Skirt: " << this->Skirt << "\n";
  os << indent << "SkirtBase: " << this->SkirtBase << "\n";
}
