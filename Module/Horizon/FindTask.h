// SPDX-License-Identifier: BSD-3-Clause
// The arguments of HorizonMethod::Find in the form that the vector code needs.
#ifndef skyline_FindTask_h
#define skyline_FindTask_h

#include "HeightField/HeightField.h"
#include "Horizon/RayFrame.h"

#include <cstddef>
#include <vector>

namespace skyline
{

struct FindTask
{
  FindTask(const HeightField& field, const RayFrame& frame, std::ptrdiff_t lineBegin,
    std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin, std::ptrdiff_t laneEnd, float* slopes,
    std::ptrdiff_t stride)
    : LineBegin(lineBegin)
    , LineEnd(lineEnd)
    , LaneBegin(laneBegin)
    , LaneEnd(laneEnd)
    , Slopes(slopes)
    , Stride(stride)
    , Receivers(static_cast<std::size_t>(lineEnd - lineBegin))
    , Buffers(Receivers.size())
  {
    for (std::size_t i = 0; i < this->Receivers.size(); ++i)
    {
      const std::ptrdiff_t line = lineBegin + static_cast<std::ptrdiff_t>(i);
      this->Receivers[i] = field.Receivers(frame.Columns, frame.ImageLine(line), this->Buffers[i]);
    }
  }

  std::ptrdiff_t LineBegin, LineEnd, LaneBegin, LaneEnd;
  float* Slopes;
  std::ptrdiff_t Stride;
  std::vector<const float*> Receivers; ///< heights of the receivers, one pointer per line

private:
  std::vector<std::vector<float>> Buffers; // for lines whose receivers differ from the posts that
                                           // occlude
};

} // namespace skyline

#endif
