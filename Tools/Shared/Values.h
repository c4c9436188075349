// SPDX-License-Identifier: BSD-3-Clause
// The values of options: how the command line reads numbers and names, and says what is wrong with them.
#ifndef skyline_Values_h
#define skyline_Values_h

#include "Shared/NumberText.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <optional>
#include <string>
#include <vector>

namespace skyline
{

/// The numbers that an option takes.
struct Limits
{
  const char* Words; ///< as the message says them: "0 to 90 degrees"
  double Least;      ///< taken, unless LeastOut
  double Most;       ///< taken, unless MostOut
  bool LeastOut = false;
  bool MostOut = false;
};

/// Why `text` is not a number within the limits; empty if it is one.
std::string WhyNotWithin(const std::string& text, const Limits& limits);

/// The same for a whole number.
std::string WhyNotWhole(const std::string& text, int least, int most);

///@{
/// Adds an option that takes one number. Its help shows the value that `target` has now; nothing for
/// one that has none.
CLI::Option* AddNumber(CLI::App& command, const std::string& name, double& target,
  const Limits& limits, const std::string& help);
CLI::Option* AddNumber(CLI::App& command, const std::string& name, std::optional<double>& target,
  const Limits& limits, const std::string& help);
CLI::Option* AddWhole(CLI::App& command, const std::string& name, int& target, int least, int most,
  const std::string& help);
///@}

/// Calls `read`, which reads the text of an option. A std::exception that it throws is what is wrong with
/// the text, and refuses it.
template <typename Read>
void Refusing(const std::string& option, const Read& read)
{
  try
  {
    read();
  }
  catch (const std::exception& reason)
  {
    throw CLI::ValidationError(option, reason.what());
  }
}

/// Adds an option whose text `parse` turns into a value, for `take`; it throws where it cannot.
template <typename Parse, typename Take>
CLI::Option* AddParsed(CLI::App& command, const std::string& name, const Parse& parse,
  const Take& take, const std::string& help)
{
  return command.add_option_function<std::string>(
    name,
    [name, parse, take](const std::string& text) { Refusing(name, [&] { take(parse(text)); }); },
    help);
}

/// A check of an option's text by a function that returns what is wrong, or nothing.
CLI::Validator Checked(std::string (*check)(const std::string&));

/// A check that a text is one of the names.
CLI::Validator OneOf(const std::vector<std::string>& names);

} // namespace skyline

#endif
