// SPDX-License-Identifier: BSD-3-Clause
// The function with which the package `skyline` updates a pipeline while other Python threads run:
// the wrapped Update of VTK holds Python's global lock, a function called by ctypes does not.
// (Observers written in Python take the lock themselves: vtkPythonCommand.)
#include "SkylineFiltersModule.h" // for the export macro
#include "vtkAlgorithm.h"

#include <exception>

/// `object` is the address of a vtkAlgorithm, as its Python object gives it. The caller holds a
/// reference.
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
  catch (const std::exception& reason) // exceptions must not pass through Python
  {
    vtkErrorWithObjectMacro(algorithm, << reason.what());
  }
  catch (...)
  {
    vtkErrorWithObjectMacro(algorithm, << "unknown exception");
  }
}
