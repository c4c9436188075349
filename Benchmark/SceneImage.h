// SPDX-License-Identifier: BSD-3-Clause
// The height field of a scene as a filter takes it.
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

/// One scalar array "Elevation", float, metres; flat: no georeference.
vtkSmartPointer<vtkImageData> ImageOf(const oracle::OracleField& field);

/// The heights of an image that has changed: every filter behind it has to run again.
void SetHeights(vtkImageData* image, const oracle::OracleField& field);

/// Changes the heights as little as can be, so that every filter behind them has to run again: one
/// post rises by a float's smallest step (filters may compare heights, not times).
void Touch(vtkImageData* image);

} // namespace benchmark
} // namespace skyline

#endif
