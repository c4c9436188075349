// SPDX-License-Identifier: BSD-3-Clause
#include "TwinHorizons.h"

#include "TwinExact.h"
#include "TwinPyramid.h"

namespace skyline
{

std::unique_ptr<TwinHorizons> MakeTwinHorizons(
  TwinDevice& device, HorizonMethodKind method, const TwinLimits& limits)
{
  if (method == HorizonMethodKind::Pyramid)
  {
    return std::make_unique<TwinPyramid>(device, limits);
  }
  return std::make_unique<TwinExact>(device, limits);
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
