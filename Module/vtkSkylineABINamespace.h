// SPDX-License-Identifier: BSD-3-Clause
/**
 * VTK_ABI_NAMESPACE_BEGIN and VTK_ABI_NAMESPACE_END, which VTK has since 9.2: a VTK that was configured
 * with VTK_ABI_NAMESPACE_NAME holds its classes in an inline namespace of that name, and Skyline's classes
 * are then in it too. Empty with an older VTK. Declarations of VTK's classes belong between the two.
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
