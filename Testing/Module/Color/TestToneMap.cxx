// SPDX-License-Identifier: BSD-3-Clause
#include "Color/ToneMap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using skyline::Rgb;

namespace
{

// The error of a few roundings of a float near 1.
constexpr float FloatTolerance = 1e-6f;

TEST(ToneMap, CurveSpreadsLightAroundGrey)
{
  EXPECT_EQ(skyline::ToneCurve(0.0f), 0.0f);
  EXPECT_NEAR(skyline::ToneCurve(skyline::ToneGrey), skyline::ToneGrey, FloatTolerance);
  // Half the light has 2^-1.3 = 0.406126 of the luminance.
  EXPECT_NEAR(
    skyline::ToneCurve(0.5f * skyline::ToneGrey), 0.406126f * skyline::ToneGrey, FloatTolerance);
}

TEST(ToneMap, CurveIsSmoothAtTheKnee)
{
  const double knee = skyline::ToneGrey *
    std::pow(skyline::ToneKnee / skyline::ToneGrey, 1.0 / skyline::ToneContrast);
  const double step = 1e-2;
  const double at = skyline::ToneCurve(static_cast<float>(knee));
  const double below = at - skyline::ToneCurve(static_cast<float>(knee - step));
  const double above = skyline::ToneCurve(static_cast<float>(knee + step)) - at;
  EXPECT_NEAR(at, skyline::ToneKnee, FloatTolerance);
  // The slope is 1.6 on both sides; within a step it changes by up to 6 %.
  EXPECT_NEAR(below, 1.3 * 0.5 / knee * step, 2e-4);
  EXPECT_NEAR(above, below, 1e-3);
}

TEST(ToneMap, CurveNeverFallsAndNeverBurnsOut)
{
  float before = 0.0f;
  for (float x = 1e-8f; x < 1e30f; x *= 1.01f)
  {
    const float y = skyline::ToneCurve(x);
    EXPECT_GE(y, before) << x;
    EXPECT_LE(y, skyline::ToneWhite) << x;
    before = y;
  }
}

TEST(ToneMap, LightThatIsNoneOrTooMuch)
{
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(skyline::ToneCurve(nan), 0.0f);
  EXPECT_EQ(skyline::ToneCurve(-1.0f), 0.0f);
  EXPECT_EQ(skyline::ToneCurve(infinity), skyline::ToneWhite);
  for (const Rgb& light : { Rgb{ { nan, nan, nan } }, Rgb{ { -1.0f, 0.0f, -1e30f } } })
  {
    EXPECT_EQ(skyline::ToneMap(light), (Rgb{ { 0.0f, 0.0f, 0.0f } }));
  }
  for (const Rgb& light : { Rgb{ { infinity, 0.0f, 0.0f } },
         Rgb{ { infinity, infinity, infinity } }, Rgb{ { 0.0f, 3e38f, 3e38f } } })
  {
    for (float channel : skyline::ToneMap(light))
    {
      EXPECT_GE(channel, 0.0f);
      EXPECT_LE(channel, skyline::ToneWhite);
    }
  }
}

TEST(ToneMap, ColoursKeepTheirLuminanceAndTheirOrder)
{
  for (const Rgb& hue : { Rgb{ { 1.0f, 0.9f, 0.7f } }, Rgb{ { 1.0f, 0.0f, 0.0f } },
         Rgb{ { 0.0f, 0.0f, 1.0f } }, Rgb{ { 0.2f, 0.9f, 0.3f } } })
  {
    float before = 0.0f;
    for (float gain = 1e-3f; gain < 1e4f; gain *= 1.3f)
    {
      const Rgb light{ { gain * hue[0], gain * hue[1], gain * hue[2] } };
      const Rgb tone = skyline::ToneMap(light);
      const float luminance = skyline::Luminance(tone);
      EXPECT_NEAR(luminance, skyline::ToneCurve(skyline::Luminance(light)), FloatTolerance);
      EXPECT_GE(luminance, before - FloatTolerance);
      before = luminance;
      for (std::size_t c = 0; c < 3; ++c)
      {
        EXPECT_LE(tone[c], skyline::ToneWhite);
        EXPECT_GE(tone[c], 0.0f);
        for (std::size_t k = 0; k < 3; ++k)
        {
          EXPECT_TRUE(hue[c] < hue[k] || tone[c] >= tone[k]) << "the order of the channels changed";
        }
      }
    }
  }
}

TEST(ToneMap, GreyStaysGrey)
{
  const Rgb tone = skyline::ToneMap(Rgb{ { 2.0f, 2.0f, 2.0f } });
  EXPECT_NEAR(tone[0], tone[1], FloatTolerance);
  EXPECT_NEAR(tone[1], tone[2], FloatTolerance);
}

TEST(ToneMap, SrgbCodes)
{
  // IEC 61966-2-1: 0.5 encodes to 0.735357, 0.18 to 0.461356; the two branches meet at 0.04045.
  EXPECT_NEAR(skyline::EncodeSrgb(0.5f), 0.735357f, 2e-6f);
  EXPECT_NEAR(skyline::EncodeSrgb(0.18f), 0.461356f, 2e-6f);
  EXPECT_NEAR(skyline::EncodeSrgb(0.0031308f), 0.04045f, 2e-6f);
  for (int code = 0; code < 256; ++code)
  {
    const float linear = skyline::DecodeSrgb(static_cast<float>(code) / 255.0f);
    EXPECT_EQ(static_cast<int>(skyline::SrgbByte(linear)), code);
  }
  EXPECT_EQ(skyline::SrgbByte(-1.0f), 0);
  EXPECT_EQ(skyline::SrgbByte(2.0f), 255);
  EXPECT_EQ(skyline::SrgbByte(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_LT(skyline::SrgbByte(skyline::ToneWhite), 255);
}

} // namespace
