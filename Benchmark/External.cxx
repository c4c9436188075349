// SPDX-License-Identifier: BSD-3-Clause
#include "External.h"

#include "Measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace skyline
{
namespace benchmark
{

namespace fs = std::filesystem;

std::string FirstLine(const char* command)
{
  std::string text;
  if (FILE* pipe = popen(command, "r"))
  {
    std::array<char, 256> buffer{};
    while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr)
    {
      text += buffer.data();
    }
    pclose(pipe);
  }
  return text.substr(0, text.find('\n'));
}

Cost& Cost::operator+=(const Cost& next)
{
  this->Cpu += next.Cpu;
  this->Wall += next.Wall;
  this->Bytes = std::max(this->Bytes, next.Bytes);
  return *this;
}

Cost RunProgram(std::vector<std::string> words)
{
  constexpr int notThere = 127; // the exit code that a shell uses
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  const double start = Now().Wall;
  const pid_t child = fork();
  if (child == 0)
  {
    const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
    for (int stream = 0; stream < 3; ++stream)
    {
      dup2(nowhere, stream);
    }
    execvp(arguments[0], arguments.data());
    _exit(notThere);
  }
  int status = 1;
  rusage usage{};
  const bool ended = child > 0 && wait4(child, &status, 0, &usage) == child;
  if (ended && WIFEXITED(status) && WEXITSTATUS(status) == notThere)
  {
    throw std::runtime_error("not installed");
  }
  if (!ended || status != 0)
  {
    throw std::runtime_error(fs::path(words[0]).filename().string() + " failed");
  }
  const auto seconds = [](const timeval& time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return { seconds(usage.ru_utime) + seconds(usage.ru_stime), Now().Wall - start,
    1024.0 * static_cast<double>(usage.ru_maxrss) };
}

namespace
{

constexpr const char* ScratchName = "skyline-scratch-";

// A descriptor of the folder that holds its lock, or -1 if another process holds it.
int LockFolder(const std::string& folder)
{
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (file >= 0 && flock(file, LOCK_EX | LOCK_NB) != 0)
  {
    close(file);
    return -1;
  }
  return file;
}

// Removes the folders of runs that were killed. No process holds their locks.
void SweepScratchFolders()
{
  std::error_code ignored;
  for (const fs::directory_entry& entry :
    fs::directory_iterator(fs::temp_directory_path(ignored), ignored))
  {
    struct stat status;
    const std::string name = entry.path().string();
    const bool ours = entry.path().filename().string().rfind(ScratchName, 0) == 0 &&
      lstat(name.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == geteuid();
    const int lock = ours ? LockFolder(name) : -1;
    if (lock >= 0)
    {
      fs::remove_all(name, ignored);
      close(lock);
    }
  }
}

} // namespace

ScratchFolder::ScratchFolder()
{
  SweepScratchFolders();
  while (!fs::exists(this->Folder)) // another process may remove the folder before it is locked
  {
    std::string name = (fs::temp_directory_path() / (std::string(ScratchName) + "XXXXXX")).string();
    if (mkdtemp(name.data()) == nullptr)
    {
      throw std::runtime_error("no temporary folder " + name);
    }
    this->Folder = name;
    this->Lock = LockFolder(name);
  }
}

ScratchFolder::~ScratchFolder()
{
  std::error_code ignored;
  fs::remove_all(this->Folder, ignored);
  if (this->Lock >= 0)
  {
    close(this->Lock);
  }
}

void WriteSagaGrid(const oracle::OracleField& field, const std::string& name)
{
  constexpr double square = 1e-6; // in spacings
  if (std::abs(field.SpacingX / field.SpacingY - 1.0) > square)
  {
    throw std::runtime_error("takes square cells alone");
  }
  std::ofstream(name + ".sgrd") << "NAME\t= heights\nDATAFORMAT\t= FLOAT\nDATAFILE_OFFSET\t= 0\n"
                                << "BYTEORDER_BIG\t= FALSE\nPOSITION_XMIN\t= 0.0\n"
                                << "POSITION_YMIN\t= 0.0\nCELLCOUNT_X\t= " << field.Columns
                                << "\nCELLCOUNT_Y\t= " << field.Rows
                                << "\nCELLSIZE\t= " << field.SpacingX
                                << "\nZ_FACTOR\t= 1.0\nNODATA_VALUE\t= " << NoHeight
                                << "\nTOPTOBOTTOM\t= FALSE\n";
  std::ofstream file(name + ".sdat", std::ios::binary);
  for (const double height : field.Heights)
  {
    const float value = std::isfinite(height) ? static_cast<float>(height) : NoHeight;
    file.write(reinterpret_cast<const char*>(&value), sizeof value);
  }
}

std::vector<float> ReadSagaGrid(const oracle::OracleField& field, const std::string& name)
{
  std::vector<float> values(field.Heights.size());
  std::ifstream file(name + ".sdat", std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(values.data()),
        static_cast<std::streamsize>(values.size() * sizeof(float))))
  {
    throw std::runtime_error("no result of the right size");
  }
  return values;
}

} // namespace benchmark
} // namespace skyline
