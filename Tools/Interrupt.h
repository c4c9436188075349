// SPDX-License-Identifier: BSD-3-Clause
// The user's wish to stop: Ctrl-C and its kin.
#ifndef skyline_Interrupt_h
#define skyline_Interrupt_h

namespace skyline
{

/// Seconds that the work has to notice an interrupt by itself.
constexpr unsigned int InterruptPatience = 2;

/// From now on the first SIGINT, SIGTERM or SIGHUP sets a flag, so that the work can stop by
/// itself; if it has not after InterruptPatience, or at a second signal, temporary files are
/// removed and the program ends with status 1. A file that grows over the allowed size is a failed
/// write from now on, not a signal.
void CatchInterrupts();

/// Whether one of them came.
bool Interrupted();

/// Throws Failure("interrupted") if one of them came.
void StopIfInterrupted();

} // namespace skyline

#endif
