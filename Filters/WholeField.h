// SPDX-License-Identifier: BSD-3-Clause
// For filters that need the whole height field in pipelines that work on pieces of it.
#ifndef skyline_WholeField_h
#define skyline_WholeField_h

#include "SkylineFiltersModule.h"   // for the export macro
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkInformation;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Requests all of an input on this process, whatever part of the output is requested, since any
/// post may form the horizon of any other. For images and for other data.
SKYLINEFILTERS_EXPORT void RequestWhole(vtkInformation* input);

/// Throws std::invalid_argument, with both extents, unless the image of the input is complete.
SKYLINEFILTERS_EXPORT void CheckWhole(vtkInformation* input);

/// Returns whether the first piece of the output is requested, or no pieces are used. What cannot
/// be divided is made by the first process.
SKYLINEFILTERS_EXPORT bool IsFirstPiece(vtkInformation* output);

/// Reduces the image of an output to the piece that was requested from this process, so that the
/// pieces of several processes form the same whole as that of one process. Requests by extent may
/// get more than they requested, as everywhere in VTK.
SKYLINEFILTERS_EXPORT void KeepPiece(vtkInformation* output);

} // namespace skyline

#endif
