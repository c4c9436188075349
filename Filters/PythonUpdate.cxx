// SPDX-License-Identifier: BSD-3-Clause
// The door by which the package `skyline` updates a pipeline while other threads of Python run: VTK's
// wrapped Update holds Python's lock, a function called by ctypes does not. (Observers written in Python
// take the lock themselves: vtkPythonCommand.)
#include "SkylineFiltersModule.h" // for the export macro
#include "vtkAlgorithm.h"

#include <exception>

/// `object`: the address of a vtkAlgorithm as its Python object tells it; the caller holds a reference.
extern "C" SKYLINEFILTERS_EXPORT void SkylineUpdateAlgorithm(void* object) noexcept;

void SkylineUpdateAlgorithm(void* object) noexcept
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(static_cast<vtkObjectBase*>(object));
  if (!algorithm)
  {
    return;
  }
  try
  {
    algorithm->Update();
  }
  catch (const std::exception& reason) // none may pass through Python
  {
    vtkErrorWithObjectMacro(algorithm, << reason.what());
  }
  catch (...)
  {
    vtkErrorWithObjectMacro(algorithm, << "an exception of an unknown kind");
  }
}
