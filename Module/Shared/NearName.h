// SPDX-License-Identifier: BSD-3-Clause
// What a misspelled name was meant to be.
#ifndef skyline_NearName_h
#define skyline_NearName_h

#include "SkylineCoreModule.h" // for the export macro

#include <string>
#include <vector>

namespace skyline
{

/// Of `names`, that which `word` was probably meant to be; empty if none is near.
SKYLINECORE_EXPORT std::string Nearest(
  const std::string& word, const std::vector<std::string>& names);

/// "; did you mean NAME?", or nothing.
SKYLINECORE_EXPORT std::string DidYouMean(
  const std::string& word, const std::vector<std::string>& names);

} // namespace skyline

#endif
