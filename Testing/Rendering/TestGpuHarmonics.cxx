// SPDX-License-Identifier: BSD-3-Clause
#include "GpuTesting.h"

#include "vtkOpenGLHeightFieldTransfer.h"
#include "vtkOpenGLHeightFieldVisibility.h"

#include "vtkTextureObject.h"

namespace skyline
{
namespace testing
{
namespace
{

// Heights of 1500 m have a unit in the last place of 6e-5 m, and another order of the sums changes
// one or two of them: 4e-6 rad at the nearest caster, 30 m away, in a few azimuths. The greatest
// difference found is 2e-6.
constexpr double RoundingTolerance = 1.0e-5;

class Harmonics : public GpuTest
{
protected:
  template <typename Filter, typename Image>
  void Configure(Filter* filter, const Image& image)
  {
    filter->SetInputData(image);
    filter->SetMethodToPyramid();
    filter->SetNumberOfAzimuths(10);
  }

  /// The greatest difference between the graphics processor and the host on a field.
  template <typename Gpu, typename Host, typename Setting>
  double Parity(const oracle::OracleField& field, const char* name, const Setting& set)
  {
    const auto image = ImageOf<vtkDoubleArray>(field);
    vtkNew<Gpu> gpu;
    gpu->SetDevice(this->Device);
    vtkNew<Host> host;
    this->Configure(gpu.Get(), image);
    this->Configure(host.Get(), image);
    set(gpu.Get());
    set(host.Get());
    gpu->Update();
    host->Update();
    EXPECT_TRUE(gpu->IsOnDevice());
    return Difference(ArrayOf(gpu, name), ArrayOf(host, name));
  }

  template <typename Setting>
  void ExpectParity(const oracle::OracleField& field, const Setting& set)
  {
    EXPECT_LT((this->Parity<vtkOpenGLHeightFieldVisibility, vtkHeightFieldVisibility>(
                field, "VisibilitySH", set)),
      RoundingTolerance);
    EXPECT_LT((this->Parity<vtkOpenGLHeightFieldTransfer, vtkHeightFieldTransfer>(
                field, "TransferSH", set)),
      RoundingTolerance);
  }
};

TEST_F(Harmonics, AreThoseOfTheHost)
{
  for (const bool spline : { true, false })
  {
    this->ExpectParity(Hills(131, 97), [spline](auto* filter) { filter->SetLevelSpline(spline); });
  }
}

TEST_F(Harmonics, OfEveryOrder)
{
  for (const int bands : { 3, 8 })
  {
    this->ExpectParity(Hills(40, 57), [bands](auto* filter) { filter->SetNumberOfBands(bands); });
  }
}

TEST_F(Harmonics, BesideMissingPosts)
{
  this->ExpectParity(HillsWithHoles(131, 97), [](auto*) {});
}

TEST_F(Harmonics, OfSwathsAndLevels)
{
  this->ExpectParity(Hills(64, 64),
    [](auto* filter)
    {
      filter->SetSwathAzimuth(77.0);
      filter->SetSwathWidth(30.0);
      filter->SetNumberOfAzimuths(3);
      filter->SetLevelStep(2.5);
      filter->SetLevelOffset(1.0);
      filter->SetLevelDistance(1.5);
    });
}

TEST_F(Harmonics, StayInTexturesWithoutReadBack)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(40, 30));
  vtkNew<vtkOpenGLHeightFieldVisibility> gpu;
  gpu->SetDevice(this->Device);
  this->Configure(gpu.Get(), image);
  gpu->ReadBackOff();
  gpu->Update();
  EXPECT_TRUE(gpu->IsOnDevice());
  EXPECT_EQ(ArrayOf(gpu, "VisibilitySH"), nullptr);
  for (int i = 0; i < 4; ++i)
  {
    ASSERT_NE(gpu->GetTexture(i), nullptr);
    EXPECT_EQ(gpu->GetTexture(i)->GetWidth(), 40u);
    EXPECT_EQ(gpu->GetTexture(i)->GetHeight(), 30u);
  }
  EXPECT_EQ(gpu->GetTexture(4), nullptr);
  EXPECT_EQ(gpu->GetTexture(-1), nullptr);
}

TEST_F(Harmonics, OfTilesAreReadBackInAnyCase)
{
  this->Device->SetTextureLimit(32);
  const auto image = ImageOf<vtkDoubleArray>(Hills(40, 30));
  vtkNew<vtkOpenGLHeightFieldVisibility> gpu;
  gpu->SetDevice(this->Device);
  this->Configure(gpu.Get(), image);
  gpu->ReadBackOff();
  gpu->Update();
  EXPECT_TRUE(gpu->IsOnDevice());
  EXPECT_NE(ArrayOf(gpu, "VisibilitySH"), nullptr);
  EXPECT_EQ(gpu->GetTexture(0), nullptr);
}

TEST_F(Harmonics, FollowMovingTerrain)
{
  vtkNew<vtkOpenGLHeightFieldVisibility> gpu;
  vtkNew<vtkHeightFieldVisibility> host;
  gpu->SetDevice(this->Device);
  std::vector<oracle::OracleField> frames;
  for (const double time : { 0.0, 0.4, 0.8 })
  {
    frames.push_back(shapes::Waves(50, 40, 2.0, 6.0, 30.0, time));
    frames.push_back(shapes::Landslide(50, 40, 10.0, 0.5, 80.0, time));
  }
  for (const oracle::OracleField& frame : frames)
  {
    const auto image = ImageOf<vtkDoubleArray>(frame);
    this->Configure(gpu.Get(), image);
    this->Configure(host.Get(), image);
    gpu->Update();
    host->Update();
    EXPECT_LT(
      Difference(ArrayOf(gpu, "VisibilitySH"), ArrayOf(host, "VisibilitySH")), RoundingTolerance);
  }
}

TEST_F(Harmonics, TileByTile)
{
  this->Device->SetTextureLimit(48);
  this->ExpectParity(Hills(131, 97), [](auto*) {});
  this->ExpectParity(HillsWithHoles(101, 30), [](auto*) {});
}

} // namespace
} // namespace testing
} // namespace skyline
