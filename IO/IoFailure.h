// SPDX-License-Identifier: BSD-3-Clause
// Why a file could not be read or written, passed from the file code to the VTK class.
#ifndef skyline_IoFailure_h
#define skyline_IoFailure_h

#include "SkylineIOModule.h" // for the export macro

#include <stdexcept>
#include <string>

namespace skyline
{

/// A one-line reason that names the file, the value and the remedy, with a vtkErrorCode.
class SKYLINEIO_EXPORT IoFailure : public std::runtime_error
{
public:
  IoFailure(unsigned long code, const std::string& reason)
    : std::runtime_error(reason)
    , Code(code)
  {
  }

  unsigned long GetCode() const { return this->Code; }

private:
  unsigned long Code;
};

/// The user asked to stop (AbortExecute). This is no error, but there is no result.
class SKYLINEIO_EXPORT IoAborted : public std::runtime_error
{
public:
  IoAborted()
    : std::runtime_error("aborted")
  {
  }
};

/// The text up to its first line break.
inline std::string FirstLine(const std::string& text)
{
  return text.substr(0, text.find_first_of("\r\n"));
}

} // namespace skyline

#endif
