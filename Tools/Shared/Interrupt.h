// SPDX-License-Identifier: BSD-3-Clause
// The user's wish to stop: Ctrl-C and its kin.
#ifndef skyline_Interrupt_h
#define skyline_Interrupt_h

namespace skyline
{

/// Milliseconds that the work has to notice an interrupt by itself.
constexpr int InterruptPatience = 500;

/// From now on the first SIGINT, SIGTERM or SIGHUP sets a flag, so that the work can stop by
/// itself; if it has not after InterruptPatience, or at a second signal, temporary files are
/// removed and the program ends by the signal. SIGQUIT and SIGPIPE end it at once, without
/// temporary files. Signals that are ignored when the program starts (nohup) stay so. A file that
/// grows over the allowed size is a failed write from now on, not a signal.
void CatchInterrupts();

/// Whether one of them came.
bool Interrupted();

/// Throws Failure("interrupted") if one of them came.
void StopIfInterrupted();

/// If one of them came, ends the program by it, as if it had not been caught, so that a shell stops
/// its loop; else returns.
void EndIfInterrupted();

} // namespace skyline

#endif
