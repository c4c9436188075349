// SPDX-License-Identifier: BSD-3-Clause
// The events that a window sends to the viewer, independent of the window library.
#ifndef skyline_ViewerInput_h
#define skyline_ViewerInput_h

namespace skyline
{

/// A key: the capital letter or sign that is printed on it, or one of these.
enum ViewerKey : int
{
  KeyUnknown = 0,
  KeySpace = ' ',
  KeyEscape = 256,
  KeyDelete,
  KeyLeft,
  KeyRight,
  KeyUp,
  KeyDown,
  KeyPageUp,
  KeyPageDown,
  KeyHome
};

enum class MouseButton
{
  Left,
  Middle,
  Right
};

struct Modifiers
{
  bool Shift = false;
  bool Control = false;
};

/// What the keys and the mouse do, one line each, for the window and for --help.
inline const char* ViewerHelp()
{
  return "drag left           turn the camera\n"
         "drag middle, right  move the camera, zoom (or the wheel)\n"
         "drag a slider       time of day and date, or the sun's direction\n"
         "Ctrl + drag         the same anywhere: across for the hour, up for the day\n"
         "Left Right          10 minutes back, forward (Shift: 1); or the azimuth\n"
         "Up Down             a day forward, back (Shift: 30); or the elevation\n"
         "Space               animate a day, stop\n"
         "S                   sun on, off\n"
         "K                   next sky\n"
         "R, Shift + R        turn the sky or light map by 10 degrees\n"
         "drop a file         .hdr or .exr: the sky; any other: the DEM\n"
         "L                   place a lamp under the mouse\n"
         "drag a lamp         move it; with the right button: up, down\n"
         "[ ]  , .  Delete    the lamp chosen last: darker, brighter; smaller, larger; remove\n"
         "X, Shift + X        heights times 1.25, divided by 1.25\n"
         "- =  A              darker, brighter picture; fix the exposure, or make it automatic\n"
         "C                   next colours of heights\n"
         "P, Shift + P        screenshot as PNG, as EXR (linear light)\n"
         "T                   frame times\n"
         "V                   back to the first view\n"
         "H                   this help\n"
         "Escape, Q           end the program";
}

} // namespace skyline

#endif
