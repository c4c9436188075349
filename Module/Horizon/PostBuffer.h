// SPDX-License-Identifier: BSD-3-Clause
// Where an accumulator's results go.
#ifndef skyline_PostBuffer_h
#define skyline_PostBuffer_h

#include <cstddef>

namespace skyline
{

/// A float for every post, owned by the caller: post (column, row) is
/// Values[(row * columns + column) * Stride]. Without values the quantity is not computed.
struct PostBuffer
{
  float* Values = nullptr;
  std::ptrdiff_t Stride = 1; ///< floats from a post to the next, 1 or more
};

} // namespace skyline

#endif
