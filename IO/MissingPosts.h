// SPDX-License-Identifier: BSD-3-Clause
// Which values of a band mark missing posts.
#ifndef skyline_MissingPosts_h
#define skyline_MissingPosts_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace skyline
{

/// The values that mark missing posts, rounded to the type T of the band: float or double. NaN and
/// infinite values are always missing.
template <typename T>
class MissingPosts
{
public:
  explicit MissingPosts(const std::vector<double>& declared)
  {
    for (const double value : declared)
    {
      // A value that T cannot hold is the lowest number of a wider type. It became the lowest
      // number of T when the posts were converted.
      constexpr auto most = static_cast<double>(std::numeric_limits<T>::max());
      const bool finite = std::isfinite(value);
      const double held = finite ? std::clamp(value, -most, most) : value;
      const bool huge = finite && std::abs(held) > Huge;
      this->Values.push_back(static_cast<T>(held));
      this->Slacks.push_back(huge ? static_cast<T>(HugeTolerance * std::abs(held)) : T(0));
      this->Found.push_back(0);
    }
  }

  bool operator()(T raw)
  {
    if (!std::isfinite(raw))
    {
      for (std::size_t i = 0; i < this->Values.size(); ++i)
      {
        this->Found[i] += !std::isfinite(this->Values[i]) ? 1 : 0;
      }
      return true;
    }
    bool missing = false;
    for (std::size_t i = 0; i < this->Values.size(); ++i)
    {
      if (raw == this->Values[i] || std::abs(raw - this->Values[i]) < this->Slacks[i])
      {
        ++this->Found[i];
        missing = true;
      }
    }
    return missing;
  }

  /// The number of posts that had the i-th declared value.
  std::int64_t GetFound(std::size_t i) const { return this->Found[i]; }

private:
  /// A value beyond this is the lowest float of some program, often printed with six digits.
  static constexpr double Huge = 1e30;
  static constexpr double HugeTolerance = 1e-5;

  std::vector<T> Values, Slacks;
  std::vector<std::int64_t> Found;
};

} // namespace skyline

#endif
