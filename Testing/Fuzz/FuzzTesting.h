// SPDX-License-Identifier: BSD-3-Clause
// What the fuzzers share: a folder of their own, quiet libraries, algorithms that may fail but must say
// why in one line.
#ifndef skyline_FuzzTesting_h
#define skyline_FuzzTesting_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkOutputWindow.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace skyline
{
namespace testing
{

/// A new folder in that of temporary files; the process works in it and takes it away at its end.
class FuzzFolder
{
public:
  FuzzFolder()
    : Path(std::filesystem::temp_directory_path() / ("skyline-fuzz-" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(this->Path);
    std::filesystem::current_path(this->Path);
  }
  ~FuzzFolder()
  {
    std::error_code ignored;
    std::filesystem::current_path("/", ignored);
    std::filesystem::remove_all(this->Path, ignored);
  }

  std::string File(const char* name) const { return (this->Path / name).string(); }

private:
  std::filesystem::path Path;
};

inline void WriteBytes(const std::string& file, const std::uint8_t* bytes, std::size_t size)
{
  std::ofstream(file, std::ios::binary)
    .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
}

/// Stops the program, which is how a fuzzer is told of a failure.
inline void Demand(bool condition, const char* what)
{
  if (!condition)
  {
    std::fprintf(stderr, "demanded: %s\n", what);
    std::abort();
  }
}

/// Updates; every error of the algorithm must be one line.
inline void UpdateQuietly(vtkAlgorithm* algorithm)
{
  // Not GlobalWarningDisplayOff, after which no error is raised either.
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  vtkNew<vtkCallbackCommand> check;
  check->SetCallback(
    [](vtkObject*, unsigned long, void*, void* text)
    {
      // VTK's own frame around the reason ends in two line feeds.
      std::string reason = static_cast<const char*>(text);
      reason = reason.substr(reason.find("): ") == std::string::npos ? 0 : reason.find("): ") + 3);
      reason = reason.substr(0, reason.find_last_not_of('\n') + 1);
      Demand(!reason.empty() && reason.find('\n') == std::string::npos, "a reason of one line");
    });
  algorithm->AddObserver(vtkCommand::ErrorEvent, check);
  algorithm->Update();
}

} // namespace testing
} // namespace skyline

#endif
