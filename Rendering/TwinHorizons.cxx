// SPDX-License-Identifier: BSD-3-Clause
#include "TwinHorizons.h"

#include "TwinPyramid.h"

#include <stdexcept>

namespace skyline
{

std::unique_ptr<TwinHorizons> MakeTwinHorizons(
  TwinDevice& device, HorizonMethodKind method, const TwinLimits& limits)
{
  if (method == HorizonMethodKind::Pyramid)
  {
    return std::make_unique<TwinPyramid>(device, limits);
  }
  throw std::runtime_error("this method has no twin");
}

std::string TwinText(const std::vector<std::string>& parts)
{
  std::string text = "//VTK::System::Dec\n//VTK::Output::Dec\nin vec2 texCoord;\n";
  for (const std::string& part : parts)
  {
    text += part;
  }
  return text;
}

} // namespace skyline
