// SPDX-License-Identifier: BSD-3-Clause
// Extracts the reason from the text of a VTK error.
#ifndef skyline_ErrorReason_h
#define skyline_ErrorReason_h

#include <algorithm>
#include <string>

namespace skyline
{

/// The reason in a report of vtkErrorMacro or vtkWarningMacro, without the position in the source
/// and the address of the object that precede it and the empty lines that follow it. A text without
/// these is returned unchanged.
inline std::string ErrorReason(const std::string& report)
{
  constexpr const char* blank = " \t\r\n";
  const std::size_t object = report.find("): ");
  const std::size_t place = object == std::string::npos ? 0 : object + 3;
  const std::size_t begin = std::min(report.find_first_not_of(blank, place), report.size());
  return report.substr(begin, report.find_last_not_of(blank) + 1 - begin);
}

} // namespace skyline

#endif
