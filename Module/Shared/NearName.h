// SPDX-License-Identifier: BSD-3-Clause
// Suggestions for misspelled names.
#ifndef skyline_NearName_h
#define skyline_NearName_h

#include "SkylineCoreModule.h" // for the export macro

#include <string>
#include <vector>

namespace skyline
{

/// The one of `names` that `word` probably means; empty if none is similar.
SKYLINECORE_EXPORT std::string Nearest(
  const std::string& word, const std::vector<std::string>& names);

/// Returns "; did you mean NAME?", or an empty text if no name is similar.
SKYLINECORE_EXPORT std::string DidYouMean(
  const std::string& word, const std::vector<std::string>& names);

} // namespace skyline

#endif
