// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldCap.h"

#include "HeightArray.h"
#include "ShadowHeight/ShadowHeightCap.h"
#include "WholeField.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeightFieldCap);

namespace
{

// Raises the heights of the posts of the image to all polygons.
void Cap(vtkPolyData* objects, vtkImageData* image, std::vector<double>& heights)
{
  const int* extent = image->GetExtent();
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  const int columns = extent[1] - extent[0] + 1;
  const int rows = extent[3] - extent[2] + 1;
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType id = 0; id < objects->GetNumberOfCells(); ++id)
  {
    objects->GetCell(id, cell);
    if (cell->GetCellDimension() != 2)
    {
      continue;
    }
    cell->Triangulate(0, ids, points);
    for (vtkIdType corner = 0; corner + 2 < points->GetNumberOfPoints(); corner += 3)
    {
      std::array<skyline::CapCorner, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        points->GetPoint(corner + static_cast<vtkIdType>(k), triangle[k].data());
        for (std::size_t axis = 0; axis < 2; ++axis)
        {
          triangle[k][axis] = (triangle[k][axis] - origin[axis]) / spacing[axis] - extent[2 * axis];
        }
      }
      skyline::CapTriangle(triangle, columns, rows, heights.data());
    }
  }
}

} // namespace

vtkHeightFieldCap::vtkHeightFieldCap()
{
  this->SetNumberOfInputPorts(2);
}

void vtkHeightFieldCap::SetObjectsConnection(vtkAlgorithmOutput* objects)
{
  this->SetInputConnection(1, objects);
}

void vtkHeightFieldCap::SetObjectsData(vtkPolyData* objects)
{
  this->SetInputDataInternal(1, objects);
}

int vtkHeightFieldCap::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkImageData" : "vtkPolyData");
  return 1;
}

int vtkHeightFieldCap::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector*)
{
  skyline::RequestWhole(in[0]->GetInformationObject(0));
  skyline::RequestWhole(in[1]->GetInformationObject(0));
  return 1;
}

int vtkHeightFieldCap::RequestData(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  vtkImageData* input = vtkImageData::GetData(in[0]);
  vtkImageData* output = vtkImageData::GetData(out);
  vtkDataArray* heights = this->GetInputArrayToProcess(0, in);
  std::vector<double> posts;
  const std::string failure = skyline::ReasonOfFailure(input,
    [&]
    {
      skyline::CheckWhole(in[0]->GetInformationObject(0));
      skyline::CheckSurface(input);
      skyline::CheckHeights(input, heights);
      posts.resize(static_cast<std::size_t>(heights->GetNumberOfTuples()));
      for (vtkIdType post = 0; post < heights->GetNumberOfTuples(); ++post)
      {
        posts[static_cast<std::size_t>(post)] = heights->GetComponent(post, 0);
      }
      Cap(vtkPolyData::GetData(in[1]), input, posts);
    });
  if (!failure.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< failure);
    return 0;
  }

  const int type = heights->GetDataType() == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT;
  const auto raised = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  raised->SetName(heights->GetName());
  raised->SetNumberOfTuples(heights->GetNumberOfTuples());
  for (vtkIdType post = 0; post < heights->GetNumberOfTuples(); ++post)
  {
    raised->SetComponent(post, 0, posts[static_cast<std::size_t>(post)]);
  }
  output->ShallowCopy(input);
  const bool active = heights == input->GetPointData()->GetScalars();
  output->GetPointData()->AddArray(raised);
  if (active)
  {
    output->GetPointData()->SetScalars(raised);
  }
  skyline::KeepPiece(out->GetInformationObject(0));
  return 1;
}

void vtkHeightFieldCap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
