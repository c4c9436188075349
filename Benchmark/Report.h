// SPDX-License-Identifier: BSD-3-Clause
// Writes a session as a page, as a table and as JSON.
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
  std::string Command; ///< the command as typed
};

/// An HTML page without external files: charts, conclusions, all figures, and how they were
/// measured.
std::string ReportPage(const Session& session, const ReportOrigin& origin);

/// A table with one line per finding and all digits. Values that were not measured are empty.
std::string ReportCsv(const Session& session);

/// JSON with the same figures, the machine, the scenes, the omitted measurements and the ratios.
std::string ReportJson(const Session& session, const ReportOrigin& origin);

/// The main chart as a separate picture: horizons on "hills", or on the first scene that has them.
/// Empty if no horizons were measured.
std::string ReportPicture(const Session& session);

/// The text as a quoted JSON string.
std::string JsonText(const std::string& text);

} // namespace benchmark
} // namespace skyline

#endif
