// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVHeightFieldSunShadow.h"

#include "LaterTime.h"
#include "vtkObjectFactory.h"

#include <utility>

vtkStandardNewMacro(vtkPVHeightFieldSunShadow);

void vtkPVHeightFieldSunShadow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HoursLater: " << this->HoursLater << "\n";
}

bool vtkPVHeightFieldSunShadow::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  if (!this->UseTime)
  {
    return this->Superclass::Compute(driver, output);
  }
  struct Restorer
  {
    std::string& Place;
    std::string Value;
    ~Restorer() { this->Place = std::move(this->Value); }
  };
  const Restorer restorer{ this->Time, this->Time };
  this->Time = skyline::LaterTime(this->Time, this->HoursLater);
  return this->Superclass::Compute(driver, output);
}
