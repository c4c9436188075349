// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldSunAlgorithm.h"

#include <algorithm>

vtkHeightFieldSunAlgorithm::vtkHeightFieldSunAlgorithm()
  : Sun(vtkSmartPointer<vtkSkylineSunLight>::New())
{
}

vtkHeightFieldSunAlgorithm::~vtkHeightFieldSunAlgorithm() = default;

void vtkHeightFieldSunAlgorithm::SetSun(vtkSkylineSunLight* sun)
{
  if (sun != this->Sun)
  {
    this->Sun = sun;
    if (!sun)
    {
      this->Sun = vtkSmartPointer<vtkSkylineSunLight>::New();
    }
    this->Modified();
  }
}

vtkMTimeType vtkHeightFieldSunAlgorithm::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Sun->GetMTime());
}

void vtkHeightFieldSunAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sun:\n";
  this->Sun->PrintSelf(os, indent.GetNextIndent());
}
