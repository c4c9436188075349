// SPDX-License-Identifier: BSD-3-Clause
#include "Interrupt.h"

#include "AtomicFile.h"
#include "Failure.h"

#include <csignal>

#include <sys/time.h>
#include <unistd.h>

namespace
{

volatile std::sig_atomic_t Caught = 0;

// Also called in a signal handler: only uses what POSIX allows there.
void EndBy(int number)
{
  std::signal(number, SIG_DFL);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, number);
  ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  (void)std::raise(number);
  ::_exit(128 + number); // the status that a shell reports
}

extern "C" void GiveUp(int number)
{
  skyline::RemoveTemporaries();
  constexpr char text[] = "skyline: interrupted\n";
  const ssize_t ignored = ::write(STDERR_FILENO, text, sizeof(text) - 1);
  (void)ignored;
  EndBy(Caught != 0 ? Caught : number);
}

extern "C" void Remember(int number)
{
  if (Caught != 0)
  {
    GiveUp(number);
  }
  Caught = number;
  const itimerval patience{ { 0, 0 }, { 0, skyline::InterruptPatience * 1000 } };
  ::setitimer(ITIMER_REAL, &patience, nullptr);
}

extern "C" void EndTidily(int number)
{
  skyline::RemoveTemporaries();
  EndBy(number);
}

void Catch(int number, void (*handler)(int))
{
  struct sigaction now = {};
  if (::sigaction(number, nullptr, &now) == 0 && now.sa_handler != SIG_IGN)
  {
    now = {};
    now.sa_handler = handler;
    now.sa_flags = SA_RESTART;
    ::sigaction(number, &now, nullptr);
  }
}

} // namespace

namespace skyline
{

void CatchInterrupts()
{
  for (const int number : { SIGINT, SIGTERM, SIGHUP })
  {
    Catch(number, Remember);
  }
  for (const int number : { SIGQUIT, SIGPIPE })
  {
    Catch(number, EndTidily);
  }
  // Resets SIGALRM, whatever the program that started this one did with it.
  std::signal(SIGALRM, GiveUp);
  sigset_t alarm;
  sigemptyset(&alarm);
  sigaddset(&alarm, SIGALRM);
  ::sigprocmask(SIG_UNBLOCK, &alarm, nullptr);
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

void EndIfInterrupted()
{
  if (Interrupted())
  {
    EndBy(Caught);
  }
}

} // namespace skyline
