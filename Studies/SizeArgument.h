// SPDX-License-Identifier: BSD-3-Clause
// A size on the command line of a study.
#ifndef skyline_SizeArgument_h
#define skyline_SizeArgument_h

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>

namespace skyline
{

/// The whole number in argv[index]; `otherwise` if there is no such argument; -1 for other text.
inline int SizeArgument(int argc, char** argv, int index, int otherwise)
{
  if (index >= argc)
  {
    return otherwise;
  }
  const std::string text = argv[index];
  if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos)
  {
    return -1;
  }
  const long number = std::strtol(text.c_str(), nullptr, 10);
  return static_cast<int>(std::min<long>(number, std::numeric_limits<int>::max()));
}

} // namespace skyline

#endif
