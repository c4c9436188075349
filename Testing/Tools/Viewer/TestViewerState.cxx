// SPDX-License-Identifier: BSD-3-Clause
// The effects of keys and drags on the settings of the viewer, and the layout of its display.
#include "HeightRay.h"
#include "HudLayout.h"
#include "Sun/UtcTime.h"
#include "SunClock.h"
#include "ViewerState.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace skyline
{
namespace
{

constexpr Modifiers Plain{};
constexpr Modifiers Shift{ true, false };

// Positions found by bisection have an error of at most a hundredth of a post.
constexpr double PlaceTolerance = 0.01;

TEST(SunClock, ZonesFollowTheLongitude)
{
  EXPECT_EQ(NauticalZone(0.0), 0);
  EXPECT_EQ(NauticalZone(-122.2), -8);
  EXPECT_EQ(NauticalZone(7.4), 0);
  EXPECT_EQ(NauticalZone(7.6), 1);
  EXPECT_EQ(NauticalZone(237.8), -8);
}

TEST(SunClock, ReadsUtcAndWritesItBack)
{
  const SunClock clock("2026-03-01T02:30Z", -8);
  EXPECT_EQ(clock.LocalDate(), "2026-02-28");
  EXPECT_EQ(clock.LocalClock(), "18:30");
  EXPECT_EQ(clock.ZoneName(), "UTC-8");
  EXPECT_EQ(clock.UtcText(), "2026-03-01 02:30");
  EXPECT_EQ(ToText(ParseUtcTime(clock.ToTime())), ToText(ParseUtcTime("2026-03-01T02:30Z")));
}

TEST(SunClock, LeapDaysAndTurnsOfTheYear)
{
  SunClock clock("2024-02-28T12:00Z", 0);
  clock.AddDays(1);
  EXPECT_EQ(clock.LocalDate(), "2024-02-29");
  clock.AddDays(306);
  EXPECT_EQ(clock.LocalDate(), "2024-12-31");
  EXPECT_EQ(clock.GetDayOfYear(), 366);
  clock.AddMinutes(12.0 * 60.0);
  EXPECT_EQ(clock.LocalDate(), "2025-01-01");
  EXPECT_EQ(clock.LocalClock(), "00:00");
  clock.AddMinutes(-1.0);
  EXPECT_EQ(clock.LocalDate(), "2024-12-31");
  EXPECT_EQ(clock.LocalClock(), "23:59");
}

TEST(SunClock, StopsAtItsEnds)
{
  SunClock clock(2099, 365, 600.0, 3);
  clock.AddDays(500);
  EXPECT_EQ(clock.LocalDate(), "2099-12-31");
  clock.AddDays(-365 * 300);
  EXPECT_EQ(clock.LocalDate(), "1901-01-01");
  EXPECT_NO_THROW(ParseUtcTime(clock.ToTime()));
  EXPECT_THROW(SunClock("1900-06-01", 0), std::out_of_range);
  EXPECT_THROW(SunClock("noon", 0), std::invalid_argument);
}

TEST(SunClock, TurnsWithinItsDay)
{
  SunClock clock(2026, 172, 23.0 * 60.0, 0);
  clock.TurnMinutes(120.0);
  EXPECT_EQ(clock.LocalClock(), "01:00");
  EXPECT_EQ(clock.GetDayOfYear(), 172);
}

TEST(ViewerState, ArrowKeysMoveTheSunByTime)
{
  ViewerState state;
  state.ByTime = true;
  state.Clock = SunClock(2026, 172, 600.0, 0);
  EXPECT_EQ(state.Press(KeyRight, Plain), ViewerRequest::Changed);
  EXPECT_EQ(state.Clock.GetMinutes(), 610.0);
  state.Press(KeyLeft, Shift);
  EXPECT_EQ(state.Clock.GetMinutes(), 609.0);
  state.Press(KeyUp, Plain);
  EXPECT_EQ(state.Clock.GetDayOfYear(), 173);
  state.Press(KeyDown, Shift);
  EXPECT_EQ(state.Clock.GetDayOfYear(), 143);
}

TEST(ViewerState, ArrowKeysMoveTheSunByDirection)
{
  ViewerState state;
  state.Azimuth = 359.0;
  state.Press(KeyRight, Plain);
  EXPECT_NEAR(state.Azimuth, 1.0, 1.0e-9);
  for (int k = 0; k < 200; ++k)
  {
    state.Press(KeyDown, Plain);
  }
  EXPECT_EQ(state.Elevation, -20.0); // the end of its slider
}

TEST(ViewerState, SlidersSpanDayAndYear)
{
  ViewerState state;
  state.ByTime = true;
  state.Clock = SunClock(2024, 10, 0.0, 0);
  EXPECT_EQ(state.GetSlider(0).High, 1440.0);
  EXPECT_EQ(state.GetSlider(1).High, 366.0);
  state.SetSlider(0, 1e9);
  EXPECT_EQ(state.Clock.LocalClock(), "23:59");
  state.SetSlider(1, 60.2);
  EXPECT_EQ(state.Clock.LocalDate(), "2024-02-29");
  state.ByTime = false;
  state.SetSlider(0, 90.0);
  state.SetSlider(1, 30.0);
  EXPECT_EQ(state.Azimuth, 90.0);
  EXPECT_EQ(state.Elevation, 30.0);
}

TEST(ViewerState, AnimatesADay)
{
  ViewerState state;
  state.ByTime = true;
  state.Clock = SunClock(2026, 172, 600.0, 0);
  state.Advance(1.0);
  EXPECT_EQ(state.Clock.GetMinutes(), 600.0); // the animation is off
  state.Press(KeySpace, Plain);
  state.Advance(30.0);
  EXPECT_NEAR(state.Clock.GetMinutes(), 600.0, 1.0e-6); // a full day
  EXPECT_EQ(state.Clock.GetDayOfYear(), 172);
}

TEST(ViewerState, HeightsComeBackToOne)
{
  ViewerState state;
  for (int k = 0; k < 5; ++k)
  {
    state.Press('X', Plain);
  }
  for (int k = 0; k < 5; ++k)
  {
    state.Press('X', Shift);
  }
  EXPECT_EQ(state.Exaggeration, 1.0);
  for (int k = 0; k < 99; ++k)
  {
    state.Press('X', Plain);
  }
  EXPECT_EQ(state.Exaggeration, ViewerState::GreatestExaggeration);
}

TEST(ViewerState, LampKeysMeanTheChosenOne)
{
  ViewerState state;
  EXPECT_EQ(
    state.Press(']', Plain), ViewerRequest::Changed); // there is no lamp, so nothing happens
  state.AddLamp({ 0, 0, 5, 2, { { 1, 1, 1 } } });
  state.AddLamp({ 9, 9, 1, 2, { { 4, 4, 4 } } });
  state.Press('[', Plain);
  EXPECT_EQ(state.Lamps[0].Radiance[0], 1.0);
  EXPECT_NEAR(state.Lamps[1].Radiance[0], 3.2, 1.0e-12);
  state.Press(KeyPageDown, Plain);
  EXPECT_EQ(state.Lamps[1].Height, 0.0); // not below the ground
  state.Press(KeyDelete, Plain);
  ASSERT_EQ(state.Lamps.size(), 1u);
  EXPECT_EQ(state.Lamps[0].X, 0.0);
  state.Press(KeyDelete, Plain);
  EXPECT_FALSE(state.HasChosen());
  EXPECT_EQ(state.Press(KeyDelete, Plain), ViewerRequest::Changed);
}

TEST(ViewerState, SkiesGoRound)
{
  ViewerState state;
  state.TakeSky(SkyOfFile("map.hdr"));
  state.TakeSky(SkyOfFile("map.hdr"));
  ASSERT_EQ(state.Skies.size(), 2u);
  EXPECT_EQ(state.GetSky().Text, "map.hdr");
  state.Press('K', Plain);
  EXPECT_EQ(state.GetSky().Text, "uniform");
}

TEST(ViewerState, EscapeClosesTheHelpFirst)
{
  ViewerState state;
  state.Press('H', Plain);
  EXPECT_EQ(state.Press(KeyEscape, Plain), ViewerRequest::Changed);
  EXPECT_FALSE(state.Help);
  EXPECT_EQ(state.Press(KeyEscape, Plain), ViewerRequest::Leave);
  EXPECT_EQ(state.Press('~', Plain), ViewerRequest::Nothing);
}

TEST(ViewerState, EveryKeyOfTheHelpMeansSomething)
{
  for (const int key :
    { static_cast<int>(KeyLeft), static_cast<int>(KeyRight), static_cast<int>(KeyUp),
      static_cast<int>(KeyDown), static_cast<int>(KeySpace), static_cast<int>(KeyDelete),
      static_cast<int>(KeyEscape), static_cast<int>('S'), static_cast<int>('K'),
      static_cast<int>('R'), static_cast<int>('L'), static_cast<int>('['), static_cast<int>(']'),
      static_cast<int>(','), static_cast<int>('.'), static_cast<int>('X'), static_cast<int>('-'),
      static_cast<int>('='), static_cast<int>('A'), static_cast<int>('C'), static_cast<int>('P'),
      static_cast<int>('T'), static_cast<int>('V'), static_cast<int>('H'), static_cast<int>('Q') })
  {
    ViewerState state;
    EXPECT_NE(state.Press(key, Plain), ViewerRequest::Nothing) << key;
  }
}

TEST(HudLayout, PartsLeaveSmallWindows)
{
  const HudLayout large(1280, 800, 1.0);
  EXPECT_TRUE(large.Times && large.Status && large.Arrow && large.Bar);
  EXPECT_GT(large.Sliders[0].Width, 0.0);
  EXPECT_GT(large.Sliders[0].Y, large.Sliders[1].Y);
  const HudLayout small(400, 200, 1.0);
  EXPECT_FALSE(small.Times);
  EXPECT_TRUE(small.Status);
  const HudLayout tiny(20, 10, 1.0);
  EXPECT_FALSE(tiny.Times || tiny.Status || tiny.Arrow || tiny.Bar);
  EXPECT_FALSE(tiny.Sliders[0].Contains(5.0, 5.0));
}

TEST(HudLayout, ScalesWithTheScreen)
{
  const HudLayout one(1280, 800, 1.0);
  const HudLayout two(2560, 1600, 2.0);
  EXPECT_EQ(two.FontSize, 2 * one.FontSize);
  EXPECT_NEAR(two.Sliders[0].Width, 2.0 * one.Sliders[0].Width, 1.0e-9);
  EXPECT_NEAR(two.ArrowCenter[0], 2.0 * one.ArrowCenter[0], 1.0e-9);
}

TEST(HudLayout, PartOfATrackIsClamped)
{
  const HudLayout layout(1280, 800, 1.0);
  const HudBox& track = layout.Tracks[0];
  EXPECT_EQ(layout.PartAt(0, track.X - 99.0), 0.0);
  EXPECT_NEAR(layout.PartAt(0, track.X + 0.25 * track.Width), 0.25, 1.0e-12);
  EXPECT_EQ(layout.PartAt(0, 1.0e9), 1.0);
}

TEST(ScaleBar, LengthsAreRound)
{
  EXPECT_NEAR(RoundLength(999.0), 500.0, 1.0e-9);
  EXPECT_NEAR(RoundLength(2500.0), 2000.0, 1.0e-9);
  EXPECT_NEAR(RoundLength(0.13), 0.1, 1.0e-12);
  EXPECT_EQ(RoundLength(0.0), 0.0);
  EXPECT_EQ(RoundLength(std::numeric_limits<double>::quiet_NaN()), 0.0);
  EXPECT_EQ(LengthText(500.0), "500 m");
  EXPECT_EQ(LengthText(2000.0), "2 km");
  EXPECT_EQ(LengthText(0.005), "5 mm");
}

// A plane that rises by a metre per metre to the east, with posts 10 m apart.
vtkSmartPointer<vtkImageData> Slope()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(21, 11, 1);
  image->SetSpacing(10.0, 10.0, 1.0);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Elevation");
  for (int row = 0; row < 11; ++row)
  {
    for (int column = 0; column < 21; ++column)
    {
      heights->InsertNextValue(10.0 * column);
    }
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

TEST(HeightRay, MeetsTheSlope)
{
  const auto slope = Slope();
  ScenePoint found;
  ASSERT_TRUE(FindGround(slope, 1.0, { { 0.0, 50.0, 120.0 } }, { { 200.0, 50.0, 20.0 } }, found));
  // The ray z = 120 - x / 2 meets z = x at 80.
  EXPECT_NEAR(found[0], 80.0, 10.0 * PlaceTolerance);
  EXPECT_NEAR(found[2], 80.0, 10.0 * PlaceTolerance);
  ASSERT_TRUE(FindGround(slope, 2.0, { { 0.0, 50.0, 120.0 } }, { { 200.0, 50.0, 20.0 } }, found));
  EXPECT_NEAR(found[0], 48.0, 10.0 * PlaceTolerance); // twice the heights
  ASSERT_TRUE(FindGround(slope, 1.0, { { 33.0, 44.0, 1e5 } }, { { 33.0, 44.0, -1e5 } }, found));
  EXPECT_NEAR(found[2], 33.0, 1.0e-9); // straight down
}

TEST(HeightRay, MissesWhatIsNotThere)
{
  const auto slope = Slope();
  ScenePoint found;
  EXPECT_FALSE(
    FindGround(slope, 1.0, { { 0.0, 500.0, 120.0 } }, { { 200.0, 500.0, 20.0 } }, found));
  EXPECT_FALSE(FindGround(slope, 1.0, { { 0.0, 50.0, 900.0 } }, { { 200.0, 50.0, 800.0 } }, found));
  EXPECT_TRUE(std::isnan(GroundAt(slope, 1.0, -1.0, 50.0)));
  EXPECT_EQ(GroundOrZero(slope, 1.0, -1.0, 50.0), 0.0);
  EXPECT_EQ(GroundAt(slope, 3.0, 200.0, 100.0), 600.0);
}

} // namespace
} // namespace skyline
