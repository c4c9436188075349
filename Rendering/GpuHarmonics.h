// SPDX-License-Identifier: BSD-3-Clause
// Visibility and transfer as spherical harmonics on the graphics processor: gpu of
// VisibilityAccumulator.
#ifndef skyline_GpuHarmonics_h
#define skyline_GpuHarmonics_h

#include "GpuHorizons.h"

#include <memory>
#include <string>
#include <vector>

namespace skyline
{

class HorizonDriver;

/// Seconds of the passes; measured if Wanted, for that waits for each of them.
struct GpuTimes
{
  bool Wanted = false;
  double Load = 0.0, Horizons = 0.0, Wedges = 0.0, Light = 0.0, Read = 0.0;
};

class GpuHarmonics
{
public:
  GpuHarmonics(GpuDevice& device, const GpuLimits& limits);
  ~GpuHarmonics();

  /// Nothing, or why the graphics processor has no counterpart of these settings.
  static std::string Unknown(const HorizonSettings& settings);

  struct Task
  {
    int Bands = 4;
    const std::vector<double>* Azimuths = nullptr; ///< degrees
    double Width = 0.0;                            ///< radians, of each
    const float* East = nullptr;                   ///< gradients: transfer; null: visibility
    const float* North = nullptr;
    float* Values = nullptr; ///< bands^2 a post; null: only the images are wanted
  };

  /// Loads the scene's surface, and says whether one texture holds it. To be called before each Run.
  bool FitsOneTile(HorizonDriver& driver);

  /// False if stopped. Fails with std::runtime_error in one line.
  bool Run(HorizonDriver& driver, const Task& task);

  /// Horizons in degrees of all posts, a component an azimuth (degrees): counterpart of StoreAccumulator.
  bool Store(HorizonDriver& driver, const std::vector<double>& azimuths, float* degrees);

  /// After a run of one tile: coefficients 4 i .. 4 i + 3 of every post.
  const std::vector<GpuTexture>& Images() const { return this->Sums; }

  /// The irradiance of every post in an image of four components: the coefficients of Images, times the
  /// light's: bands^2 of red, of green, of blue.
  GpuTexture Light(const std::vector<double>& coefficients);

  /// All texels of such an image, four floats each.
  void ReadImage(vtkTextureObject* image, float* texels);

  GpuTimes Times;

private:
  class Lap;
  bool SumTile(
    HorizonDriver& driver, const Task& task, const GpuArea& tile, double begin, double end);
  std::vector<GpuArea> Tiles(const Grid& grid) const;
  void FindRows(HorizonDriver& driver, const GpuArea& tile, const std::vector<double>& azimuths,
    vtkTextureObject* angles);
  void Prepare(const Task& task, const GpuArea& tile);
  void ReadTile(HorizonDriver& driver, const Task& task, const GpuArea& tile);

  GpuDevice& Device;
  GpuLimits Limits;
  HorizonMethodKind Method = HorizonMethodKind::Exact;
  std::unique_ptr<GpuHorizons> Horizons;
  std::ptrdiff_t Columns = 0; // of the field
  int Bands = 0;
  bool Transfer = false;
  int Side = 0;                                 // of tiles
  int Width = 0, Height = 0;                    // of the images
  std::vector<std::unique_ptr<GpuPass>> Wedges; // of 32 coefficients each
  std::vector<GpuTexture> Sums;
  GpuTexture Angles, Gradients, Lit;
  std::unique_ptr<GpuPass> Lighting;
  std::size_t LitImages = 0;
};

} // namespace skyline

#endif
