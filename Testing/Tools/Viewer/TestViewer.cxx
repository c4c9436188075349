// SPDX-License-Identifier: BSD-3-Clause
// The viewer in a window without a window system: the effects of events on the picture.
#include "ViewerTesting.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkSkylineLightMapReader.h"
#include "vtkSkylineSoftShadowShader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

// Compares the light at a position with that of the nearest post: the median over a row of pixels.
constexpr double NearestPost = 0.02;

// The difference between two neighbouring rows of the picture of the sky, which are one degree
// apart.
constexpr float NextRow = 0.02f;

bool HasPass(const PassTimes& times, const std::string& name)
{
  for (const auto& time : times)
  {
    if (time.first == name)
    {
      return true;
    }
  }
  return false;
}

TEST_F(ViewerTest, FirstPictureIsFastThenExact)
{
  this->View = std::make_unique<Viewer>(this->Window, Quick(), Silent());
  EXPECT_FALSE(this->View->Draw(0.0)) << "before the window has a size";
  this->View->Resize(Width, Height, 1.0);
  EXPECT_TRUE(this->View->Draw(0.0));
  EXPECT_FALSE(this->View->IsExact());
  EXPECT_GT(Brightness(this->Window), 30.0);
  this->Rest();
  EXPECT_TRUE(this->View->IsExact());
  EXPECT_TRUE(HasPass(this->View->GetTimes(), "sun"));
  EXPECT_FALSE(this->View->Draw(this->Now + 9.0)) << "nothing has changed";
}

TEST_F(ViewerTest, SunMovesWithoutNewSky)
{
  this->Open();
  const double before = Brightness(this->Window);
  for (int k = 0; k < 12; ++k)
  {
    this->View->KeyPress(KeyRight, Plain);
  }
  this->Draw();
  EXPECT_TRUE(HasPass(this->View->GetTimes(), "sun"));
  EXPECT_FALSE(HasPass(this->View->GetTimes(), "sky")) << "horizons all around are kept";
  this->Rest();
  EXPECT_FALSE(HasPass(this->View->GetTimes(), "sky"));
  EXPECT_NE(Brightness(this->Window), before);
}

TEST_F(ViewerTest, CameraMovesWithoutNewLight)
{
  this->Open();
  const double heading = this->View->GetScene().GetHeading();
  this->View->MouseMove(300, 250);
  this->DragTo(380, 250);
  EXPECT_NE(this->View->GetScene().GetHeading(), heading);
  EXPECT_FALSE(HasPass(this->View->GetTimes(), "sun"));
  EXPECT_FALSE(HasPass(this->View->GetTimes(), "shading"));
  EXPECT_NEAR(this->View->GetHud().Heading, this->View->GetScene().GetHeading(), 3.0)
    << "true north is a meridian convergence beside grid north";
  vtkCamera* camera = this->View->GetScene().GetRenderer()->GetActiveCamera();
  const double distance = camera->GetDistance();
  this->View->Wheel(3.0);
  EXPECT_LT(camera->GetDistance(), distance);
  this->View->KeyPress('V', Plain);
  this->Rest();
  EXPECT_NEAR(this->View->GetScene().GetHeading(), 0.0, 0.01);
  EXPECT_NEAR(camera->GetDistance(), distance, 1.0e-6 * distance);
}

TEST_F(ViewerTest, CameraStaysAboveTheGround)
{
  this->Open();
  this->View->MouseMove(300, 100);
  this->DragTo(340, 200);
  vtkCamera* camera = this->View->GetScene().GetRenderer()->GetActiveCamera();
  EXPECT_NEAR(camera->GetPosition()[2], camera->GetFocalPoint()[2], 1.0e-6);
  EXPECT_GT(this->View->GetScene().GetHeading(), 0.0) << "it still turns";
}

// The object in the middle of the picture stays there while the camera turns around it.
TEST_F(ViewerTest, CameraTurnsAboutTheGroundInTheMiddle)
{
  this->Open();
  ScenePoint before;
  ScenePoint after;
  ASSERT_TRUE(this->View->GetScene().FindPlace(0.5 * Width, 0.5 * Height, before));
  this->View->MouseMove(100, 200);
  this->DragTo(300, 200);
  this->Rest();
  ASSERT_TRUE(this->View->GetScene().FindPlace(0.5 * Width, 0.5 * Height, after));
  const double pixel = this->View->GetScene().GetMetresPerPixel();
  EXPECT_LT(std::hypot(after[0] - before[0], after[1] - before[1]), 3.0 * pixel);
}

