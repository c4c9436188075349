// SPDX-License-Identifier: BSD-3-Clause
// Visibility and transfer as spherical harmonics on the graphics processor: twin of
// VisibilityAccumulator.
#ifndef skyline_TwinHarmonics_h
#define skyline_TwinHarmonics_h

#include "TwinHorizons.h"

#include <memory>
#include <string>
#include <vector>

namespace skyline
{

class HorizonScene;

/// Seconds of the passes; measured if Wanted, for that waits for each of them.
struct TwinTimes
{
  bool Wanted = false;
  double Load = 0.0, Horizons = 0.0, Wedges = 0.0, Light = 0.0, Read = 0.0;
};

class TwinHarmonics
{
public:
  TwinHarmonics(TwinDevice& device, const TwinLimits& limits);
  ~TwinHarmonics();

  /// Nothing, or why the graphics processor has no twin of these settings.
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
  bool FitsOneTile(HorizonScene& scene);

  /// False if stopped. Fails with std::runtime_error in one line.
  bool Run(HorizonScene& scene, const Task& task);

  /// Horizons in degrees of all posts, a component an azimuth (degrees): twin of StoreAccumulator.
  bool Store(HorizonScene& scene, const std::vector<double>& azimuths, float* degrees);

  /// After a run of one tile: coefficients 4 i .. 4 i + 3 of every post.
  const std::vector<TwinTexture>& Images() const { return this->Sums; }

  /// The irradiance of every post in an image of four components: the coefficients of Images, times the
  /// light's: bands^2 of red, of green, of blue.
  TwinTexture Light(const std::vector<double>& coefficients);

  /// All texels of such an image, four floats each.
  void ReadImage(vtkTextureObject* image, float* texels);

  TwinTimes Times;

private:
  class Lap;
  bool SumTile(
    HorizonScene& scene, const Task& task, const TwinArea& tile, double begin, double end);
  std::vector<TwinArea> Tiles(const Grid& grid) const;
  void FindRows(HorizonScene& scene, const TwinArea& tile, const std::vector<double>& azimuths,
    vtkTextureObject* angles);
  void Prepare(const Task& task, const TwinArea& tile);
  void ReadTile(HorizonScene& scene, const Task& task, const TwinArea& tile);

  TwinDevice& Device;
  TwinLimits Limits;
  HorizonMethodKind Method = HorizonMethodKind::Exact;
  std::unique_ptr<TwinHorizons> Horizons;
  std::ptrdiff_t Columns = 0; // of the field
  int Bands = 0;
  bool Transfer = false;
  int Side = 0;                                  // of tiles
  int Width = 0, Height = 0;                     // of the images
  std::vector<std::unique_ptr<TwinPass>> Wedges; // of 32 coefficients each
  std::vector<TwinTexture> Sums;
  TwinTexture Angles, Gradients, Lit;
  std::unique_ptr<TwinPass> Lighting;
  std::size_t LitImages = 0;
};

} // namespace skyline

#endif
