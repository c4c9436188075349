// SPDX-License-Identifier: BSD-3-Clause
#include "Interrupt.h"

#include "AtomicFile.h"
#include "Failure.h"

#include <csignal>

#include <unistd.h>

namespace
{

volatile std::sig_atomic_t Caught = 0;

// Only what POSIX allows in a signal handler.
extern "C" void GiveUp(int)
{
  skyline::RemoveTemporaries();
  constexpr char text[] = "skyline: interrupted\n";
  const ssize_t ignored = ::write(STDERR_FILENO, text, sizeof(text) - 1);
  (void)ignored;
  ::_exit(1);
}

extern "C" void Remember(int signal)
{
  if (Caught != 0)
  {
    GiveUp(signal);
  }
  Caught = 1;
  ::alarm(skyline::InterruptPatience);
}

} // namespace

namespace skyline
{

void CatchInterrupts()
{
  for (int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    std::signal(signal, Remember);
  }
  std::signal(SIGALRM, GiveUp);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool Interrupted()
{
  return Caught != 0;
}

void StopIfInterrupted()
{
  if (Interrupted())
  {
    throw Failure("interrupted");
  }
}

} // namespace skyline
