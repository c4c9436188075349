// SPDX-License-Identifier: BSD-3-Clause
#ifndef skyline_OpenLightMap_h
#define skyline_OpenLightMap_h

#include "LightMapFile.h"

#include <memory>
#include <string>

namespace skyline
{

/// ImageLibrary::OpenLightMap, implemented with OpenImageIO.
std::unique_ptr<LightMapFile> OpenLightMap(const std::string& file);

} // namespace skyline

#endif
