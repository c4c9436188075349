// SPDX-License-Identifier: BSD-3-Clause
// The parts of a warning about doubtful input.
#ifndef skyline_Doubt_h
#define skyline_Doubt_h

#include <string>

namespace skyline
{

/// Input that can be used although it may not mean what it seems to mean. All warnings of Skyline
/// have these three parts; Warnings.h raises them.
struct Doubt
{
  std::string Finding;    ///< what was found: "12 posts of 'dem.tif' have the height -9999"
  std::string Assumption; ///< what is assumed: "these are heights"
  std::string Cure;       ///< the option that changes this: "--nodata -9999"; empty if there is
                          ///< none
};

/// The sentence: "FINDING; assuming ASSUMPTION; use CURE to say otherwise".
inline std::string DoubtText(const Doubt& doubt)
{
  const std::string text = doubt.Finding + "; assuming " + doubt.Assumption;
  return doubt.Cure.empty() ? text : text + "; use " + doubt.Cure + " to say otherwise";
}

} // namespace skyline

#endif
