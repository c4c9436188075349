// SPDX-License-Identifier: BSD-3-Clause
// The files that an input is read from, so that no output replaces one of them.
#ifndef skyline_SourceFiles_h
#define skyline_SourceFiles_h

#include "SkylineIOModule.h"        // for the export macro
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Field data array of strings: the absolute paths (or GDAL's names) of the files that an image was
/// read from.
constexpr const char* SourceFilesArrayName = "SourceFiles";

/// Stores the names in the field data of `data`. Paths of existing files are made absolute.
SKYLINEIO_EXPORT void StoreSourceFiles(const std::vector<std::string>& names, vtkDataObject* data);

/// Returns the names in the field data of `data`; an empty list if there are none.
SKYLINEIO_EXPORT std::vector<std::string> LoadSourceFiles(vtkDataObject* data);

/// Throws IoFailure if writing `output` would replace or remove a file that one of the inputs is
/// read from. An input is a file or any name that GDAL opens. Its files are those that are part of
/// the name (a file in an archive, a band of a netCDF file), the side files with the same name, and
/// the sources of virtual rasters with their own sources. Files are compared by device and inode,
/// so that links and different spellings do not matter. Virtual rasters are read whole, other files
/// only up to 1024 bytes.
SKYLINEIO_EXPORT void RefuseOverlap(
  const std::string& output, const std::vector<std::string>& inputs);

} // namespace skyline

#endif
