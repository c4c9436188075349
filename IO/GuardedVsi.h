// SPDX-License-Identifier: BSD-3-Clause
// GDAL's file systems, watched while a SourceGuard lives.
#ifndef skyline_GuardedVsi_h
#define skyline_GuardedVsi_h

namespace skyline
{

/// From the first AcquireVsi to the last ReleaseVsi every file that GDAL touches in a thread with a
/// SourceGuard is put to that guard first; in other threads nothing changes.
void AcquireVsi();
void ReleaseVsi();

} // namespace skyline

#endif
