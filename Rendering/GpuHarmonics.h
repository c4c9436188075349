// SPDX-License-Identifier: BSD-3-Clause
// Visibility and transfer as spherical harmonics on the graphics processor: the counterpart of
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

/// Seconds that each pass took. Measured only if Wanted is true, because the program must then wait
/// for the end of each pass.
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

  /// Empty, or the reason why the graphics processor cannot compute with these settings.
  static std::string UnsupportedSetting(const HorizonSettings& settings);

  struct Task
  {
    int Bands = 4;
    const std::vector<double>* Azimuths = nullptr; ///< radians
    double Width = 0.0;                            ///< radians, of each swath
    /// Gradients dz/dx and dz/dy for the transfer; null for the visibility.
    const float* East = nullptr;
    const float* North = nullptr;
    float* Values = nullptr; ///< bands^2 per post; null if only the images are needed
  };

  /// Loads the surface of the scene. Returns whether the field fits into one texture. To be called
  /// before each Run.
  bool FitsOneTile(HorizonDriver& driver);

  /// Returns false if the run was cancelled. Throws std::runtime_error with a reason of one line.
  bool Run(HorizonDriver& driver, const Task& task);

  /// Stores the horizons of all posts in degrees, one component per azimuth (radians): the
  /// counterpart of StoreAccumulator.
  bool Store(HorizonDriver& driver, const std::vector<double>& azimuths, float* degrees);

  /// After a run without tiles: image i holds the coefficients 4 i to 4 i + 3 of each post.
  const std::vector<GpuTexture>& Images() const { return this->Sums; }

  /// The irradiance of each post in an image with four components: the product of the coefficients
  /// in Images and those of a light. coefficients: bands^2 each for red, green and blue.
  GpuTexture Light(const std::vector<double>& coefficients);

  /// Reads all texels of such an image, four floats each.
  void ReadImage(vtkTextureObject* image, float* texels);

  GpuTimes Times;

private:
  class StageTimer;
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
  std::vector<std::unique_ptr<GpuPass>> Wedges; // one for each group of 32 coefficients
  std::vector<GpuTexture> Sums;
  GpuTexture Angles, Gradients, Lit;
  std::unique_ptr<GpuPass> Lighting;
  std::size_t LitImages = 0;
};

} // namespace skyline

#endif
