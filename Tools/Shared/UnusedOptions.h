// SPDX-License-Identifier: BSD-3-Clause
// Refuses options that have no effect together with the other options.
#ifndef skyline_UnusedOptions_h
#define skyline_UnusedOptions_h

#include "RunPass.h"

#include <initializer_list>
#include <string>

namespace CLI
{
class App;
}

namespace skyline
{

/// The options of one command line, after it was parsed and before any work.
class UnusedOptions
{
public:
  explicit UnusedOptions(const CLI::App& command)
    : Command(command)
  {
  }

  /// Returns whether the user gave the option; false if the command does not have it.
  bool Given(const std::string& option) const;

  /// Throws WrongUsage with "OPTION: REASON" if `unused` is true and the user gave one of the
  /// options.
  void Refuse(
    bool unused, std::initializer_list<const char*> options, const std::string& reason) const;

  /// Prints a warning instead, for an option without effect whose absence gives the same result.
  void Warn(bool unused, std::initializer_list<const char*> options, const std::string& reason,
    const CommonOptions& common) const;

private:
  const CLI::App& Command;
};

} // namespace skyline

#endif
