// SPDX-License-Identifier: BSD-3-Clause
// Which files an input lives in, so that no output takes the place of one.
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

/// Field data array of strings: absolute paths (or GDAL's names) of the files that an image was read
/// from.
constexpr const char* SourceFilesArrayName = "SourceFiles";

/// Puts the names into the field data of `data`, made absolute where they are files.
SKYLINEIO_EXPORT void StoreSourceFiles(const std::vector<std::string>& names, vtkDataObject* data);

/// The names in the field data of `data`; none where there are none.
SKYLINEIO_EXPORT std::vector<std::string> LoadSourceFiles(vtkDataObject* data);

/// Throws IoFailure if writing `output` would replace or remove a file that one of the inputs is
/// read from. An input is a file or any name that GDAL opens; its files are those that are part of the
/// name (a file in an archive, a band of a netCDF file), what lies beside them under their name, and
/// the sources of virtual rasters, theirs too. Files are compared by what they are (device and inode),
/// so that links and other spellings make no difference. Virtual rasters are read whole, of other
/// files only the first 1024 bytes.
SKYLINEIO_EXPORT void RefuseOverlap(
  const std::string& output, const std::vector<std::string>& inputs);

} // namespace skyline

#endif
