// SPDX-License-Identifier: BSD-3-Clause
// Finds horizons with plain loops over each crossed edge. The savings of other methods are counted
// from it.
#ifndef skyline_EveryCrossing_h
#define skyline_EveryCrossing_h

#include "Horizon/HorizonMethod.h"

namespace skyline
{
namespace benchmark
{

/// The computation of the oracle in float: each edge up to the end of the data, with none skipped,
/// for a row of receivers at once so that the compiler can vectorise. Triangles only.
class EveryCrossing : public HorizonMethod
{
public:
  EveryCrossing(const HeightField& field, const HorizonSettings& settings);

  void SetAzimuth(const Grid& grid, double azimuth) override;
  std::ptrdiff_t PrepareCount() const override { return 0; }
  void Prepare(std::ptrdiff_t, std::ptrdiff_t) override {}
  void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* slopes, std::ptrdiff_t stride) const override;

private:
  const HeightField& Field;
  HorizonSettings Settings;
};

} // namespace benchmark
} // namespace skyline

#endif
