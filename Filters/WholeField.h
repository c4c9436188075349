// SPDX-License-Identifier: BSD-3-Clause
// Filters that need the whole height field, in pipelines that work on pieces of it.
#ifndef skyline_WholeField_h
#define skyline_WholeField_h

#include "SkylineFiltersModule.h"   // For the export macro
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkInformation;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Asks for all of an input on this process, whatever part of the output is asked for: any post may
/// be the horizon of any other. For images and for other data.
SKYLINEFILTERS_EXPORT void RequestWhole(vtkInformation* input);

/// Throws std::invalid_argument, with the two extents, unless the image of that input is whole.
SKYLINEFILTERS_EXPORT void CheckWhole(vtkInformation* input);

/// Whether the output's first piece is asked for, or no pieces at all: what cannot be cut is made by
/// the first process.
SKYLINEFILTERS_EXPORT bool IsFirstPiece(vtkInformation* output);

/// Leaves in the image of an output the piece that this process was asked for, so that pieces of
/// several processes make the same whole as one process does. Requests by extent may get more than
/// they asked for, as everywhere in VTK.
SKYLINEFILTERS_EXPORT void KeepPiece(vtkInformation* output);

} // namespace skyline

#endif