TEST_F(ViewerTest, SlidersTakeTheMouse)
{
  this->Open();
  const HudBox& box = this->View->GetLayout().Sliders[0];
  ASSERT_GT(box.Width, 0.0);
  const double heading = this->View->GetScene().GetHeading();
  this->View->MouseMove(box.X + 0.25 * box.Width, box.Y + 0.5 * box.Height);
  this->DragTo(box.X + 0.5 * box.Width, box.Y + 90.0);
  EXPECT_NEAR(this->View->GetState().Clock.GetMinutes(), 720.0, 1.0e-6);
  EXPECT_EQ(this->View->GetScene().GetHeading(), heading);
  EXPECT_FALSE(this->View->IsExact());
  const HudBox& days = this->View->GetLayout().Sliders[1];
  this->View->MouseMove(days.X, days.Y + 0.5 * days.Height);
  this->DragTo(days.X - 50.0, days.Y);
  EXPECT_EQ(this->View->GetState().Clock.LocalDate(), "2026-01-01");
}

TEST_F(ViewerTest, ControlDragMovesTheSun)
{
  this->Open();
  const double minutes = this->View->GetState().Clock.GetMinutes();
  this->View->MouseMove(300, 200);
  this->DragTo(300 - Width / 8.0, 200, MouseButton::Left, Control);
  EXPECT_NEAR(this->View->GetState().Clock.GetMinutes(), minutes - 180.0, 1.0e-6);
}

TEST_F(ViewerTest, LampsArePlacedAndMoved)
{
  ViewerOptions options = Quick();
  options.Lights.Sun.Time = "2026-06-21T08:00Z"; // night
  this->Open(options);
  const int x = Width / 2;
  const int y = Height / 2;
  this->View->MouseMove(x, y);
  this->View->KeyPress('L', Plain);
  this->Rest();
  ASSERT_EQ(this->View->GetState().Lamps.size(), 1u);
  const double lit = Brightness(this->Window, x - 15, y - 15, x + 15, y + 15);
  const ViewerLamp placed = this->View->GetState().Lamps[0];
  // The lamp is above its foot. It is dragged by the foot.
  ScenePoint foot = this->View->GetScene().GetFoot(placed);
  EXPECT_NEAR(foot[0], x, 2.0);
  EXPECT_NEAR(foot[1], y, 2.0);
  this->DragTo(x + 120.0, y);
  const ViewerLamp moved = this->View->GetState().Lamps[0];
  EXPECT_GT(moved.X, placed.X);
  EXPECT_EQ(moved.Height, placed.Height);
  EXPECT_FALSE(this->View->IsExact());
  EXPECT_NE(this->View->GetHud().Status.find("preview"), std::string::npos);
  foot = this->View->GetScene().GetFoot(moved);
  EXPECT_NEAR(foot[0], x + 120.0, 3.0);
  this->Rest();
  EXPECT_FALSE(HasPass(this->View->GetTimes(), "sky"));
  EXPECT_LT(Brightness(this->Window, x - 15, y - 15, x + 15, y + 15), 0.8 * lit);
  this->DragTo(x + 120.0, y + 40.0, MouseButton::Right);
  EXPECT_GT(this->View->GetState().Lamps[0].Height, moved.Height);
  this->View->KeyPress(KeyDelete, Plain);
  EXPECT_TRUE(this->View->GetState().Lamps.empty());
  this->Rest();
  this->View->MouseMove(1, Height - 1);
  this->View->KeyPress('L', Plain);
  EXPECT_TRUE(this->View->GetState().Lamps.empty());
  EXPECT_EQ(this->View->GetMessage(), "no ground under the mouse for a lamp");
}

// While a lamp is dragged, its light is the same as after the next rest, except for the shadows.
TEST_F(ViewerTest, LampsShineTheSameWhileTheyMove)
{
  ViewerOptions options = Quick();
  options.Lights.Sun.Time = "2026-06-21T08:00Z"; // night
  this->Open(options);
  this->View->MouseMove(Width / 2, Height / 2);
  this->View->KeyPress('L', Plain);
  this->Draw();
  const double moving = Brightness(this->Window, 0, 100, Width - 1, Height - 100);
  this->Rest();
  EXPECT_NEAR(Brightness(this->Window, 0, 100, Width - 1, Height - 100), moving, 0.1 * moving);
}

