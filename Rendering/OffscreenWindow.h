// SPDX-License-Identifier: BSD-3-Clause
// A window to draw pictures in that nobody sees.
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

/// A window of vtkSkylineEGLWindow where EGL gives a context, else an off-screen one of the X server
/// that DISPLAY names; null, with the reason in one line, where there is neither.
SKYLINERENDERING_EXPORT vtkSmartPointer<vtkRenderWindow> MakeOffscreenWindow(std::string& reason);

} // namespace skyline

#endif
