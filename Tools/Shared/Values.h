// SPDX-License-Identifier: BSD-3-Clause
// The values of options: every number, list of numbers and name on the command line is read here.
//
// Numbers are decimal with a point, in every locale: 12, -0.5, +3, 1e-3. No hexadecimal, no unit behind
// the number, no "inf" or "nan".
#ifndef skyline_Values_h
#define skyline_Values_h

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace skyline
{

/// The finite number that the whole text is; none for any other text.
std::optional<double> ReadNumber(const std::string& text);

/// The finite numbers between separators; none if any part is no number.
std::optional<std::vector<double>> ReadNumbers(const std::string& text, char separator = ',');

/// What is wrong with a text that ReadNumber refuses: "12m is no number: leave m out, units are told in
/// the help".
std::string WhyNoNumber(const std::string& text);

/// The same for a list of numbers: what is wrong with the first part that is no number; empty: nothing.
std::string WhyNoNumbers(const std::string& text, char separator = ',');

/// A number as messages and help show it.
std::string NumberText(double number);

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

/// A check of an option's text by a function that returns what is wrong, or nothing.
CLI::Validator Checked(std::string (*check)(const std::string&));

/// A check that a text is one of the names.
CLI::Validator OneOf(const std::vector<std::string>& names);

/// Of `names`, that which `word` was probably meant to be; empty if none is near.
std::string Nearest(const std::string& word, const std::vector<std::string>& names);

/// "; did you mean NAME?", or nothing.
std::string DidYouMean(const std::string& word, const std::vector<std::string>& names);

} // namespace skyline

#endif
