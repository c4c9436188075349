// SPDX-License-Identifier: BSD-3-Clause
// How a command stops early.
#ifndef skyline_Failure_h
#define skyline_Failure_h

#include <stdexcept>
#include <string>

namespace skyline
{

/// A reason that the user can act on, in one line. The program prints it and exits with 1.
class Failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The command line itself is wrong, whatever the files hold: a value out of range, or options that do
/// not go together. The program prints the reason with the command whose help tells more, and exits
/// with 2.
class WrongUsage : public Failure
{
public:
  using Failure::Failure;
};

} // namespace skyline

#endif
