// SPDX-License-Identifier: BSD-3-Clause
#include "ShaderText.h"

#include <sstream>

namespace skyline
{

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
      text += line + "\n";
    }
  }
  return text;
}

} // namespace skyline
