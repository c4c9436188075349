// SPDX-License-Identifier: BSD-3-Clause
#include "GpuWedgeText.h"

#include "GpuHorizons.h"
#include "Harmonics/ElevationIntegral.h"
#include "Harmonics/SphericalHarmonics.h"
#include "ShaderText.h"

#include <array>
#include <cstdio>

namespace skyline
{

namespace
{

std::string Number(double value)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9e", value);
  return text.data();
}

/// The integral in all four azimuths, in terms of s, c, q = s s, sc = s c and the angle h.
std::string IntegralText(const ElevationIntegral& integral)
{
  std::string p = Number(integral.Polynomial[static_cast<std::size_t>(integral.Terms - 1)]);
  for (int k = integral.Terms - 2; k >= 0; --k)
  {
    p.insert(0, "(");
    p.append(" * q + ")
      .append(Number(integral.Polynomial[static_cast<std::size_t>(k)]))
      .append(")");
  }
  switch (integral.Kind)
  {
    case ElevationKind::Sine:
      return "s * " + p;
    case ElevationKind::Square:
      return "q * " + p;
    case ElevationKind::SineCosine:
      return Number(integral.Constant) + " * h + sc * " + p;
    case ElevationKind::Cosine:
      break;
  }
  // With this form the integral of level ground is exactly 0.
  return Number(-integral.Polynomial[0]) + " + c * " + p;
}

void Replace(std::string& text, const std::string& what, const std::string& with)
{
  const std::size_t at = text.find(what);
  text.replace(at, what.size(), with);
}

std::string Index(int i)
{
  return std::to_string(i);
}

} // namespace

std::string WedgeText(int bands, bool transfer, int begin, int end)
{
  std::string sums;
  const int images = (end - begin + CoefficientsPerImage - 1) / CoefficientsPerImage;
  for (int i = 0; i < images; ++i)
  {
    sums += "  vec4 lost" + Index(i) + " = vec4(0.0);\n";
  }
  sums += "  vec4 up0, ahead0, along, alongMinus;\n";
  const auto add = [&](int coefficient, const std::string& value)
  {
    if (coefficient >= begin && coefficient < end)
    {
      const int i = coefficient - begin;
      sums += "  lost" + Index(i / CoefficientsPerImage) + "[" + Index(i % CoefficientsPerImage) +
        "] += " + value + ";\n";
    }
  };
  const auto visible = ElevationIntegrals(bands, ElevationWeight::One);
  const auto upward = ElevationIntegrals(bands, ElevationWeight::Upward);
  const auto forward = ElevationIntegrals(bands, ElevationWeight::Forward);
  std::size_t index = 0;
  for (int m = 0; m < bands; ++m)
  {
    const auto weight = [m](int which) { return "Weight(" + Index(m) + ", " + Index(which) + ")"; };
    if (transfer)
    {
      sums += "  along = gradient.x * " + weight(2) + " + gradient.y * " + weight(4) + ";\n";
      sums += "  alongMinus = gradient.x * " + weight(3) + " + gradient.y * " + weight(5) + ";\n";
    }
    for (int l = m; l < bands; ++l, ++index)
    {
      const int plus = HarmonicIndex(l, m);
      const int minus = HarmonicIndex(l, -m);
      if ((plus < begin || plus >= end) && (minus < begin || minus >= end))
      {
        continue;
      }
      sums += "  up0 = " + IntegralText((transfer ? upward : visible)[index]) + ";\n";
      if (transfer)
      {
        sums += "  ahead0 = " + IntegralText(forward[index]) + ";\n";
      }
      add(plus, "dot(" + weight(0) + ", up0)" + (transfer ? " - dot(along, ahead0)" : ""));
      if (m > 0)
      {
        add(minus, "dot(" + weight(1) + ", up0)" + (transfer ? " - dot(alongMinus, ahead0)" : ""));
      }
    }
  }
  for (int i = 0; i < images; ++i)
  {
    const std::string wholes = "wholes[" + Index(i) + "] + gradient.x * wholes[" +
      Index(ImagesPerPass + i) + "] + gradient.y * wholes[" + Index(2 * ImagesPerPass + i) + "]";
    sums +=
      "  gl_FragData[" + Index(i) + "] = up * (whole * (" + wholes + ") - lost" + Index(i) + ");\n";
  }
  std::string text = ShaderPart(skyline_GpuWedges, "Sum");
  Replace(text, "  //Fill::Plane\n", transfer ? ShaderPart(skyline_GpuWedges, "Plane") : "");
  Replace(text, "  //Fill::Integrals\n", sums);
  return GpuText({ ShaderPart(skyline_GpuAngles), ShaderPart(skyline_GpuWedges),
    transfer ? ShaderPart(skyline_GpuWedges, "Transfer") : "", text });
}

std::string LightText(int imageCount)
{
  std::string text = ShaderPart(skyline_GpuLight);
  std::string images, sum;
  for (int i = 0; i < imageCount; ++i)
  {
    images += "uniform sampler2D image" + Index(i) + ";\n";
    sum += "  vec4 t" + Index(i) + " = texelFetch(image" + Index(i) + ", at, 0);\n  sum += vec3(";
    for (int c = 0; c < 3; ++c)
    {
      sum += (c > 0 ? ", " : "") + std::string("dot(t") + Index(i) + ", light[" + Index(3 * i + c) +
        "])";
    }
    sum += ");\n";
  }
  Replace(text, "//Fill::Images\n", images);
  Replace(text, "  //Fill::Sum\n", sum);
  return GpuText({ text });
}

} // namespace skyline
