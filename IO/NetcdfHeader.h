// SPDX-License-Identifier: BSD-3-Clause
// A check of the header of a classic netCDF file before a library reads it.
#ifndef skyline_NetcdfHeader_h
#define skyline_NetcdfHeader_h

#include <string>

namespace skyline
{

/// Returns false if a file begins as a classic netCDF file (CDF-1, 2 or 5) and its header declares
/// more dimensions, attributes, variables or characters than the file has bytes for. libnetcdf
/// (4.9) allocates memory for all that is declared, gigabytes for a file of a few kB, and crashes
/// if it gets none. Returns true for every other file, and for a file that cannot be read.
///
/// Source: NetCDF Classic Format Specification (Unidata), the file format specifications.
bool NetcdfHeaderFits(const std::string& path);

} // namespace skyline

#endif
