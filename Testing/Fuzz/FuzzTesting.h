// SPDX-License-Identifier: BSD-3-Clause
// Code that all fuzzers share: a temporary folder, silent libraries, and a check that an algorithm
// that fails reports one line.
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

/// Makes a temporary folder, in which the process works and which is removed at the end.
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

/// Aborts the program, which reports a failure to the fuzzer.
inline void Demand(bool condition, const char* what)
{
  if (!condition)
  {
    std::fprintf(stderr, "demanded: %s\n", what);
    std::abort();
  }
}

/// Updates an algorithm. Each of its errors must be one line.
inline void UpdateQuietly(vtkAlgorithm* algorithm)
{
  // GlobalWarningDisplayOff would also suppress the error events.
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  vtkNew<vtkCallbackCommand> check;
  check->SetCallback(
    [](vtkObject*, unsigned long, void*, void* text)
    {
      // The text that VTK adds around the reason ends in two line feeds.
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
