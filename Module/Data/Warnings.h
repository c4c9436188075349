// SPDX-License-Identifier: BSD-3-Clause
// Warnings about doubtful input, raised by the VTK object that found it.
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

/// Raises the doubt as a WarningEvent of `object`, as vtkWarningMacro does. The command line prints
/// the warning once on standard error as "warning: ..." (not with --quiet), Python raises a
/// UserWarning, and ParaView shows the warning in its output window. Call this function only in the
/// thread that executes the pipeline.
SKYLINECORE_EXPORT void Warn(vtkObject* object, const Doubt& doubt);

} // namespace skyline

#endif
