// SPDX-License-Identifier: BSD-3-Clause
#include "CallLog.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace skyline
{
namespace testing
{

void LogCall(const char* what, const char* name) noexcept
{
  const char* const log = std::getenv("SKYLINE_CALL_LOG");
  if (!log)
  {
    return;
  }
  const int before = errno;
  char line[512];
  std::size_t length = 0;
  for (const char* part : { what, " ", name ? name : "" })
  {
    for (; *part != '\0' && length + 1 < sizeof(line); ++part)
    {
      line[length++] = *part == '\n' ? ' ' : *part;
    }
  }
  line[length++] = '\n';
  const long file =
    ::syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file >= 0)
  {
    (void)::syscall(SYS_write, file, line, length); // one write per line: threads do not mix
    (void)::syscall(SYS_close, file);
  }
  errno = before;
}

} // namespace testing
} // namespace skyline
