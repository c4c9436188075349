// SPDX-License-Identifier: BSD-3-Clause
// Running a pipeline one algorithm at a time, with progress, errors and times told the way a
// command-line program tells them.
#ifndef skyline_Passes_h
#define skyline_Passes_h

#include "Shared/Doubt.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <functional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// What the user wants to hear, and how much of the machine we may use.
struct Talk
{
  bool Quiet = false;   ///< no progress bar, no warnings
  bool Verbose = false; ///< passes and their times
  int Threads = 0;      ///< 0: all processors
};

/// Sends VTK's own messages to us instead of the terminal, and sets the number of threads: as many as
/// are asked for, processors there are and the system gives, at least the one that runs. Once.
void PrepareVtk(const Talk& talk);

/// Updates an algorithm whose inputs are up to date. Draws a progress bar named `title` on standard
/// error if that is a terminal, sets AbortExecute when the user interrupts, and tells the time if
/// asked to. Throws Failure with the first line of the algorithm's first error, and prints its warnings.
/// `update` replaces algorithm->Update().
void RunPass(vtkAlgorithm* algorithm, const std::string& title, const Talk& talk,
  const std::function<void()>& update = {});

/// Prints "warning: TEXT" on standard error, each text once; nothing with --quiet.
void PrintWarning(const std::string& text, const Talk& talk);
inline void PrintWarning(const Doubt& doubt, const Talk& talk)
{
  PrintWarning(DoubtText(doubt), talk);
}

/// The reason in one of VTK's error texts: what follows "vtkClass (address): ", its first line.
std::string ReasonOf(const std::string& text);

} // namespace skyline

#endif
