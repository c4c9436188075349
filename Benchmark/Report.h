// SPDX-License-Identifier: BSD-3-Clause
// A session as one page, as a table and for machines.
#ifndef skyline_Report_h
#define skyline_Report_h

#include "Session.h"

#include <string>

namespace skyline
{
namespace benchmark
{

/// How the session was made.
struct ReportOrigin
{
  std::string Program; ///< name and version, "skyline 0.2.0"
  std::string Command; ///< as typed
};

/// HTML that needs nothing else: charts, what they say, every figure, how it was measured.
std::string ReportPage(const Session& session, const ReportOrigin& origin);

/// A line a finding, all digits, empty where nothing was measured.
std::string ReportCsv(const Session& session);

/// The same with the machine, the scenes, what was left out and the ratios.
std::string ReportJson(const Session& session, const ReportOrigin& origin);

/// The main chart as a picture of its own: horizons on "hills", else on the first scene that has
/// them. Empty if no horizons were measured.
std::string ReportPicture(const Session& session);

/// JSON text, quoted.
std::string JsonText(const std::string& text);

} // namespace benchmark
} // namespace skyline

#endif
