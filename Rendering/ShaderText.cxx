// SPDX-License-Identifier: BSD-3-Clause
#include "ShaderText.h"

#include "Shared/Constants.h"

#include <iomanip>
#include <limits>
#include <sstream>

namespace skyline
{

namespace
{

/// Replaces a placeholder by the numbers that C++ and GLSL share. Other lines are returned
/// unchanged.
std::string Filled(const std::string& line)
{
  std::ostringstream text;
  text << std::scientific << std::setprecision(std::numeric_limits<float>::max_digits10);
  if (line == "//Fill::Pi")
  {
    text << "const float SkylinePi = " << Pi << ";";
  }
  else if (line == "//Fill::AngleTerms")
  {
    text << "const float AngleTerms[8] = float[8](";
    for (const float& term : AngleTerms)
    {
      text << (&term == AngleTerms ? "" : ", ") << term;
    }
    text << ");";
  }
  else
  {
    text << line;
  }
  return text.str();
}

} // namespace

std::string ShaderPart(const char* file, const std::string& part)
{
  const std::string begin = "//Skyline::";
  std::istringstream lines(file);
  std::string text;
  std::string current;
  for (std::string line; std::getline(lines, line);)
  {
    if (line.compare(0, begin.size(), begin) == 0)
    {
      current = line.substr(begin.size());
      continue;
    }
    const std::size_t first = line.find_first_not_of(' ');
    const bool comment = first != std::string::npos && line.compare(first, 2, "//") == 0 &&
      line.compare(first, 8, "//Fill::") != 0;
    if (current == part && !comment)
    {
      text += Filled(line) + "\n";
    }
  }
  return text;
}

} // namespace skyline
