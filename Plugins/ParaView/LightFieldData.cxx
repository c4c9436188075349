// SPDX-License-Identifier: BSD-3-Clause
#include "LightFieldData.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>

namespace skyline
{

namespace
{

constexpr const char* FrameName = "SkylineFrame"; // 6 values of extent, 3 of origin, 3 of spacing
const std::string Prefix = "SkylineLight_";

vtkSmartPointer<vtkDataArray> Renamed(vtkDataArray* array, const std::string& name)
{
  const auto renamed = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  renamed->ShallowCopy(array);
  renamed->SetName(name.c_str());
  return renamed;
}

vtkSmartPointer<vtkImageData> LoadLeaf(vtkDataObject* leaf)
{
  vtkFieldData* fields = leaf ? leaf->GetFieldData() : nullptr;
  vtkDataArray* frame = fields ? fields->GetArray(FrameName) : nullptr;
  if (!frame || frame->GetNumberOfValues() != 12)
  {
    return nullptr;
  }
  std::array<double, 12> numbers{};
  frame->GetTuple(0, numbers.data());
  auto image = vtkSmartPointer<vtkImageData>::New();
  std::array<int, 6> extent{};
  std::transform(numbers.begin(), numbers.begin() + 6, extent.begin(),
    [](double number) { return static_cast<int>(number); });
  image->SetExtent(extent.data());
  image->SetOrigin(&numbers[6]);
  image->SetSpacing(&numbers[9]);
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = fields->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if (name.rfind(Prefix, 0) == 0 && array->GetNumberOfTuples() == image->GetNumberOfPoints())
    {
      image->GetPointData()->AddArray(Renamed(array, name.substr(Prefix.size())));
    }
  }
  return image;
}

} // namespace

void StoreLight(vtkImageData* image, const std::vector<std::string>& arrays, vtkDataObject* surface)
{
  std::array<double, 12> numbers{};
  std::copy_n(image->GetExtent(), 6, numbers.begin());
  std::copy_n(image->GetOrigin(), 3, numbers.begin() + 6);
  std::copy_n(image->GetSpacing(), 3, numbers.begin() + 9);
  vtkNew<vtkDoubleArray> frame;
  frame->SetName(FrameName);
  frame->SetNumberOfComponents(static_cast<int>(numbers.size()));
  frame->InsertNextTuple(numbers.data());
  surface->GetFieldData()->AddArray(frame);
  for (const std::string& name : arrays)
  {
    if (vtkDataArray* array = image->GetPointData()->GetArray(name.c_str()))
    {
      surface->GetFieldData()->AddArray(Renamed(array, Prefix + name));
    }
  }
}

vtkSmartPointer<vtkImageData> LoadLight(vtkDataObject* surface)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(surface);
  if (!composite)
  {
    return LoadLeaf(surface);
  }
  const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    if (auto image = LoadLeaf(leaf->GetCurrentDataObject()))
    {
      return image;
    }
  }
  return nullptr;
}

} // namespace skyline
