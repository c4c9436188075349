// SPDX-License-Identifier: BSD-3-Clause
// What readers have in common: a file's name, and failures that become errors of one line.
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

/// Runs work(fileName) and returns the vtkErrorCode, NoError if it succeeded. Failures are reported as
/// an error of `reader`; an abort is UserError without a report. lessMemory: how to need less of it.
unsigned long GuardRead(vtkObject* reader, const char* fileName, const char* lessMemory,
  const std::function<void(const std::string&)>& work);

} // namespace skyline

#endif
