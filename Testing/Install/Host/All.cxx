// SPDX-License-Identifier: BSD-3-Clause
// Classes of every module: they link, and they can be made.
#include "vtkHeightFieldHorizon.h"
#include "vtkHeightFieldWriter.h"
#include "vtkNew.h"
#include "vtkOpenGLHeightFieldHorizon.h"
#include "vtkSkylineSoftShadowShader.h"

#include <iostream>

int main()
{
  vtkNew<vtkHeightFieldHorizon> horizon;
  vtkNew<vtkHeightFieldWriter> writer;
  vtkNew<vtkOpenGLHeightFieldHorizon> counterpart;
  vtkNew<vtkSkylineSoftShadowShader> shader;
  for (vtkObject* object : { static_cast<vtkObject*>(horizon), static_cast<vtkObject*>(writer),
         static_cast<vtkObject*>(counterpart), static_cast<vtkObject*>(shader) })
  {
    object->Print(std::cout);
  }
  return 0;
}
