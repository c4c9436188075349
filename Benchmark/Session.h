// SPDX-License-Identifier: BSD-3-Clause
// A run of the benchmark: which scenes and methods, within which time.
#ifndef skyline_Session_h
#define skyline_Session_h

#include "Job.h"
#include "Stage.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace skyline
{
namespace benchmark
{

struct SessionOptions
{
  std::vector<std::string> Scenes;     ///< of SceneNames()
  std::vector<std::string> Rasters;    ///< files
  std::vector<std::string> Kinds;      ///< of Kinds(); empty: all
  std::vector<std::string> Quantities; ///< names of Quantities(); empty: all
  std::vector<int> Sizes{ 384 };       ///< posts of a side of the made scenes
  double Budget = 120.0;               ///< seconds after which no measurement begins
};

/// What came out.
struct Session
{
  std::vector<std::pair<std::string, std::string>> Machine; ///< names and values
  std::vector<std::pair<std::string, std::string>> Scenes;  ///< names and descriptions
  std::vector<Finding> Findings;                            ///< in the order of the jobs
  std::vector<Task> LeftOut;                                ///< for want of time
  double Seconds = 0.0;
  double Budget = 0.0; ///< SessionOptions::Budget
};

/// Told before every measurement: how many are done, how many there are, which comes.
using Tell = std::function<void(std::size_t done, std::size_t all, const std::string& what)>;

/// Measures. std::runtime_error if a raster cannot be read; if stopped, an unfinished session.
Session RunSession(const SessionOptions& options, const Tell& tell, const WantsToStop& stop);

} // namespace benchmark
} // namespace skyline

#endif
