// SPDX-License-Identifier: BSD-3-Clause
#include "SunScore.h"

#include "Similarity.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace skyline
{
namespace benchmark
{

SunScore::SunScore(ReferenceScene& reference, Kind kind)
  : Field(reference.Scene.Field)
  , Right(reference.SunHorizons())
  , Side(reference.WindowSide())
  , What(kind)
{
}

void SunScore::Add(std::size_t sun, const SunOf& found)
{
  std::vector<double> picture, rightPicture;
  for (std::size_t i = 0; i < this->Right.Posts.size(); ++i)
  {
    const std::ptrdiff_t post = this->Right.Posts[i];
    const double elevation = this->Right.Elevation(sun, i);
    if (!std::isfinite(elevation))
    {
      picture.push_back(0.0);
      rightPicture.push_back(0.0);
      continue;
    }
    const bool isLit = elevation < Suns[sun].Elevation;
    const double incidence = this->Incidence(post, Suns[sun]);
    const double value = found(static_cast<std::size_t>(post));
    this->Posts += 1.0;
    if (this->What == Kind::Beam)
    {
      this->FoundBeams.push_back(value);
      this->RightBeams.push_back(isLit ? incidence : 0.0);
      picture.push_back(this->FoundBeams.back());
      rightPicture.push_back(this->RightBeams.back());
      this->Wrong += (picture.back() > 0.0) == (rightPicture.back() > 0.0) ? 0.0 : 1.0;
      continue;
    }
    const double shade = 0.2 + 0.8 * incidence; // never black, so that shadows show
    picture.push_back(value > 0.0 ? shade : 0.0);
    rightPicture.push_back(isLit ? shade : 0.0);
    this->Wrong += (value > 0.0) == isLit ? 0.0 : 1.0;
  }
  this->Similarities += StructuralSimilarity(picture, rightPicture, this->Side);
}

void SunScore::Report(Result& result) const
{
  if (this->What == Kind::Beam)
  {
    const auto count = static_cast<double>(this->RightBeams.size());
    const double mean =
      std::accumulate(this->RightBeams.begin(), this->RightBeams.end(), 0.0) / count;
    ErrorSum errors;
    for (std::size_t i = 0; i < this->RightBeams.size(); ++i)
    {
      errors.Add(100.0 * this->FoundBeams[i] / mean, 100.0 * this->RightBeams[i] / mean);
    }
    result.Error = errors.Get();
  }
  result.WrongPercent = 100.0 * this->Wrong / this->Posts;
  result.Similarity = this->Similarities / static_cast<double>(Suns.size());
  result.Error.Samples = this->Posts;
  result.PrepareNs = result.SearchNs = NotMeasured;
  result.Ran = true;
}

double SunScore::Incidence(std::ptrdiff_t post, const SunAt& sun) const
{
  double east = 0.0, north = 0.0;
  oracle::Gradient(
    this->Field, post % this->Field.Columns, post / this->Field.Columns, east, north);
  const double azimuth = sun.Azimuth * RadiansPerDegree;
  const double elevation = sun.Elevation * RadiansPerDegree;
  const double cosine =
    (std::sin(elevation) -
      std::cos(elevation) * (east * std::sin(azimuth) + north * std::cos(azimuth))) /
    std::sqrt(1.0 + east * east + north * north);
  return std::max(0.0, cosine);
}

} // namespace benchmark
} // namespace skyline
