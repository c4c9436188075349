// SPDX-License-Identifier: BSD-3-Clause
// Runs other programs as their users run them, and writes and reads their files.
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

/// The first line that a shell command prints, or an empty text.
std::string FirstLine(const char* command);

struct Cost
{
  double Cpu = 0.0, Wall = 0.0; ///< seconds
  double Bytes = 0.0;           ///< peak of the program's resident memory

  /// For runs one after the other: times are added, and the greater peak is kept.
  Cost& operator+=(const Cost& next);
};

/// Runs a program without showing its output. It is searched for in PATH unless its name has a
/// slash. Throws std::runtime_error if it does not exist or fails.
Cost RunProgram(std::vector<std::string> words);

/// The peak memory of a program, in floats per post.
inline double FloatsPerPost(const Cost& cost, const oracle::OracleField& field)
{
  return cost.Bytes / sizeof(float) / static_cast<double>(field.Heights.size());
}

/// A temporary folder (in TMPDIR), which is removed with its content. It is locked while it is in
/// use. Folders of killed runs are not locked, and are removed when the next folder is made.
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

constexpr float NoHeight = -99999.0f; ///< marks missing posts in files

/// Writes heights as a grid of SAGA (name.sgrd and name.sdat), which GDAL opens too. Throws
/// std::runtime_error if the cells are not square, because SAGA has only square cells.
void WriteSagaGrid(const oracle::OracleField& field, const std::string& name);

/// Reads the values of a grid of the same size, row by row from the south.
std::vector<float> ReadSagaGrid(const oracle::OracleField& field, const std::string& name);

} // namespace benchmark
} // namespace skyline

#endif
