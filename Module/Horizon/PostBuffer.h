// SPDX-License-Identifier: BSD-3-Clause
// Memory for the results of an accumulator.
#ifndef skyline_PostBuffer_h
#define skyline_PostBuffer_h

#include <cstddef>

namespace skyline
{

/// One float per post, owned by the caller: post (column, row) is Values[(row * columns + column) *
/// Stride]. If Values is null, the quantity is not computed.
struct PostBuffer
{
  float* Values = nullptr;
  std::ptrdiff_t Stride = 1; ///< floats from one post to the next, 1 or more
};

} // namespace skyline

#endif
