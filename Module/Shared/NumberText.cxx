// SPDX-License-Identifier: BSD-3-Clause
#include "Shared/NumberText.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>
#include <system_error>

namespace skyline
{

namespace
{

// Reads the number at the start of a text and sets its length. std::from_chars does not depend on
// the locale and reads no hexadecimal numbers here.
std::errc ReadStart(const std::string& text, double& number, std::size_t& length)
{
  const std::size_t plus = text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0;
  const char* begin = text.data() + plus;
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), number);
  length = static_cast<std::size_t>(end - text.data());
  return error;
}

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1)
  {
    end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
  }
  return parts;
}

} // namespace

std::optional<double> ReadNumber(const std::string& text)
{
  double number = 0.0;
  std::size_t length = 0;
  const std::errc error = ReadStart(text, number, length);
  if (error != std::errc() || length != text.size() || !std::isfinite(number))
  {
    return std::nullopt;
  }
  return number;
}

std::optional<std::vector<double>> ReadNumbers(const std::string& text, char separator)
{
  std::vector<double> numbers;
  for (const std::string& part : Split(text, separator))
  {
    const auto number = ReadNumber(part);
    if (!number)
    {
      return std::nullopt;
    }
    numbers.push_back(*number);
  }
  return numbers;
}

std::string NumberError(const std::string& text)
{
  double number = 0.0;
  std::size_t length = 0;
  const std::errc error = ReadStart(text, number, length);
  std::string pointed = text;
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  if (error == std::errc::result_out_of_range)
  {
    return text + " is too large or too small for a number";
  }
  if (pointed != text && ReadNumber(pointed))
  {
    return text + " is not a number: write " + pointed + ", with a point";
  }
  if (error != std::errc() || !std::isfinite(number))
  {
    return text + " is not a number";
  }
  const std::string behind = text.substr(length);
  const bool unit = std::all_of(behind.begin(), behind.end(),
    [](unsigned char letter) { return std::isalpha(letter) || letter >= 128 || letter == '%'; });
  return text + " is not a number" +
    (unit && behind[0] != 'x' && behind[0] != 'X'
        ? ": leave " + behind + " out; the help names the units"
        : "");
}

std::string NumbersError(const std::string& text, char separator)
{
  for (const std::string& part : Split(text, separator))
  {
    if (!ReadNumber(part))
    {
      return part.empty() ? text + " has an empty part" : NumberError(part);
    }
  }
  return "";
}

std::string NumberText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

} // namespace skyline
