// SPDX-License-Identifier: BSD-3-Clause
// From linear light to the values of a picture. Pure functions, without VTK.
#ifndef skyline_ToneMap_h
#define skyline_ToneMap_h

#include <algorithm>
#include <array>
#include <cmath>

namespace skyline
{

using Rgb = std::array<float, 3>; ///< linear light, Rec. 709 primaries

/// Linear level that no tone-mapped channel exceeds: code 251 of 255 after encoding.
constexpr float ToneWhite = 0.96f;

/// Middle grey, which the tone curve does not change, and the exponent that spreads the luminances
/// around it, which sets the contrast.
constexpr float ToneGrey = 0.18f;
constexpr float ToneContrast = 1.3f;

/// Results of the tone curve above this level lie on its shoulder.
constexpr float ToneKnee = 0.5f;

/// Luminance of linear light, Rec. ITU-R BT.709-6, item 3.2.
inline float Luminance(const Rgb& c)
{
  return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2];
}

/// The tone curve: maps a luminance (0 or more) to a luminance in [0, ToneWhite). It is a power law
/// through ToneGrey up to ToneKnee, then a hyperbola that continues with the same slope and tends
/// to ToneWhite. The curve never falls. NaN and negative light give 0, infinite light gives
/// ToneWhite.
inline float ToneCurve(float luminance)
{
  if (!(luminance > 0.0f))
  {
    return 0.0f;
  }
  const float spread = ToneGrey * std::pow(luminance / ToneGrey, ToneContrast);
  if (spread <= ToneKnee)
  {
    return spread;
  }
  constexpr float room = ToneWhite - ToneKnee;
  return ToneWhite - room / (1.0f + (spread - ToneKnee) / room);
}

/// Tone-maps a colour: applies ToneCurve to its luminance and keeps its hue. If a channel would
/// exceed ToneWhite, the colour is mixed with grey of the same luminance, as bright colours appear
/// paler to the eye.
inline Rgb ToneMap(const Rgb& light)
{
  Rgb c = light;
  for (float& channel : c)
  {
    // Infinite light would give inf / inf below. 1e25 is mapped to the same white, and its power is
    // finite.
    channel = channel > 0.0f ? std::min(channel, 1.0e25f) : 0.0f;
  }
  const float before = Luminance(c);
  if (!(before > 0.0f))
  {
    return Rgb{ { 0.0f, 0.0f, 0.0f } };
  }
  const float after = ToneCurve(before);
  float brightest = 0.0f;
  for (float& channel : c)
  {
    channel = channel / before * after;
    brightest = std::max(brightest, channel);
  }
  if (brightest > ToneWhite)
  {
    const float kept = (ToneWhite - after) / (brightest - after);
    for (float& channel : c)
    {
      channel = std::clamp(after + kept * (channel - after), 0.0f, ToneWhite);
    }
  }
  return c;
}

/// Encodes linear light in [0, 1] as an sRGB code in [0, 1], IEC 61966-2-1. Values outside are
/// clamped.
inline float EncodeSrgb(float linear)
{
  if (!(linear > 0.0f))
  {
    return 0.0f;
  }
  if (linear >= 1.0f)
  {
    return 1.0f;
  }
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// Decodes an sRGB code in [0, 1] to linear light: the inverse of EncodeSrgb.
inline float DecodeSrgb(float code)
{
  if (!(code > 0.0f))
  {
    return 0.0f;
  }
  if (code >= 1.0f)
  {
    return 1.0f;
  }
  return code <= 0.04045f ? code / 12.92f : std::pow((code + 0.055f) / 1.055f, 2.4f);
}

/// The sRGB code of a linear value as a byte, rounded to the nearest.
inline unsigned char SrgbByte(float linear)
{
  return static_cast<unsigned char>(std::lround(255.0f * EncodeSrgb(linear)));
}

} // namespace skyline

#endif
