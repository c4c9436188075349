// SPDX-License-Identifier: BSD-3-Clause
// Exceptions that stop a command.
#ifndef skyline_Failure_h
#define skyline_Failure_h

#include <stdexcept>
#include <string>

namespace skyline
{

/// A failure. Its text has one line and tells the user what to do. The program prints it and exits
/// with 1.
class Failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// An error of the command line itself, whatever the files contain: a value out of range, or
/// options that cannot be combined. The program prints the text with a hint to the help of the
/// command, and exits with 2.
class WrongUsage : public Failure
{
public:
  using Failure::Failure;
};

} // namespace skyline

#endif
