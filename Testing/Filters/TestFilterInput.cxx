// SPDX-License-Identifier: BSD-3-Clause
// Bad input leads to one line that says what is wrong, and to an empty output. Also tests
// cancellation and progress.
#include "FilterTesting.h"

#include "Data/ImageGeoreference.h"
#include "Data/MemoryDemand.h"
#include "vtkCallbackCommand.h"
#include "vtkExtractVOI.h"
#include "vtkHeightFieldHorizon.h"
#include "vtkHeightFieldSkyView.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>

namespace skyline
{
namespace testing
{
namespace
{

void ExpectRefusal(vtkHeightFieldAlgorithm* filter, const std::string& reason)
{
  vtkNew<ErrorCatcher> errors;
  errors->Watch(filter);
  filter->Update();
  EXPECT_EQ(errors->Count, 1);
  EXPECT_NE(errors->Text.find(reason), std::string::npos) << errors->Text;
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(FilterInput, FewerThanTwoByTwo)
{
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(ImageOf<vtkFloatArray>(shapes::Plane(1, 9, 1.0, 0.0, 0.0)));
  ExpectRefusal(filter, "1 x 9 posts");
}

TEST(FilterInput, AllMissing)
{
  oracle::OracleField field = shapes::Plane(5, 5, 1.0, 0.0, 0.0);
  field.Heights.assign(25, std::nan(""));
  vtkNew<vtkHeightFieldSkyView> filter;
  filter->SetInputData(ImageOf<vtkFloatArray>(field));
  ExpectRefusal(filter, "every post is missing");
}

TEST(FilterInput, HeightsOfNoBody)
{
  oracle::OracleField field = shapes::Plane(5, 5, 1.0, 0.0, 0.0);
  field.Heights.assign(25, 1e20);
  vtkNew<vtkHeightFieldSkyView> filter;
  filter->SetInputData(ImageOf<vtkDoubleArray>(field));
  ExpectRefusal(filter, "every post is missing");
}

// A crop made by VTK keeps the georeference of the whole raster, which would give wrong distances.
TEST(FilterInput, ACropWithThePlaceOfTheWhole)
{
  const auto image = ImageOf<vtkFloatArray>(shapes::Plane(20, 30, 1.0, 0.3, -0.2));
  vtkNew<vtkExtractVOI> crop;
  crop->SetInputData(image);
  crop->SetVOI(3, 12, 4, 15, 0, 0);
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputConnection(crop->GetOutputPort());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 120); // no georeference, no error

  Georeference place;
  place.Columns = image->GetDimensions()[0];
  place.Rows = image->GetDimensions()[1];
  place.HasGeoTransform = true;
  place.GeoTransform = { 0.0, 1.0, 0.0, 30.0, 0.0, -1.0 };
  StoreGeoreference(place, image);
  crop->Modified();
  vtkNew<vtkHeightFieldSkyView> refusing;
  refusing->SetInputConnection(crop->GetOutputPort());
  ExpectRefusal(refusing, "posts, the height field has 10 x 12; cut the raster before");
}

// Ten percent more than the free memory of the machine; the field itself is small.
TEST(FilterInput, MoreThanTheMemoryIsRefusedBeforeTheSearch)
{
  constexpr int azimuths = 3600;
  const double side = std::sqrt(1.1 * FreeMemory() / (sizeof(float) * azimuths));
  if (!(side < 10000.0))
  {
    GTEST_SKIP() << "the system does not tell its memory, or has terabytes of it";
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(side) + 2, static_cast<int>(side) + 2, 1);
  vtkNew<vtkUnsignedCharArray> heights;
  heights->SetNumberOfTuples(image->GetNumberOfPoints());
  heights->FillValue(7);
  image->GetPointData()->SetScalars(heights);
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(image);
  filter->SetNumberOfAzimuths(azimuths);
  vtkNew<ErrorCatcher> errors;
  errors->Watch(filter);
  filter->Update();
  EXPECT_NE(errors->Text.find("GB are free; ask for less"), std::string::npos) << errors->Text;
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(FilterInput, NoHeights)
{
  vtkNew<vtkImageData> empty;
  empty->SetDimensions(5, 5, 1);
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(empty);
  ExpectRefusal(filter, "no heights");
}

// Two processes get the two parts of the result of one process.
TEST(FilterInput, Pieces)
{
  const auto image = ImageOf<vtkFloatArray>(shapes::Plane(9, 12, 1.0, 0.3, -0.2));
  vtkNew<vtkHeightFieldHorizon> serial;
  serial->SetInputData(image);
  serial->Update();
  vtkDataArray* wanted = serial->GetOutput()->GetPointData()->GetArray("HorizonElevation");
  vtkIdType posts = 0;
  for (int piece = 0; piece < 2; ++piece)
  {
    vtkNew<vtkHeightFieldHorizon> filter;
    filter->SetInputData(image);
    filter->UpdatePiece(piece, 2, 0);
    vtkImageData* part = filter->GetOutput();
    vtkDataArray* found = part->GetPointData()->GetArray("HorizonElevation");
    ASSERT_NE(found, nullptr);
    posts += part->GetNumberOfPoints();
    for (vtkIdType post = 0; post < part->GetNumberOfPoints(); ++post)
    {
      const vtkIdType whole = image->FindPoint(part->GetPoint(post));
      EXPECT_EQ(found->GetComponent(post, 5), wanted->GetComponent(whole, 5));
    }
  }
  EXPECT_EQ(posts, image->GetNumberOfPoints() + 9); // the row between them belongs to both
}

TEST(FilterInput, Slices)
{
  vtkNew<vtkImageData> cube;
  cube->SetDimensions(3, 3, 3);
  cube->AllocateScalars(VTK_FLOAT, 1);
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(cube);
  ExpectRefusal(filter, "3 slices");
}

TEST(FilterInput, Azimuths)
{
  for (const int azimuths : { 0, -3, 1000000000 })
  {
    vtkNew<vtkHeightFieldHorizon> filter;
    filter->SetInputData(ImageOf<vtkFloatArray>(shapes::Plane(5, 5, 1.0, 0.0, 0.0)));
    filter->SetNumberOfAzimuths(azimuths);
    ExpectRefusal(filter, std::to_string(azimuths) + " azimuths");
  }
}

TEST(FilterInput, ZeroSpacing)
{
  const auto image = ImageOf<vtkFloatArray>(shapes::Plane(5, 5, 1.0, 0.0, 0.0));
  image->SetSpacing(0.0, 1.0, 1.0);
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(image);
  ExpectRefusal(filter, "spacing");
}

TEST(FilterInput, TimeWithoutAPlace)
{
  vtkNew<vtkHeightFieldSunShadow> filter;
  filter->SetInputData(ImageOf<vtkFloatArray>(shapes::Plane(5, 5, 1.0, 0.0, 0.0)));
  filter->UseTimeOn();
  filter->SetTime("2026-06-21T06:00Z");
  vtkNew<ErrorCatcher> errors;
  errors->Watch(filter);
  filter->Update();
  EXPECT_EQ(errors->Count, 1);
}

TEST(FilterInput, AnyArrayMayCarryTheHeights)
{
  const auto image = ImageOf<vtkFloatArray>(shapes::Plane(9, 9, 1.0, 0.0, 0.0));
  const oracle::OracleField hill = shapes::Plane(9, 9, 1.0, 0.5, 0.0);
  vtkNew<vtkDoubleArray> other;
  other->SetName("Other");
  other->SetNumberOfTuples(81);
  for (vtkIdType post = 0; post < 81; ++post)
  {
    other->SetValue(post, hill.Heights[static_cast<std::size_t>(post)]);
  }
  image->GetPointData()->AddArray(other);
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(image);
  filter->SetNumberOfAzimuths(4);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Other");
  filter->Update();
  EXPECT_NEAR(ArrayOf(filter, "HorizonElevation")->GetComponent(40, 1),
    std::atan(0.5) * DegreesPerRadian, 1.0e-5);
}

TEST(FilterRun, ReportsProgressAndStops)
{
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(ImageOf<vtkFloatArray>(shapes::Fractal(60, 60, 10.0, 100.0)));
  filter->SetNumberOfAzimuths(36);
  struct Watcher
  {
    int Calls = 0;
    double Last = -1.0;
  } watcher;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watcher);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void* part)
    {
      auto* seen = static_cast<Watcher*>(data);
      const double now = *static_cast<double*>(part);
      EXPECT_GE(now, 0.0);
      EXPECT_LE(now, 1.0);
      seen->Last = now;
      if (++seen->Calls == 10)
      {
        vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
      }
    });
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Update();
  EXPECT_LT(watcher.Calls, 15);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

// A change of the sun alone only searches the swath of the sun.
TEST(FilterRun, TheSunSearchesItsSwathOnly)
{
  vtkNew<vtkHeightFieldSunShadow> filter;
  filter->SetInputData(ImageOf<vtkFloatArray>(shapes::Fractal(60, 60, 10.0, 100.0)));
  filter->Update();
  EXPECT_EQ(filter->GetSearchedAzimuths(), 17);
  filter->SetSunAngularRadius(0.0);
  filter->Update();
  EXPECT_EQ(filter->GetSearchedAzimuths(), 1);
}

} // namespace
} // namespace testing
} // namespace skyline
