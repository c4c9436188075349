// SPDX-License-Identifier: BSD-3-Clause
// The values of options: how numbers and names are parsed, and the messages for wrong ones.
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

/// The range of numbers that an option accepts.
struct Limits
{
  const char* Words; ///< for messages: "0 to 90 degrees"
  double Least;      ///< accepted unless LeastOut
  double Most;       ///< accepted unless MostOut
  bool LeastOut = false;
  bool MostOut = false;
};

/// Returns why `text` is not a number within the limits; empty if it is one.
std::string WhyNotWithin(const std::string& text, const Limits& limits);

/// The same for a whole number.
std::string WhyNotWhole(const std::string& text, int least, int most);

///@{
/// Adds an option that takes one number. Its help shows the present value of `target`, if there is
/// one.
CLI::Option* AddNumber(CLI::App& command, const std::string& name, double& target,
  const Limits& limits, const std::string& help);
CLI::Option* AddNumber(CLI::App& command, const std::string& name, std::optional<double>& target,
  const Limits& limits, const std::string& help);
CLI::Option* AddWhole(CLI::App& command, const std::string& name, int& target, int least, int most,
  const std::string& help);
///@}

/// Calls `read`, which parses the text of an option. The text of a std::exception that it throws is
/// the error message of the option.
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

/// Adds an option. `parse` converts its text to a value, which `take` gets; it throws for wrong
/// texts.
template <typename Parse, typename Take>
CLI::Option* AddParsed(CLI::App& command, const std::string& name, const Parse& parse,
  const Take& take, const std::string& help)
{
  return command.add_option_function<std::string>(
    name,
    [name, parse, take](const std::string& text) { Refusing(name, [&] { take(parse(text)); }); },
    help);
}

/// Makes a check of the text of an option from a function that returns the error, or an empty text.
CLI::Validator Checked(std::string (*check)(const std::string&));

/// Makes a check that a text is one of the names.
CLI::Validator OneOf(const std::vector<std::string>& names);

} // namespace skyline

#endif
