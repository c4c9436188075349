// SPDX-License-Identifier: BSD-3-Clause
// What the readers share: the check of the file name, and the conversion of exceptions to one-line
// errors.
#ifndef skyline_ReadGuard_h
#define skyline_ReadGuard_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <functional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Calls work(fileName) and returns a vtkErrorCode, NoError on success. A failure is reported as an
/// error of `reader`. An abort returns UserError and reports nothing. `lessMemory` says how to need
/// less memory.
unsigned long GuardRead(vtkObject* reader, const char* fileName, const char* lessMemory,
  const std::function<void(const std::string&)>& work);

} // namespace skyline

#endif
