// SPDX-License-Identifier: BSD-3-Clause
// What the user of the viewer has set: only numbers, no window, no VTK.
#ifndef skyline_ViewerState_h
#define skyline_ViewerState_h

#include "Sky/SkyDescription.h"
#include "SunClock.h"
#include "ViewerInput.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{

/// A lamp above the ground.
struct ViewerLamp
{
  double X = 0.0, Y = 0.0; ///< in the coordinates of the image of the height field
  double Height = 0.0;     ///< metres above the ground, exaggerated
  double Radius = 1.0;     ///< metres
  std::array<double, 3> Radiance{ { 1, 1, 1 } };

  bool operator==(const ViewerLamp& other) const
  {
    return this->X == other.X && this->Y == other.Y && this->Height == other.Height &&
      this->Radius == other.Radius && this->Radiance == other.Radiance;
  }
};

/// What a key requests that is not a number.
enum class ViewerRequest
{
  Nothing, ///< the key has no meaning
  Changed, ///< the state below has changed, or was at its limit
  Lamp,    ///< add a lamp under the mouse
  Png,     ///< write a screenshot
  Exr,     ///< write a screenshot in linear light
  Camera,  ///< return to the view at the start
  Leave
};

/// One of the two sliders.
struct ViewerSlider
{
  double Low = 0.0, High = 1.0, Value = 0.0;
  std::string Label;
};

/// The state, and how keys, sliders and drags change it.
struct ViewerState
{
  static constexpr double LeastExaggeration = 0.1;
  static constexpr double GreatestExaggeration = 20.0;
  static constexpr std::size_t Sliders = 2;

  bool ByTime = false; ///< the sun follows Clock; otherwise Azimuth and Elevation
  SunClock Clock;
  double Azimuth = 315.0;  ///< degrees from grid north
  double Elevation = 45.0; ///< degrees
  bool Sun = true;
  bool Animated = false;

  std::vector<SkyDescription> Skies{ SkyDescription() };
  std::size_t Sky = 0;
  double Rotation = 0.0; ///< degrees

  std::vector<ViewerLamp> Lamps;
  std::size_t Chosen = 0; ///< index of a lamp; Lamps.size() or more: none

  double Exaggeration = 1.0;
  bool AutoExposure = true;
  double MeteredStops = 0.0; ///< the automatic exposure of the present picture
  double FixedStops = 0.0;   ///< the fixed exposure
  double Exposure = 0.0;     ///< stops that are added to either
  std::size_t Colors = 0;
  std::size_t ColorCount = 1;

  bool Help = false;
  bool Times = true;

  ViewerRequest Press(int key, const Modifiers& with);

  ViewerSlider GetSlider(std::size_t which) const;
  void SetSlider(std::size_t which, double value);

  /// Moves the sun by parts of the width and height of the window: a day across, a year upwards.
  void DragSun(double across, double up);

  /// Advances the animation by seconds; a day takes half a minute.
  void Advance(double seconds);

  /// Adds a sky unless it is already there, and makes it the present one.
  void TakeSky(const SkyDescription& sky);

  const SkyDescription& GetSky() const { return this->Skies[this->Sky]; }

  /// The exposure of the picture.
  double Stops() const
  {
    return (this->AutoExposure ? this->MeteredStops : this->FixedStops) + this->Exposure;
  }

  void AddLamp(const ViewerLamp& lamp);
  bool HasChosen() const { return this->Chosen < this->Lamps.size(); }

private:
  void StepAcross(double steps, bool fine);
  void StepUp(int steps, bool fine);
  ViewerRequest ChangeLamp(int key);
};

} // namespace skyline

#endif
