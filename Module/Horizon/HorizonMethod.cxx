// SPDX-License-Identifier: BSD-3-Clause
#include "Horizon/HorizonMethod.h"

#include "Horizon/HorizonExact.h"
#include "Horizon/HorizonPyramid.h"
#include "Horizon/HorizonSweep.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace skyline
{

std::unique_ptr<HorizonMethod> MakeHorizonMethod(const HeightField& field,
  const HorizonSettings& settings, std::shared_ptr<const HeightPyramid> pyramid)
{
  if (!(settings.Tolerance >= 0.0))
  {
    throw std::invalid_argument("the tolerance must be 0 degrees or more");
  }
  HorizonSettings chosen = settings;
  switch (settings.Method)
  {
    case HorizonMethodKind::Sweep:
      if (settings.Shape != Surface::Triangles)
      {
        throw std::invalid_argument(
          "the sweep uses bilinear samples and takes no other surface; use exact or fast");
      }
      return std::make_unique<HorizonSweep>(field, chosen);
    case HorizonMethodKind::Pyramid:
      if (settings.Shape != Surface::Triangles)
      {
        throw std::invalid_argument(
          "the pyramid uses smoothed heights and takes no other surface; use exact or fast");
      }
      return std::make_unique<HorizonPyramid>(field, chosen, std::move(pyramid));
    case HorizonMethodKind::Fast:
      chosen.Tolerance = std::max(settings.Tolerance, FastTolerance);
      break;
    case HorizonMethodKind::Exact:
      break;
  }
  return std::make_unique<HorizonExact>(field, chosen);
}

} // namespace skyline
