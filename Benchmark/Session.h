// SPDX-License-Identifier: BSD-3-Clause
// A run of the benchmark: its scenes, methods and time.
#ifndef skyline_Session_h
#define skyline_Session_h

#include "Job.h"
#include "ReferenceScene.h"

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
  std::vector<std::string> Scenes;     ///< names of SceneNames()
  std::vector<std::string> Rasters;    ///< files
  std::vector<std::string> Kinds;      ///< names of Kinds(); empty for all
  std::vector<std::string> Quantities; ///< names of Quantities(); empty for all
  std::vector<int> Sizes{ 384 };       ///< sides of the made scenes, in posts
  double Budget = 120.0;               ///< after this many seconds no measurement begins
};

/// The results of a run.
struct Session
{
  std::vector<std::pair<std::string, std::string>> Machine; ///< names and values
  std::vector<std::pair<std::string, std::string>> Scenes;  ///< names and descriptions
  std::vector<Finding> Findings;                            ///< in the order of the jobs
  std::vector<Task> LeftOut;                                ///< omitted for lack of time
  double Seconds = 0.0;
  double Budget = 0.0; ///< SessionOptions::Budget
};

/// Called before each measurement with the number of finished ones, the number of all, and a text
/// about the next one.
using ProgressFunction =
  std::function<void(std::size_t done, std::size_t all, const std::string& what)>;

/// Runs the measurements. Throws std::runtime_error if a raster cannot be read. If stopped, returns
/// an unfinished session.
Session RunSession(
  const SessionOptions& options, const ProgressFunction& tell, const WantsToStop& stop);

} // namespace benchmark
} // namespace skyline

#endif
