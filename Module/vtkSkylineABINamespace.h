// SPDX-License-Identifier: BSD-3-Clause
/**
 * The macros VTK_ABI_NAMESPACE_BEGIN and VTK_ABI_NAMESPACE_END, which VTK defines since version
 * 9.2. If VTK was configured with VTK_ABI_NAMESPACE_NAME, its classes are in an inline namespace of
 * that name, and so are Skyline's classes. With an older VTK, both macros are empty. Declarations
 * of VTK's classes belong between the two.
 */
#ifndef vtkSkylineABINamespace_h
#define vtkSkylineABINamespace_h

#if __has_include("vtkABINamespace.h")
#include "vtkABINamespace.h"
#endif

#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#endif
