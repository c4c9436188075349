// SPDX-License-Identifier: BSD-3-Clause
// How a picture of the terrain looks: its sky, colours, exposure and heights.
#ifndef skyline_LookOptions_h
#define skyline_LookOptions_h

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace skyline
{

/// --environment, --colors, --exposure, --exaggeration.
struct LookOptions
{
  LookOptions();

  std::string Environment = "uniform";
  std::string Colors;
  std::optional<double> Exposure; ///< stops; none: automatic
  double Exaggeration = 1.0;
  void AddSkyTo(CLI::App& command); ///< --environment alone
  void AddTo(CLI::App& command);    ///< the others
};

} // namespace skyline

#endif
