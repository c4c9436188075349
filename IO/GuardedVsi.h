// SPDX-License-Identifier: BSD-3-Clause
// GDAL's file systems, observed while a SourceGuard exists.
#ifndef skyline_GuardedVsi_h
#define skyline_GuardedVsi_h

namespace skyline
{

/// Between the first AcquireVsi and the last ReleaseVsi, the SourceGuard of a thread is asked about
/// each file that GDAL opens in that thread. Threads without a SourceGuard are not affected.
void AcquireVsi();
void ReleaseVsi();

} // namespace skyline

#endif