TEST_F(ViewerTest, DroppedFilesBecomeSkyOrTerrain)
{
  this->Open();
  this->View->Drop({ Data("light-maps/sunset_128.hdr") });
  EXPECT_EQ(this->View->GetState().GetSky().Text, Data("light-maps/sunset_128.hdr"));
  EXPECT_FALSE(this->View->GetState().Sun);
  this->Draw();
  EXPECT_TRUE(HasPass(this->View->GetTimes(), "light map"));
  this->View->KeyPress('R', Plain);
  this->Rest();
  EXPECT_EQ(this->View->GetState().Rotation, 10.0);
  EXPECT_GT(Brightness(this->Window), 20.0);
  this->View->Drop({ Data("dem/SainteHelens.dem.gz") });
  this->View->Drop({ Data("sun/../dem/SainteHelens.tif") });
  EXPECT_EQ(this->View->GetMessage(), "");
  this->Rest();
  EXPECT_GT(Brightness(this->Window), 20.0);
}

TEST_F(ViewerTest, WrongFilesAreAMessage)
{
  this->Open();
  const std::string text = std::string(SKYLINE_TEST_OUTPUT) + "/no-raster.txt";
  std::ofstream(text) << "not a raster\n";
  const std::string map = std::string(SKYLINE_TEST_OUTPUT) + "/no-map.hdr";
  std::ofstream(map) << "not a light map\n";
  for (const std::string& file : { text, map, Data("dem"), std::string("/nowhere/x.tif") })
  {
    const double before = Brightness(this->Window);
    this->View->Drop({ file });
    EXPECT_NE(this->View->GetMessage(), "") << file;
    EXPECT_EQ(this->View->GetMessage().find('\n'), std::string::npos) << file;
    this->Rest();
    EXPECT_NEAR(Brightness(this->Window), before, 8.0) << "the terrain stays; a line of text comes";
  }
  EXPECT_EQ(this->View->GetTitle(), "SainteHelens.tif - skyline");
  EXPECT_EQ(this->View->GetState().GetSky().Text, "uniform");
}

TEST_F(ViewerTest, HeightsStretch)
{
  this->Open();
  this->View->KeyPress('X', Plain);
  this->Draw();
  EXPECT_FALSE(HasPass(this->View->GetTimes(), "sky")) << "new horizons wait for a rest";
  this->Rest();
  EXPECT_TRUE(HasPass(this->View->GetTimes(), "sky"));
  EXPECT_TRUE(this->View->IsExact());
}

TEST_F(ViewerTest, Animates)
{
  this->Open();
  const double minutes = this->View->GetState().Clock.GetMinutes();
  this->View->KeyPress(KeySpace, Plain);
  this->Draw();
  EXPECT_EQ(this->View->GetPatience(this->Now), 0.0);
  this->View->Draw(this->Now += 0.1);
  EXPECT_GT(this->View->GetState().Clock.GetMinutes(), minutes);
  EXPECT_FALSE(this->View->IsExact());
  this->View->KeyPress(KeySpace, Plain);
  this->Rest();
  EXPECT_TRUE(this->View->IsExact());
}

TEST_F(ViewerTest, SleepsWhileMinimised)
{
  this->Open();
  this->View->KeyPress(KeySpace, Plain);
  this->View->Minimise(true);
  EXPECT_FALSE(this->View->Draw(this->Now += 1.0));
  EXPECT_LT(this->View->GetPatience(this->Now), 0.0);
  this->View->Minimise(false);
  EXPECT_TRUE(this->View->Draw(this->Now += 1.0));
}

TEST_F(ViewerTest, AnySizeOfWindow)
{
  this->Open();
  this->View->KeyPress('H', Plain);
  for (const auto& size : { std::array<int, 2>{ { 1, 1 } }, std::array<int, 2>{ { 0, 0 } },
         std::array<int, 2>{ { 3, 700 } }, std::array<int, 2>{ { 160, 120 } },
         std::array<int, 2>{ { 900, 30 } } })
  {
    this->View->Resize(size[0], size[1], 2.0);
    this->Draw();
    this->View->MouseMove(0.0, 0.0);
    this->DragTo(1.0, 1.0);
    this->View->KeyPress('L', Plain);
  }
  this->View->Resize(Width, Height, 1.0);
  this->View->KeyPress('V', Plain);
  this->Rest();
  EXPECT_EQ(this->Window->GetSize()[0], Width);
  EXPECT_GT(Brightness(this->Window), 20.0);
}

TEST_F(ViewerTest, ScreenshotsHoldThePicture)
{
  const ViewerOptions options = Quick();
  this->Open(options);
  this->View->KeyPress('P', Plain);
  this->Draw();
  EXPECT_EQ(this->View->GetMessage(), "wrote " + options.ShotFolder + "/skyline-1.png");
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((options.ShotFolder + "/skyline-1.png").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], Width);
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[1], Height);
  this->View->KeyPress('P', Plain);
  this->Draw();
  EXPECT_TRUE(std::filesystem::exists(options.ShotFolder + "/skyline-2.png"));
  this->View->KeyPress('P', Shift);
  this->Draw();
  EXPECT_EQ(this->View->GetMessage(), "wrote " + options.ShotFolder + "/skyline-1.exr");
  this->Rest();
  EXPECT_GT(Brightness(this->Window), 20.0) << "the window is as before";
}

