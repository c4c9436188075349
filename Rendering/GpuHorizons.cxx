// SPDX-License-Identifier: BSD-3-Clause
#include "GpuHorizons.h"

#include "GpuExact.h"
#include "GpuPyramid.h"

namespace skyline
{

std::unique_ptr<GpuHorizons> MakeGpuHorizons(
  GpuDevice& device, HorizonMethodKind method, const GpuLimits& limits)
{
  if (method == HorizonMethodKind::Pyramid)
  {
    return std::make_unique<GpuPyramid>(device, limits);
  }
  return std::make_unique<GpuExact>(device, limits);
}

std::string GpuText(const std::vector<std::string>& parts)
{
  std::string text = "//VTK::System::Dec\n//VTK::Output::Dec\nin vec2 texCoord;\n";
  for (const std::string& part : parts)
  {
    text += part;
  }
  return text;
}

} // namespace skyline
