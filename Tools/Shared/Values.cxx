// SPDX-License-Identifier: BSD-3-Clause
#include "Values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>

namespace
{

// The number at the start of a text, and how many letters it takes. std::from_chars knows no locale,
// and no hexadecimal.
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

// How many letters must be put in, left out, changed or swapped with their neighbour to make one word
// of the other.
std::size_t Distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> before;
  std::vector<std::size_t> last(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{ 0 });
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::vector<std::size_t> row(b.size() + 1, i);
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({ row[j - 1] + 1, last[j] + 1, change });
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
      {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = std::exchange(last, row);
  }
  return last[b.size()];
}

} // namespace

namespace skyline
{

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

std::string WhyNoNumber(const std::string& text)
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
    return text + " is no number: write " + pointed + ", with a point";
  }
  if (error != std::errc() || !std::isfinite(number))
  {
    return text + " is no number";
  }
  const std::string behind = text.substr(length);
  const bool unit = std::all_of(behind.begin(), behind.end(),
    [](unsigned char letter) { return std::isalpha(letter) || letter >= 128 || letter == '%'; });
  return text + " is no number" +
    (unit && behind[0] != 'x' && behind[0] != 'X'
        ? ": leave " + behind + " out, units are told in the help"
        : "");
}

std::string WhyNoNumbers(const std::string& text, char separator)
{
  for (const std::string& part : Split(text, separator))
  {
    if (!ReadNumber(part))
    {
      return part.empty() ? text + " has an empty place" : WhyNoNumber(part);
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

std::string WhyNotWithin(const std::string& text, const Limits& limits)
{
  const auto number = ReadNumber(text);
  const std::string cure = std::string("; give ") + limits.Words;
  if (!number)
  {
    return WhyNoNumber(text) + cure;
  }
  const bool low = limits.LeastOut ? *number <= limits.Least : *number < limits.Least;
  const bool high = limits.MostOut ? *number >= limits.Most : *number > limits.Most;
  return low || high ? text + " is out of range" + cure : "";
}

std::string WhyNotWhole(const std::string& text, int least, int most)
{
  const std::string cure =
    "; give a whole number from " + std::to_string(least) + " to " + std::to_string(most);
  const auto number = ReadNumber(text);
  if (!number)
  {
    return WhyNoNumber(text) + cure;
  }
  if (*number != std::floor(*number))
  {
    return text + " is no whole number" + cure;
  }
  return *number < least || *number > most ? text + " is out of range" + cure : "";
}

CLI::Option* AddNumber(CLI::App& command, const std::string& name, double& target,
  const Limits& limits, const std::string& help)
{
  return command
    .add_option_function<std::string>(
      name, [&target](const std::string& text) { target = *ReadNumber(text); }, help)
    ->check(CLI::Validator([limits](std::string& text) { return WhyNotWithin(text, limits); }, ""))
    ->default_str(NumberText(target));
}

CLI::Option* AddNumber(CLI::App& command, const std::string& name, std::optional<double>& target,
  const Limits& limits, const std::string& help)
{
  return command
    .add_option_function<std::string>(
      name, [&target](const std::string& text) { target = ReadNumber(text); }, help)
    ->check(CLI::Validator([limits](std::string& text) { return WhyNotWithin(text, limits); }, ""));
}

CLI::Option* AddWhole(CLI::App& command, const std::string& name, int& target, int least, int most,
  const std::string& help)
{
  return command
    .add_option_function<std::string>(
      name, [&target](const std::string& text) { target = static_cast<int>(*ReadNumber(text)); },
      help)
    ->check(CLI::Validator(
      [least, most](std::string& text) { return WhyNotWhole(text, least, most); }, ""))
    ->default_str(std::to_string(target));
}

CLI::Validator Checked(std::string (*check)(const std::string&))
{
  return CLI::Validator([check](std::string& text) { return check(text); }, "");
}

CLI::Validator OneOf(const std::vector<std::string>& names)
{
  std::string all;
  for (const std::string& name : names)
  {
    all += (all.empty() ? "" : ",") + name;
  }
  return CLI::Validator(
    [names, all](std::string& text)
    {
      return std::find(names.begin(), names.end(), text) != names.end()
        ? std::string()
        : text + " is not one of " + all + DidYouMean(text, names);
    },
    "{" + all + "}");
}

std::string Nearest(const std::string& word, const std::vector<std::string>& names)
{
  std::string best;
  // A third of the letters may be wrong: "skyview" is sky-view, "--colours" is --colors.
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& name : names)
  {
    const std::size_t distance = Distance(word, name);
    // What was cut short is near, however much is missing.
    const bool start = word.size() >= 3 && name.rfind(word, 0) == 0;
    if (std::min(distance, start ? std::size_t{ 1 } : distance) < least)
    {
      least = start ? 1 : distance;
      best = name;
    }
  }
  return best;
}

std::string DidYouMean(const std::string& word, const std::vector<std::string>& names)
{
  const std::string name = Nearest(word, names);
  return name.empty() ? "" : "; did you mean " + name + "?";
}

} // namespace skyline
