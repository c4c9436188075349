// SPDX-License-Identifier: BSD-3-Clause
// Numbers in texts that users write, such as options and names of skies.
//
// Numbers are decimal with a point, in every locale: 12, -0.5, +3, 1e-3. Hexadecimal numbers, units
// after the number, "inf" and "nan" are not accepted.
#ifndef skyline_NumberText_h
#define skyline_NumberText_h

#include "SkylineCoreModule.h" // for the export macro

#include <optional>
#include <string>
#include <vector>

namespace skyline
{

/// The finite number that the whole text represents; no value for any other text.
SKYLINECORE_EXPORT std::optional<double> ReadNumber(const std::string& text);

/// The finite numbers between separators; no value if any part is not a number.
SKYLINECORE_EXPORT std::optional<std::vector<double>> ReadNumbers(
  const std::string& text, char separator = ',');

/// The reason why ReadNumber refuses a text: "12m is not a number: leave m out; the help names the
/// units".
SKYLINECORE_EXPORT std::string NumberError(const std::string& text);

/// The same for a list of numbers: the reason for the first part that is not a number. Empty if all
/// are numbers.
SKYLINECORE_EXPORT std::string NumbersError(const std::string& text, char separator = ',');

/// A number in the form that messages and the help use.
SKYLINECORE_EXPORT std::string NumberText(double number);

} // namespace skyline

#endif
