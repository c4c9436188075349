// SPDX-License-Identifier: BSD-3-Clause
// Numbers in texts that users write: options, names of skies.
//
// Numbers are decimal with a point, in every locale: 12, -0.5, +3, 1e-3. No hexadecimal, no unit behind
// the number, no "inf" or "nan".
#ifndef skyline_NumberText_h
#define skyline_NumberText_h

#include "SkylineCoreModule.h" // for the export macro

#include <optional>
#include <string>
#include <vector>

namespace skyline
{

/// The finite number that the whole text is; none for any other text.
SKYLINECORE_EXPORT std::optional<double> ReadNumber(const std::string& text);

/// The finite numbers between separators; none if any part is no number.
SKYLINECORE_EXPORT std::optional<std::vector<double>> ReadNumbers(
  const std::string& text, char separator = ',');

/// What is wrong with a text that ReadNumber refuses: "12m is no number: leave m out, units are told in
/// the help".
SKYLINECORE_EXPORT std::string WhyNoNumber(const std::string& text);

/// The same for a list of numbers: what is wrong with the first part that is no number; empty: nothing.
SKYLINECORE_EXPORT std::string WhyNoNumbers(const std::string& text, char separator = ',');

/// A number as messages and help show it.
SKYLINECORE_EXPORT std::string NumberText(double number);

} // namespace skyline

#endif
