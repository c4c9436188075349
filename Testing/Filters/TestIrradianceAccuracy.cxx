// SPDX-License-Identifier: BSD-3-Clause
// Irradiance of the filter, compared with a sum over all pixels of the light map above the exact
// horizon. Documentation/irradiance.md gives the same figures for larger scenes.
#include "FilterTesting.h"
#include "Reference/LightOracle.h"
#include "Sky/SkyModel.h"

#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldReader.h"
#include "vtkSkylineEnvironmentLight.h"

#include <gtest/gtest.h>

namespace skyline
{
namespace testing
{
namespace
{

/// Azimuths of the reference: 14 per pixel of the map, 0.1 degrees apart.
constexpr int ReferenceAzimuths = 3584;

constexpr std::ptrdiff_t MapColumns = 256, MapRows = 128;

constexpr int Posts = 40;

struct Errors
{
  double Median, Most; ///< percent: the median and the 95th percentile
};

struct Scene
{
  oracle::OracleField Field;
  vtkSmartPointer<vtkImageData> Image;
  std::vector<std::ptrdiff_t> Chosen;       // posts away from the edge
  std::vector<std::vector<double>> Horizon; // for each post, elevations in radians

  explicit Scene(const oracle::OracleField& field)
    : Field(field)
    , Image(ImageOf<vtkDoubleArray>(field))
  {
    shapes::Random random(2);
    for (int k = 0; k < Posts; ++k)
    {
      const std::ptrdiff_t column = 1 + random.Below(field.Columns - 2);
      const std::ptrdiff_t row = 1 + random.Below(field.Rows - 2);
      this->Chosen.push_back(row * field.Columns + column);
      this->Horizon.emplace_back();
      for (int a = 0; a < ReferenceAzimuths; ++a)
      {
        // In the middle between the edges of the strips of BruteLight.
        const double azimuth = -Pi + 2.0 * Pi * (a + 0.5) / ReferenceAzimuths;
        this->Horizon.back().push_back(
          std::atan(oracle::HorizonSlope(field, column, row, azimuth)));
      }
    }
  }

  std::vector<Color> Truth(const OwnedMap& map) const
  {
    std::vector<Color> light;
    for (std::size_t k = 0; k < this->Chosen.size(); ++k)
    {
      double east = 0.0, north = 0.0;
      oracle::Gradient(this->Field, this->Chosen[k] % this->Field.Columns,
        this->Chosen[k] / this->Field.Columns, east, north);
      const auto horizon = [&](double azimuth)
      {
        const double place = (azimuth + Pi) / (2.0 * Pi) * ReferenceAzimuths;
        return this->Horizon[k][static_cast<std::size_t>(place)];
      };
      light.push_back(BruteLight(map, 0.0, horizon, east, north, ReferenceAzimuths));
    }
    return light;
  }

  Errors Compare(OwnedMap& map, int azimuths, const std::vector<Color>& truth) const
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(static_cast<int>(map.Columns), static_cast<int>(map.Rows), 1);
    vtkNew<vtkFloatArray> radiance;
    radiance->SetName("Radiance");
    radiance->SetNumberOfComponents(3);
    radiance->SetNumberOfTuples(image->GetNumberOfPoints());
    for (std::ptrdiff_t row = 0; row < map.Rows; ++row)
    {
      for (std::ptrdiff_t column = 0; column < map.Columns; ++column)
      {
        radiance->SetTypedTuple((map.Rows - 1 - row) * map.Columns + column, map.At(column, row));
      }
    }
    image->GetPointData()->SetScalars(radiance);
    vtkNew<vtkSkylineEnvironmentLight> sky;
    sky->SetImage(image);
    vtkNew<vtkHeightFieldIrradiance> filter;
    filter->SetInputData(this->Image);
    filter->FlatOn();
    filter->AddLight(sky);
    filter->SetNumberOfAzimuths(azimuths);
    filter->Update();
    std::vector<double> errors;
    for (std::size_t k = 0; k < truth.size(); ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double light = ArrayOf(filter, "Irradiance")->GetComponent(this->Chosen[k], c);
        errors.push_back(100.0 * std::abs(light / truth[k][static_cast<std::size_t>(c)] - 1.0));
      }
    }
    std::sort(errors.begin(), errors.end());
    const Errors found{ errors[errors.size() / 2], errors[errors.size() * 95 / 100] };
    std::printf("%5d azimuths (%d searched): median %.4f %%, 95 in 100 below %.4f %%\n", azimuths,
      filter->GetSearchedAzimuths(), found.Median, found.Most);
    return found;
  }
};

const Scene& MountStHelens()
{
  static const Scene scene = []()
  {
    vtkNew<vtkHeightFieldReader> reader;
    reader->SetFileName(SKYLINE_TEST_DATA "/exact/sthelens_crop160_dem.tif");
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    oracle::OracleField field(160, 160, image->GetSpacing()[0], image->GetSpacing()[1]);
    for (vtkIdType post = 0; post < image->GetNumberOfPoints(); ++post)
    {
      field.Heights[static_cast<std::size_t>(post)] =
        image->GetPointData()->GetScalars()->GetComponent(post, 0);
    }
    return Scene(field);
  }();
  return scene;
}

// Houses, as in the surface model of a town.
const Scene& Town()
{
  static const Scene scene(shapes::RandomBoxes(120, 120, 1.0, 150, 12, 15.0, 3));
  return scene;
}

OwnedMap Sky(int type)
{
  OwnedMap map(MapColumns, MapRows);
  FillSky(CieSky(type), 2.0, 0.7, {}, MapColumns, MapRows, map.Pixels.data());
  return map;
}

// Checks the bounds that the project requires with 128 azimuths, and that errors decrease with more
// azimuths.
void Judge(const Scene& scene, OwnedMap map, const Errors& bound)
{
  const std::vector<Color> truth = scene.Truth(map);
  const Errors coarse = scene.Compare(map, 32, truth);
  const Errors fine = scene.Compare(map, 128, truth);
  EXPECT_LT(fine.Median, bound.Median);
  EXPECT_LT(fine.Most, bound.Most);
  EXPECT_LT(fine.Median, 0.5 * coarse.Median + 1.0e-3);
}

TEST(IrradianceAccuracy, UniformSkyOnTerrain)
{
  Judge(MountStHelens(), Sky(5), { 0.1, 0.1 });
}

TEST(IrradianceAccuracy, UniformSkyInATown)
{
  Judge(Town(), Sky(5), { 0.1, 1.0 });
}

TEST(IrradianceAccuracy, ClearSkyOnTerrain)
{
  Judge(MountStHelens(), Sky(12), { 0.3, 0.3 });
}

TEST(IrradianceAccuracy, ClearSkyInATown)
{
  Judge(Town(), Sky(12), { 0.3, 1.0 });
}

TEST(IrradianceAccuracy, SunOfAHundredThousandMeansOnTerrain)
{
  Judge(MountStHelens(), SunnyMap(MapColumns, MapRows, 131.0, 24.0), { 0.5, 3.0 });
}

TEST(IrradianceAccuracy, SunOfAHundredThousandMeansInATown)
{
  Judge(Town(), SunnyMap(MapColumns, MapRows, 131.0, 24.0), { 0.5, 3.0 });
}

} // namespace
} // namespace testing
} // namespace skyline
