// SPDX-License-Identifier: BSD-3-Clause
#include "ImageLibrary.h"

#include "IoFailure.h"

#include "vtkErrorCode.h"

#include <cstddef>
#include <exception>
#include <future>
#include <string>
#include <thread>
#include <vector>

#include <dlfcn.h>

namespace skyline
{

namespace
{

#ifdef SKYLINE_IMAGES_FILE
/// The number of threads that libraries used by OpenImageIO start when they are loaded (log4cplus,
/// on Debian). If they cannot start them, they end the process.
constexpr std::size_t LibraryThreads = 4;

/// Throws IoFailure if the system does not provide enough threads.
void CheckThreads()
{
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  std::vector<std::thread> threads;
  bool refused = false;
  try
  {
    threads.reserve(LibraryThreads);
    while (threads.size() < LibraryThreads)
    {
      threads.emplace_back([ended] { ended.wait(); });
    }
  }
  catch (const std::exception&) // no more threads, or no memory for one
  {
    refused = true;
  }
  end.set_value();
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  if (refused)
  {
    throw IoFailure(vtkErrorCode::UnknownError,
      "images cannot be read or written: OpenImageIO needs " + std::to_string(LibraryThreads) +
        " threads, and the system allows fewer; raise its limit (ulimit -u), or write a .tif");
  }
}

const ImageLibrary* Load()
{
  CheckThreads();
  // The library lies in the folder of this one: in a package, a plugin or a build tree.
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
        "; install Skyline completely, together with OpenImageIO");
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
