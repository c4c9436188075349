// SPDX-License-Identifier: BSD-3-Clause
#include "Data/LightMapImage.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <stdexcept>
#include <string>

namespace skyline
{

LightMap ViewLightMap(vtkImageData* image)
{
  int size[3] = { 0, 0, 0 };
  if (image)
  {
    image->GetDimensions(size);
  }
  if (size[0] < 1 || size[1] < 1 || size[2] != 1)
  {
    throw std::invalid_argument("the light map has " + std::to_string(size[0]) + " x " +
      std::to_string(size[1]) + " x " + std::to_string(size[2]) +
      " pixels; give a two-dimensional image, such as vtkSkylineLightMapReader's");
  }
  vtkDataArray* array = image->GetPointData()->GetArray(RadianceArrayName);
  vtkFloatArray* radiance = vtkFloatArray::FastDownCast(array);
  if (!radiance || radiance->GetNumberOfComponents() != 3)
  {
    throw std::invalid_argument(std::string("the light map has no point array '") +
      RadianceArrayName + "' of 3 floats; give an image such as vtkSkylineLightMapReader's");
  }
  return ViewBottomUp(radiance->GetPointer(0), size[0], size[1]);
}

} // namespace skyline
