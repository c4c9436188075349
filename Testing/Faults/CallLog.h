// SPDX-License-Identifier: BSD-3-Clause
// A log of what a program asked the system for: files that it opened, places that it wanted to reach.
#ifndef skyline_CallLog_h
#define skyline_CallLog_h

namespace skyline
{
namespace testing
{

/// Appends "WHAT NAME" as a line to the file named by SKYLINE_CALL_LOG; nothing without that variable.
/// Calls the kernel alone, so that it may stand inside any call that it tells of.
void LogCall(const char* what, const char* name) noexcept;

} // namespace testing
} // namespace skyline

#endif
