// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldShadowReceiver.h"

#include "ShadowHeight/ShadowHeightPenumbra.h"
#include "WholeField.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkHeightFieldShadowReceiver);

namespace
{

// The corners of the triangle of an image around a point, and their weights.
struct Corners
{
  std::array<vtkIdType, 3> Posts{};
  std::array<double, 3> Weights{};

  // A corner with weight 0 is ignored, even if it is missing.
  double Of(vtkFloatArray* array) const
  {
    double sum = 0.0;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      if (this->Weights[corner] > 0.0)
      {
        sum += this->Weights[corner] * array->GetValue(this->Posts[corner]);
      }
    }
    return sum;
  }
};

// Computes the light at points in the coordinates of an image of shadow heights.
class Receiver
{
public:
  Receiver(vtkImageData* image, double penumbraDepth)
    : Penumbra(SunOf(image))
    , PenumbraDepth(penumbraDepth)
    , Hard(Find(image, "ShadowHeight"))
    , Upper(Find(image, "ShadowHeightUpper"))
    , Lower(Find(image, "ShadowHeightLower"))
  {
    const int* extent = image->GetExtent();
    image->GetSpacing(this->Spacing.data());
    image->GetOrigin(this->Origin.data());
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      this->Origin[axis] += extent[2 * axis] * this->Spacing[axis];
      this->Last[axis] = extent[2 * axis + 1] - extent[2 * axis];
    }
    if (extent[4] != extent[5] || this->Last[0] < 1 || this->Last[1] < 1)
    {
      throw std::invalid_argument(
        "the shadow heights are not an image of one slice with at least 2 x 2 posts; give the "
        "output of vtkHeightFieldShadowHeight");
    }
    if (this->Hard == nullptr)
    {
      throw std::invalid_argument(
        "the image has no point array ShadowHeight; give the output of vtkHeightFieldShadowHeight");
    }
  }

  double Lit(const std::array<double, 3>& point) const
  {
    Corners corners;
    double shadow = 0.0;
    if (!this->Locate(point, corners) || std::isnan(shadow = corners.Of(this->Hard)))
    {
      return this->Penumbra.Lit(0.0, 0.0, 1.0);
    }
    if (this->Upper != nullptr && this->Lower != nullptr)
    {
      return this->Penumbra.Lit(corners.Of(this->Upper), corners.Of(this->Lower), point[2]);
    }
    return skyline::LitByPenumbraDepth(shadow, point[2], this->PenumbraDepth);
  }

private:
  static skyline::ShadowHeightPenumbra SunOf(vtkImageData* image)
  {
    vtkDataArray* sun = image->GetFieldData()->GetArray("ShadowSun");
    if (sun == nullptr || sun->GetNumberOfValues() != 3)
    {
      throw std::invalid_argument(
        "the image has no field array ShadowSun; give the output of vtkHeightFieldShadowHeight");
    }
    // The sun is a point unless both limbs have shadow heights.
    const bool soft =
      Find(image, "ShadowHeightUpper") != nullptr && Find(image, "ShadowHeightLower") != nullptr;
    return { sun->GetComponent(0, 1) * skyline::RadiansPerDegree,
      soft ? sun->GetComponent(0, 2) * skyline::RadiansPerDegree : 0.0 };
  }

  static vtkFloatArray* Find(vtkImageData* image, const char* name)
  {
    return vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(name));
  }

  bool Locate(const std::array<double, 3>& point, Corners& corners) const
  {
    const double x = (point[0] - this->Origin[0]) / this->Spacing[0];
    const double y = (point[1] - this->Origin[1]) / this->Spacing[1];
    if (!(x >= 0.0 && y >= 0.0 && x <= this->Last[0] && y <= this->Last[1]))
    {
      return false;
    }
    const vtkIdType column = std::min(static_cast<vtkIdType>(x), vtkIdType{ this->Last[0] } - 1);
    const vtkIdType row = std::min(static_cast<vtkIdType>(y), vtkIdType{ this->Last[1] } - 1);
    const double f = x - static_cast<double>(column);
    const double g = y - static_cast<double>(row);
    const vtkIdType stride = vtkIdType{ this->Last[0] } + 1;
    const vtkIdType post = row * stride + column;
    const vtkIdType side = f >= g ? post + 1 : post + stride;
    corners.Posts = { post, side, post + stride + 1 };
    corners.Weights = { 1.0 - std::max(f, g), std::abs(f - g), std::min(f, g) };
    return true;
  }

  skyline::ShadowHeightPenumbra Penumbra;
  double PenumbraDepth;
  vtkFloatArray* Hard;
  vtkFloatArray* Upper;
  vtkFloatArray* Lower;
  std::array<double, 3> Origin{}, Spacing{};
  std::array<int, 2> Last{};
};

} // namespace

vtkHeightFieldShadowReceiver::vtkHeightFieldShadowReceiver()
{
  this->SetNumberOfInputPorts(2);
}

void vtkHeightFieldShadowReceiver::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PenumbraDepth: " << this->PenumbraDepth << "\n";
}

void vtkHeightFieldShadowReceiver::SetShadowConnection(vtkAlgorithmOutput* shadow)
{
  this->SetInputConnection(1, shadow);
}

void vtkHeightFieldShadowReceiver::SetShadowData(vtkImageData* shadow)
{
  this->SetInputDataInternal(1, shadow);
}

int vtkHeightFieldShadowReceiver::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkImageData");
  return 1;
}

int vtkHeightFieldShadowReceiver::ComputeInputUpdateExtent(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector*)
{
  skyline::RequestWhole(in[1]->GetInformationObject(0));
  return 1;
}

int vtkHeightFieldShadowReceiver::RequestData(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  vtkPointSet* input = vtkPointSet::GetData(in[0]);
  vtkPointSet* output = vtkPointSet::GetData(out);
  try
  {
    skyline::CheckWhole(in[1]->GetInformationObject(0));
    const Receiver receiver(vtkImageData::GetData(in[1]), this->PenumbraDepth);
    output->ShallowCopy(input);
    vtkNew<vtkFloatArray> visibility;
    visibility->SetName("SunVisibility");
    visibility->SetNumberOfTuples(input->GetNumberOfPoints());
    vtkSMPTools::For(0, input->GetNumberOfPoints(),
      [&](vtkIdType begin, vtkIdType end)
      {
        std::array<double, 3> point{};
        for (vtkIdType id = begin; id < end; ++id)
        {
          input->GetPoint(id, point.data());
          visibility->SetValue(id, static_cast<float>(receiver.Lit(point)));
        }
      });
    output->GetPointData()->AddArray(visibility);
    return 1;
  }
  catch (const std::exception& reason)
  {
    output->Initialize();
    vtkErrorMacro(<< reason.what());
    return 0;
  }
}
