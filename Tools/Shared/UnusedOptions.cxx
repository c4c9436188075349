// SPDX-License-Identifier: BSD-3-Clause
#include "UnusedOptions.h"

#include "Failure.h"

#include <CLI/CLI.hpp>

namespace skyline
{

bool UnusedOptions::Given(const std::string& option) const
{
  const CLI::Option* found = this->Command.get_option_no_throw(option);
  return found != nullptr && found->count() > 0;
}

void UnusedOptions::Refuse(
  bool unused, std::initializer_list<const char*> options, const std::string& reason) const
{
  for (const char* option : options)
  {
    if (unused && this->Given(option))
    {
      throw WrongUsage(std::string(option) + ": " + reason);
    }
  }
}

void UnusedOptions::Warn(bool unused, std::initializer_list<const char*> options,
  const std::string& reason, const CommonOptions& common) const
{
  for (const char* option : options)
  {
    if (unused && this->Given(option))
    {
      PrintWarning(
        Doubt{ std::string(option) + " does nothing here: " + reason, "the result without it", "" },
        common);
    }
  }
}

} // namespace skyline
