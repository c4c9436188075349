// SPDX-License-Identifier: BSD-3-Clause
// Handles interrupts by the user: Ctrl-C and similar signals.
#ifndef skyline_Interrupt_h
#define skyline_Interrupt_h

namespace skyline
{

/// Milliseconds after an interrupt within which the work should stop by itself.
constexpr int InterruptPatience = 500;

/// Installs the signal handlers. The first SIGINT, SIGTERM or SIGHUP sets a flag, so that the work
/// can stop by itself. If it has not stopped after InterruptPatience, or at a second signal,
/// temporary files are removed and the signal ends the program. SIGQUIT and SIGPIPE end it at once;
/// temporary files are removed. Signals that are ignored when the program starts (nohup) stay
/// ignored. A file that exceeds the allowed size becomes a failed write instead of a signal.
void CatchInterrupts();

/// Returns whether such a signal has arrived.
bool Interrupted();

/// Throws Failure("interrupted") if such a signal has arrived.
void StopIfInterrupted();

/// Ends the program by the signal if one has arrived, as if it had not been caught, so that a shell
/// stops its loop. Otherwise returns.
void EndIfInterrupted();

} // namespace skyline

#endif
