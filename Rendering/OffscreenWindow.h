// SPDX-License-Identifier: BSD-3-Clause
// A window that draws pictures off screen.
#ifndef skyline_OffscreenWindow_h
#define skyline_OffscreenWindow_h

#include "SkylineRenderingModule.h" // For the export macro
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include "vtkSmartPointer.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Makes a vtkSkylineEGLWindow if EGL provides a context, otherwise an off-screen window of the X
/// server that DISPLAY names. Returns null, and the reason in one line, if neither is possible.
SKYLINERENDERING_EXPORT vtkSmartPointer<vtkRenderWindow> MakeOffscreenWindow(std::string& reason);

} // namespace skyline

#endif
