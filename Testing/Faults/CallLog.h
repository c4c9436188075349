// SPDX-License-Identifier: BSD-3-Clause
// A log of the files that a program opens and of the network addresses that it tries to reach.
#ifndef skyline_CallLog_h
#define skyline_CallLog_h

namespace skyline
{
namespace testing
{

/// Appends the line "WHAT NAME" to the file that SKYLINE_CALL_LOG names; does nothing without that
/// variable. Uses system calls only, so that it can be called inside any function that it logs.
void LogCall(const char* what, const char* name) noexcept;

} // namespace testing
} // namespace skyline

#endif
