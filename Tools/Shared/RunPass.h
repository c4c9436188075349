// SPDX-License-Identifier: BSD-3-Clause
// Runs a pipeline one algorithm at a time. Progress, errors and times are printed as command-line
// programs print them.
#ifndef skyline_RunPass_h
#define skyline_RunPass_h

#include "Shared/Doubt.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <functional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// How much is printed, and how many threads are used.
struct CommonOptions
{
  bool Quiet = false;   ///< no progress bar, no warnings
  bool Verbose = false; ///< passes and their times
  int Threads = 0;      ///< 0: all processors
};

/// Redirects the messages of VTK from the terminal to this program. Sets the number of threads: the
/// number given, but not more than there are processors or than the system allows, and at least 1.
/// To be called once.
void PrepareVtk(const CommonOptions& common);

/// Updates an algorithm whose inputs are up to date. Draws a progress bar named `title` on standard
/// error if that is a terminal, sets AbortExecute when the user interrupts, prints the time with
/// --verbose, and prints the warnings of the algorithm. Throws Failure with the first line of its
/// first error. `update` is called instead of algorithm->Update() if it is given.
void RunPass(vtkAlgorithm* algorithm, const std::string& title, const CommonOptions& common,
  const std::function<void()>& update = {});

/// Prints "warning: TEXT" on standard error, each text once; nothing with --quiet.
void PrintWarning(const std::string& text, const CommonOptions& common);
inline void PrintWarning(const Doubt& doubt, const CommonOptions& common)
{
  PrintWarning(DoubtText(doubt), common);
}

/// Extracts the reason from an error text of VTK: the first line after "vtkClass (address): ".
std::string ReasonOf(const std::string& text);

} // namespace skyline

#endif
