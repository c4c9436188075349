// SPDX-License-Identifier: BSD-3-Clause
// What a session did not measure, the reasons, and how to measure it.
#ifndef skyline_ReportMissing_h
#define skyline_ReportMissing_h

#include "Session.h"

#include <ostream>

namespace skyline
{
namespace benchmark
{

/// A budget in seconds (whole minutes) in which a complete run should end at the speed of this one.
double BudgetForAll(const Session& session);

/// Writes one paragraph for the top of the page that says how much was measured. Writes nothing if
/// all was.
void WriteHowMuch(std::ostream& out, const Session& session);

/// Writes the chapter "Not measured": what failed or is not installed, with the reason, and what
/// there was no time for. Writes nothing if all was measured.
void WriteNotMeasured(std::ostream& out, const Session& session);

} // namespace benchmark
} // namespace skyline

#endif
