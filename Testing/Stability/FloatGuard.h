// SPDX-License-Identifier: BSD-3-Clause
// Notices invalid operations, overflows and divisions by zero of the kernels it surrounds.
#ifndef skyline_FloatGuard_h
#define skyline_FloatGuard_h

#include <cfenv>
#include <string>

namespace skyline
{
namespace testing
{

/// Of this thread, from its making on. With SKYLINE_TRAP_FLOATS (preset float-traps) the program stops
/// at the very operation, for a debugger; else Raised() tells afterwards. Only around kernels: a test
/// that compares with NaN raises what it does not mean.
class FloatGuard
{
public:
  static constexpr int Watched = FE_INVALID | FE_OVERFLOW | FE_DIVBYZERO;

  FloatGuard()
  {
    std::feclearexcept(FE_ALL_EXCEPT);
#ifdef SKYLINE_TRAP_FLOATS
    feenableexcept(Watched);
#endif
  }
  ~FloatGuard()
  {
#ifdef SKYLINE_TRAP_FLOATS
    fedisableexcept(Watched);
#endif
    std::feclearexcept(FE_ALL_EXCEPT);
  }
  FloatGuard(const FloatGuard&) = delete;
  FloatGuard& operator=(const FloatGuard&) = delete;

  /// The names of what was raised so far, empty if nothing.
  std::string Raised() const
  {
    const int raised = std::fetestexcept(Watched);
    return std::string((raised & FE_INVALID) != 0 ? "invalid " : "") +
      ((raised & FE_OVERFLOW) != 0 ? "overflow " : "") +
      ((raised & FE_DIVBYZERO) != 0 ? "division by zero " : "");
  }
};

} // namespace testing
} // namespace skyline

#endif
