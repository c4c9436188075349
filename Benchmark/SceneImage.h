// SPDX-License-Identifier: BSD-3-Clause
// The height field of a scene as the input of a filter.
#ifndef skyline_SceneImage_h
#define skyline_SceneImage_h

#include "Reference/Oracle.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{
namespace benchmark
{

/// An image with one scalar array "Elevation" (float, metres) and no georeference.
vtkSmartPointer<vtkImageData> ImageOf(const oracle::OracleField& field);

/// Replaces the heights of an image, so that each downstream filter must run again.
void SetHeights(vtkImageData* image, const oracle::OracleField& field);

/// Changes the heights as little as possible, so that each downstream filter must run again: one
/// post rises by the smallest step of a float (filters may compare heights, not modification
/// times).
void Touch(vtkImageData* image);

} // namespace benchmark
} // namespace skyline

#endif
