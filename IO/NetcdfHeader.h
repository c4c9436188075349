// SPDX-License-Identifier: BSD-3-Clause
// The header of a classic netCDF file, before a library believes it.
#ifndef skyline_NetcdfHeader_h
#define skyline_NetcdfHeader_h

#include <string>

namespace skyline
{

/// False where a file begins as a classic netCDF file (CDF-1, 2 and 5) and its header counts more
/// dimensions, attributes, variables or characters than the file has bytes for. libnetcdf (4.9) takes
/// memory for all that is counted, gigabytes for a few kB, and crashes where it gets none. True for
/// every other file, and for one that cannot be read.
///
/// Source: NetCDF Classic Format Specification (Unidata), the file format specifications.
bool NetcdfHeaderFits(const std::string& path);

} // namespace skyline

#endif