// The picture in linear light, read back as a light map, whose width is twice its height.
TEST_F(ViewerTest, LinearScreenshotsHoldTheRadiance)
{
  const ViewerOptions options = Quick();
  this->Open(options);
  this->View->Resize(Width, Width / 2, 1.0);
  this->View->KeyPress('V', Plain);
  this->Rest();
  this->View->KeyPress('P', Shift);
  this->Draw();
  vtkNew<vtkSkylineLightMapReader> reader;
  reader->SetFileName((options.ShotFolder + "/skyline-1.exr").c_str());
  reader->Update();
  vtkImageData* picture = reader->GetOutput();
  ASSERT_EQ(picture->GetDimensions()[0], Width);
  ASSERT_EQ(picture->GetDimensions()[1], Width / 2);
  const SkyImage& sky = this->View->GetScene().GetSky().GetSky();
  const ScenePoint look = this->View->GetScene().GetDirection(2.5, Width / 2 - 2.5);
  const auto row =
    static_cast<std::ptrdiff_t>(std::acos(look[2]) / M_PI * static_cast<double>(sky.Rows));
  for (int c = 0; c < 3; ++c)
  {
    const float there = sky.Values[static_cast<std::size_t>(3 * row * sky.Columns + c)];
    const float seen = picture->GetScalarComponentAsFloat(2, Width / 2 - 3, 0, c);
    EXPECT_NEAR(seen, there, NextRow * there);
  }
  vtkImageData* lit = this->View->GetScene().GetShader()->GetHeightField();
  std::vector<double> ratios;
  for (int x = Width / 3; x < 2 * Width / 3; x += 5)
  {
    ScenePoint place;
    ASSERT_TRUE(this->View->GetScene().FindPlace(x + 0.5, 80.5, place));
    const vtkIdType post = lit->FindPoint(place[0], place[1], 0.0);
    const double light = lit->GetPointData()->GetArray("Radiance")->GetComponent(post, 1);
    ratios.push_back(picture->GetScalarComponentAsFloat(x, 80, 0, 1) / light);
  }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_NEAR(ratios[ratios.size() / 2], 1.0, NearestPost);
}

TEST_F(ViewerTest, ScreenshotsThatCannotBeWrittenAreAMessage)
{
  ViewerOptions options = Quick();
  options.ShotFolder = "/nowhere";
  this->Open(options);
  this->View->KeyPress('P', Plain);
  this->Draw();
  EXPECT_NE(this->View->GetMessage().find("/nowhere"), std::string::npos);
}

TEST_F(ViewerTest, ExactWorkGivesWayToEvents)
{
  this->Open();
  this->View->KeyPress('X', Plain);
  this->Draw();
  int polls = 0;
  this->View->Poll = [&]
  {
    if (++polls == 1)
    {
      this->View->KeyPress(KeyRight, Plain);
    }
  };
  this->View->Draw(this->Now += 1.0);
  EXPECT_GT(polls, 0);
  EXPECT_FALSE(this->View->IsExact()) << "it was stopped";
  this->Rest();
  EXPECT_TRUE(this->View->IsExact());
}

TEST_F(ViewerTest, OptionsOfTheCommandLineCount)
{
  ViewerOptions options = Quick();
  options.Lights.Sun.Time.clear();
  options.Lights.Sun.Direction = SunAngles{ 100.0, 20.0 };
  options.Lights.Sky = ParseSky("cie:12");
  options.Lights.Lamps = { { 562000.0, 5114000.0, 3000.0, 100.0, { { 5.0, 5.0, 5.0 } }, "" } };
  options.Colors = "gray";
  options.Exaggeration = 2.0;
  this->Open(options);
  const ViewerState& state = this->View->GetState();
  EXPECT_FALSE(state.ByTime);
  EXPECT_EQ(state.Azimuth, 100.0);
  EXPECT_EQ(state.Elevation, 20.0);
  EXPECT_EQ(state.GetSky().Text, "cie:12");
  ASSERT_EQ(state.Lamps.size(), 1u);
  EXPECT_EQ(state.Lamps[0].Radius, 100.0);
  EXPECT_TRUE(HasPass(this->View->GetTimes(), "light map"));
}

} // namespace
} // namespace testing
} // namespace skyline
