// SPDX-License-Identifier: BSD-3-Clause
// Other programs, run as their users run them, and the files they read.
#ifndef skyline_External_h
#define skyline_External_h

#include "Reference/Oracle.h"

#include <filesystem>
#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// First line that a shell command prints, empty if none.
std::string FirstLine(const char* command);

struct Cost
{
  double Cpu = 0.0, Wall = 0.0; ///< seconds
  double Bytes = 0.0;           ///< peak of the program's resident memory

  /// Runs one after the other: times add up, the greater peak stays.
  Cost& operator+=(const Cost& next);
};

/// Runs a program (searched in PATH unless its name has a slash), silent; std::runtime_error if it is
/// not there or fails.
Cost RunProgram(std::vector<std::string> words);

/// The peak memory of a program, in floats a post.
inline double FloatsPerPost(const Cost& cost, const oracle::OracleField& field)
{
  return cost.Bytes / sizeof(float) / static_cast<double>(field.Heights.size());
}

/// A temporary folder (in TMPDIR), which goes with everything in it. It is locked as long as it is used:
/// those of killed runs, which nobody locks, go when the next one is made.
class ScratchFolder
{
public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& Path() const { return this->Folder; }
  std::string File(const std::string& name) const { return (this->Folder / name).string(); }

private:
  std::filesystem::path Folder;
  int Lock = -1;
};

constexpr float NoHeight = -99999.0f; ///< in files, of missing posts

/// Writes heights as SAGA's grid (name.sgrd and name.sdat), which GDAL opens too. std::runtime_error
/// if the cells are not square: SAGA knows no others.
void WriteSagaGrid(const oracle::OracleField& field, const std::string& name);

/// The values of a grid of the same size, row by row from the south.
std::vector<float> ReadSagaGrid(const oracle::OracleField& field, const std::string& name);

} // namespace benchmark
} // namespace skyline

#endif
