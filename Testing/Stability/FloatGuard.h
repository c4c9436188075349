// SPDX-License-Identifier: BSD-3-Clause
// Detects invalid operations, overflows and divisions by zero in the kernels that run during its
// lifetime.
#ifndef skyline_FloatGuard_h
#define skyline_FloatGuard_h

#include <cfenv>
#include <string>

namespace skyline
{
namespace testing
{

/// Watches the current thread. With SKYLINE_TRAP_FLOATS (the preset float-traps) the program stops
/// at the operation itself, for a debugger; otherwise Raised() reports it afterwards. To be used
/// around kernels only, because tests that compare with NaN raise exceptions intentionally.
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

  /// The names of the exceptions raised so far; empty if there are none.
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
