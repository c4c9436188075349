// SPDX-License-Identifier: BSD-3-Clause
#include "AtomicFile.h"

#include "IoFailure.h"
#include "IoTesting.h"

#include <csignal>
#include <fstream>
#include <memory>
#include <sstream>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace skyline_test;
using skyline::AtomicFile;
using skyline::IoFailure;

namespace
{

void Put(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

std::string Get(const std::string& path)
{
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string ReasonFor(const std::string& target)
{
  try
  {
    const AtomicFile file(target);
  }
  catch (const IoFailure& failure)
  {
    return failure.what();
  }
  return "";
}

} // namespace

TEST(AtomicFile, AppearsOnCommitOnly)
{
  const std::string folder = FreshFolder("atomic");
  const std::string target = folder + "/out.tif";
  {
    const AtomicFile file(target);
    Put(file.GetPath(), "half");
    EXPECT_FALSE(std::filesystem::exists(target));
    EXPECT_EQ(file.GetPath().substr(file.GetPath().size() - 4), ".tif");
  }
  EXPECT_TRUE(FilesIn(folder).empty());

  AtomicFile file(target);
  Put(file.GetPath(), "whole");
  Put(file.GetPath() + ".aux.xml", "side");
  Put(file.GetIntermediatePath(), "between");
  file.Commit();
  EXPECT_EQ(Get(target), "whole");
  EXPECT_EQ(Get(target + ".aux.xml"), "side");
  EXPECT_EQ(FilesIn(folder).size(), 2u);
}

TEST(AtomicFile, AFailureLeavesTheOldFile)
{
  const std::string folder = FreshFolder("old");
  const std::string target = folder + "/out.tif";
  Put(target, "old");
  {
    const AtomicFile file(target);
    Put(file.GetPath(), "new");
  }
  EXPECT_EQ(Get(target), "old");
  EXPECT_EQ(FilesIn(folder).size(), 1u);
}

TEST(AtomicFile, KeepsModeAndLink)
{
  const std::string folder = FreshFolder("mode");
  const std::string target = folder + "/real.tif";
  Put(target, "old");
  ::chmod(target.c_str(), 0604);
  std::filesystem::create_symlink("real.tif", folder + "/link.tif");
  AtomicFile file(folder + "/link.tif");
  Put(file.GetPath(), "new");
  file.Commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder + "/link.tif"));
  EXPECT_EQ(Get(target), "new");
  struct stat status;
  ASSERT_EQ(::stat(target.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0604u);

  // A new file gets the permissions that the umask allows.
  const mode_t old = ::umask(027);
  AtomicFile fresh(folder + "/fresh.tif");
  ::umask(old);
  fresh.Commit();
  ASSERT_EQ(::stat((folder + "/fresh.tif").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(AtomicFile, KeepsNeitherSetuidNorMoreThanTheOldRights)
{
  const std::string folder = FreshFolder("rights");
  const std::string target = folder + "/out.tif";
  Put(target, "old");
  ::chmod(target.c_str(), 06750);
  AtomicFile file(target);
  Put(file.GetPath() + ".aux.xml", "side");
  struct stat status;
  ASSERT_EQ(::stat(file.GetPath().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0600u) << "the temporary file is readable by the user alone";
  file.Commit();
  for (const char* suffix : { "", ".aux.xml" })
  {
    ASSERT_EQ(::stat((target + suffix).c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0750u) << suffix;
  }
}

TEST(AtomicFile, DanglingLinksAndLoops)
{
  const std::string folder = FreshFolder("links");
  std::filesystem::create_directory(folder + "/real");
  std::filesystem::create_symlink("next.tif", folder + "/link.tif");
  std::filesystem::create_symlink("real/out.tif", folder + "/next.tif");
  AtomicFile file(folder + "/link.tif");
  Put(file.GetPath(), "new");
  file.Commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder + "/link.tif"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder + "/next.tif"));
  EXPECT_EQ(Get(folder + "/real/out.tif"), "new");
  std::filesystem::create_symlink("loop.tif", folder + "/loop.tif");
  EXPECT_NE(ReasonFor(folder + "/loop.tif").find("symbolic links; choose"), std::string::npos);
}

// A path of a file descriptor of the process (/dev/fd/N): the bytes are written at its current
// position.
TEST(AtomicFile, Descriptors)
{
  const std::string folder = FreshFolder("descriptor");
  Put(folder + "/log", "before ");
  const int log = ::open((folder + "/log").c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(log, 0);
  const std::string name = "/dev/fd/" + std::to_string(log);
  std::filesystem::create_symlink(name, folder + "/link.tif");
  for (const std::string& target : { name, folder + "/link.tif" })
  {
    AtomicFile file(target);
    Put(file.GetPath(), "result ");
    file.Commit();
  }
  ::close(log);
  EXPECT_EQ(Get(folder + "/log"), "before result result ");
  const int closed = ::open((folder + "/log").c_str(), O_RDONLY);
  EXPECT_NE(
    ReasonFor("/dev/fd/" + std::to_string(closed)).find("Bad file descriptor"), std::string::npos);
  ::close(closed);
}

TEST(AtomicFile, APipeIsFilledWhoseReaderComesLater)
{
  const std::string folder = FreshFolder("pipe");
  ASSERT_EQ(::mkfifo((folder + "/pipe").c_str(), 0600), 0);
  const pid_t child = ::fork();
  if (child == 0)
  {
    ::usleep(300000); // the reader may be started later
    ::_exit(Get(folder + "/pipe") == "result" ? 0 : 1);
  }
  AtomicFile file(folder + "/pipe");
  Put(file.GetPath(), "result");
  file.Commit();
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

// Temporary files of a killed process are removed. Those that a running process holds stay,
// whichever process that is.
TEST(AtomicFile, SweepsWhatTheDeadLeft)
{
  const std::string folder = FreshFolder("sweep");
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0)
  {
    const AtomicFile file(folder + "/out.tif");
    Put(file.GetPath() + ".aux.xml", "side");
    Put(file.GetIntermediatePath(), "between");
    ::close(ready[1]);
    for (;;)
    {
      ::pause();
    }
  }
  ::close(ready[1]);
  char none;
  EXPECT_EQ(::read(ready[0], &none, 1), 0); // waits until the child process has it
  ::close(ready[0]);
  const AtomicFile mine(folder + "/mine.tif");
  {
    const AtomicFile other(folder + "/other.tif");
    EXPECT_EQ(FilesIn(folder).size(), 5u);
  }
  ::kill(child, SIGKILL);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  {
    const AtomicFile other(folder + "/other.tif");
    EXPECT_EQ(FilesIn(folder).size(), 2u);
  }
  EXPECT_EQ(FilesIn(folder).size(), 1u);
}

// If a killed process was about to replace a raster, its side files get their names back. If it had
// already replaced the raster, they are removed.
TEST(AtomicFile, SideFilesComeBackAfterAKill)
{
  const std::string folder = FreshFolder("aside");
  Put(folder + "/.skyline-held-1-2.part.tif", "new");
  Put(folder + "/.skyline-held-1-2.part.tif.of.out.tif.aux.xml", "old side");
  Put(folder + "/.skyline-held-1-3.part.tif.of.done.tif.ovr", "old overviews");
  Put(folder + "/.skyline-held-1-4.part.tif", "new");
  Put(folder + "/.skyline-held-1-4.part.tif.of.again.tif.msk", "old mask");
  Put(folder + "/again.tif.msk", "newer mask");
  {
    const AtomicFile other(folder + "/other.tif");
  }
  EXPECT_EQ(FilesIn(folder), (std::vector<std::string>{ "again.tif.msk", "out.tif.aux.xml" }));
  EXPECT_EQ(Get(folder + "/out.tif.aux.xml"), "old side");
  EXPECT_EQ(Get(folder + "/again.tif.msk"), "newer mask");
}

// Signals without a handler end the process as usual, but the temporary files are removed.
TEST(AtomicFile, DefaultSignalsLeaveNothing)
{
  const std::string folder = FreshFolder("default");
  for (const int number : { SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGABRT })
  {
    const pid_t child = ::fork();
    if (child == 0)
    {
      std::signal(number, SIG_DFL);
      const AtomicFile file(folder + "/out.tif");
      ::raise(number);
      ::_exit(1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status)) << number;
    EXPECT_EQ(WTERMSIG(status), number);
    EXPECT_TRUE(FilesIn(folder).empty()) << number;
  }
  // Afterwards the signal handlers are restored. Handlers of the program are never changed.
  std::signal(SIGHUP, SIG_IGN);
  {
    const AtomicFile file(folder + "/out.tif");
    EXPECT_EQ(std::signal(SIGHUP, SIG_IGN), SIG_IGN);
  }
  EXPECT_EQ(std::signal(SIGHUP, SIG_DFL), SIG_IGN);
  EXPECT_EQ(std::signal(SIGTERM, SIG_DFL), SIG_DFL);
}

TEST(AtomicFile, ReasonsNameTheFileAndTheCure)
{
  const std::string folder = FreshFolder("reasons");
  const std::string absent = folder + "/absent/out.tif";
  EXPECT_EQ(ReasonFor(absent),
    "cannot write '" + absent + "': No such file or directory; make its folder first");
  EXPECT_EQ(ReasonFor(folder), "cannot write '" + folder + "': Is a directory; add a file name");
  EXPECT_NE(ReasonFor("/proc/out.tif").find("cannot write '/proc/out.tif': "), std::string::npos);
  Put(folder + "/file", "");
  EXPECT_NE(ReasonFor(folder + "/file/out.tif").find("Not a directory"), std::string::npos);
}

TEST(AtomicFile, UnwritableFolder)
{
  const std::string folder = FreshFolder("closed");
  ::chmod(folder.c_str(), 0555);
  const uid_t user = ::geteuid();
  const uid_t nobody = 65534; // root may write everywhere
  if (user == 0)
  {
    ASSERT_EQ(::seteuid(nobody), 0);
  }
  const std::string reason = ReasonFor(folder + "/out.tif");
  if (user == 0)
  {
    ASSERT_EQ(::seteuid(user), 0);
  }
  ::chmod(folder.c_str(), 0755);
  EXPECT_NE(reason.find("Permission denied; choose"), std::string::npos) << reason;
}

// A device receives the bytes and stays a device.
TEST(AtomicFile, Devices)
{
  AtomicFile null("/dev/null");
  Put(null.GetPath(), "gone");
  null.Commit();

  AtomicFile full("/dev/full");
  const std::string temporary = full.GetPath();
  Put(temporary, "too much");
  try
  {
    full.Commit();
    FAIL() << "wrote to a full device";
  }
  catch (const IoFailure& failure)
  {
    EXPECT_EQ(failure.GetCode(), vtkErrorCode::OutOfDiskSpaceError);
    EXPECT_EQ(std::string(failure.what()),
      "cannot write '/dev/full': No space left on device; free some space or choose another place");
  }
  struct stat status;
  ASSERT_EQ(::stat("/dev/full", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));
  ASSERT_EQ(::stat("/dev/null", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));
}

TEST(AtomicFile, SignalHandlersCanTidyUp)
{
  const std::string folder = FreshFolder("signal");
  const pid_t child = ::fork();
  if (child == 0)
  {
    std::signal(SIGINT,
      [](int)
      {
        skyline::RemoveTemporaries();
        ::_exit(130);
      });
    const AtomicFile a(folder + "/a.tif"), b(folder + "/b.png");
    Put(a.GetIntermediatePath(), "between");
    Put(a.GetPath() + ".ovr.tmp", "overviews");
    AtomicFile done(folder + "/done.tif");
    done.Commit();
    ::raise(SIGINT);
    ::_exit(1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(FilesIn(folder), std::vector<std::string>{ "done.tif" });
}

// More files at a time than the list can hold: they still work, but a signal would not remove the
// rest.
TEST(AtomicFile, ManyAtOnce)
{
  const std::string folder = FreshFolder("many");
  {
    std::vector<std::unique_ptr<AtomicFile>> files;
    for (int i = 0; i < 40; ++i)
    {
      files.push_back(std::make_unique<AtomicFile>(folder + "/" + std::to_string(i) + ".tif"));
    }
    files.front()->Commit();
    files.back()->Commit();
  }
  EXPECT_EQ(FilesIn(folder).size(), 2u);
}
