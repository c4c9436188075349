// SPDX-License-Identifier: BSD-3-Clause
// Warnings about doubtful input, raised by the VTK object that met it.
#ifndef skyline_Warnings_h
#define skyline_Warnings_h

#include "Shared/Doubt.h"
#include "SkylineCoreModule.h"      // for the export macro
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Raises the doubt as a WarningEvent of `object`, as vtkWarningMacro does. The command line prints it
/// once on standard error as "warning: ..." (--quiet: not at all), Python raises a UserWarning, and
/// ParaView shows it in its output window. Call it from the thread that executes the pipeline.
SKYLINECORE_EXPORT void Warn(vtkObject* object, const Doubt& doubt);

} // namespace skyline

#endif
