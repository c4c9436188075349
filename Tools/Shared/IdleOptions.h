// SPDX-License-Identifier: BSD-3-Clause
// Options that cannot act with the others are refused, so that nobody believes they did.
#ifndef skyline_IdleOptions_h
#define skyline_IdleOptions_h

#include "Passes.h"

#include <CLI/CLI.hpp>

#include <initializer_list>
#include <string>

namespace skyline
{

/// The options of one command line, after it was read and before any work.
class IdleOptions
{
public:
  explicit IdleOptions(const CLI::App& command)
    : Command(command)
  {
  }

  /// Whether the user gave the option; false for one that the command does not have.
  bool Given(const std::string& option) const;

  /// Throws WrongUsage if `idle` and the user gave one of the options: "OPTION: REASON".
  void Refuse(
    bool idle, std::initializer_list<const char*> options, const std::string& reason) const;

  /// Prints a warning instead: what such an option asks for is what happens anyway, or all that can.
  void Warn(bool idle, std::initializer_list<const char*> options, const std::string& reason,
    const Talk& talk) const;

private:
  const CLI::App& Command;
};

} // namespace skyline

#endif
