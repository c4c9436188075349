// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Warnings.h"

#include "vtkObject.h"
#include "vtkSetGet.h"

namespace skyline
{

void Warn(vtkObject* object, const Doubt& doubt)
{
  vtkWarningWithObjectMacro(object, << DoubtText(doubt));
}

} // namespace skyline
