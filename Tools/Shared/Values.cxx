// SPDX-License-Identifier: BSD-3-Clause
#include "Values.h"

#include "Shared/NearName.h"

#include <algorithm>
#include <cmath>

namespace skyline
{

std::string WhyNotWithin(const std::string& text, const Limits& limits)
{
  const auto number = ReadNumber(text);
  const std::string cure = std::string("; give ") + limits.Words;
  if (!number)
  {
    return NumberError(text) + cure;
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
    return NumberError(text) + cure;
  }
  if (*number != std::floor(*number))
  {
    return text + " is not a whole number" + cure;
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

} // namespace skyline
