// SPDX-License-Identifier: BSD-3-Clause
// What a session did not measure, why, and how to get it.
#ifndef skyline_ReportMissing_h
#define skyline_ReportMissing_h

#include "Session.h"

#include <ostream>

namespace skyline
{
namespace benchmark
{

/// A budget, whole minutes in seconds, within which a run like this one should end: at this run's pace.
double BudgetForAll(const Session& session);

/// One paragraph for the top of a page: how much was measured. Nothing if all was.
void WriteHowMuch(std::ostream& out, const Session& session);

/// The chapter "Not measured": what failed or is not installed, with the reason, and what time was too
/// short for. Nothing if all was measured.
void WriteNotMeasured(std::ostream& out, const Session& session);

} // namespace benchmark
} // namespace skyline

#endif
