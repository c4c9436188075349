// SPDX-License-Identifier: BSD-3-Clause
#include "AtomicFile.h"

#include "IoFailure.h"
#include "IoTesting.h"

#include <csignal>
#include <fstream>
#include <memory>
#include <sstream>

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

  // A new file gets what the umask leaves.
  const mode_t old = ::umask(027);
  AtomicFile fresh(folder + "/fresh.tif");
  ::umask(old);
  fresh.Commit();
  ASSERT_EQ(::stat((folder + "/fresh.tif").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
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

// A device gets the bytes and stays a device.
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

// More at a time than the list holds: they still work, only a signal would miss them.
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
