// SPDX-License-Identifier: BSD-3-Clause
// Options for the look of a picture: colours, exposure and exaggeration of heights.
#ifndef skyline_LookOptions_h
#define skyline_LookOptions_h

#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace skyline
{

/// --colors, --exposure, --exaggeration.
struct LookOptions
{
  LookOptions();

  std::string Colors;
  std::optional<double> Exposure; ///< stops; empty: automatic
  double Exaggeration = 1.0;
  void AddTo(CLI::App& command);
};

} // namespace skyline

#endif
