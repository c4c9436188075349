// SPDX-License-Identifier: BSD-3-Clause
#include "ImageLibrary.h"

#include "IoFailure.h"

#include "vtkErrorCode.h"

#include <string>

#include <dlfcn.h>

namespace skyline
{

namespace
{

#ifdef SKYLINE_IMAGES_FILE
const ImageLibrary* Load()
{
  // Beside this library, wherever that is: a package, a plugin, a build.
  Dl_info self = {};
  std::string path = SKYLINE_IMAGES_FILE;
  if (::dladdr(reinterpret_cast<const void*>(&ImageLibrary::Get), &self) != 0 && self.dli_fname)
  {
    const std::string own = self.dli_fname;
    path.insert(0, own.substr(0, own.rfind('/') + 1));
  }
  void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const function = library ? ::dlsym(library, ImageLibraryFunctionName) : nullptr;
  if (!function)
  {
    const char* const reason = ::dlerror();
    throw IoFailure(vtkErrorCode::UnknownError,
      "images cannot be read or written: " + FirstLine(reason ? reason : "unknown") +
        "; install Skyline whole, and OpenImageIO with it");
  }
  return reinterpret_cast<ImageLibraryFunction>(function)();
}
#else
const ImageLibrary* Load()
{
  return SkylineImageLibrary();
}
#endif

} // namespace

const ImageLibrary& ImageLibrary::Get()
{
  static const ImageLibrary* const library = Load();
  return *library;
}

} // namespace skyline
