// SPDX-License-Identifier: BSD-3-Clause
// How a picture of the terrain looks: its sky, colours, exposure and heights.
#ifndef skyline_LookOptions_h
#define skyline_LookOptions_h

#include <CLI/CLI.hpp>

#include <string>

namespace skyline
{

/// --environment, --colors, --exposure, --exaggeration.
struct LookOptions
{
  LookOptions();

  std::string Environment = "uniform";
  std::string Colors;
  std::string Exposure = "auto";
  double Exaggeration = 1.0;
  void AddSkyTo(CLI::App& command); ///< --environment alone
  void AddTo(CLI::App& command);    ///< the others

  /// Throws Failure for numbers out of range; before any work.
  void Check() const;
};

} // namespace skyline

#endif
