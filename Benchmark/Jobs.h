// SPDX-License-Identifier: BSD-3-Clause
// The measurements of every quantity on a scene, in one list.
#ifndef skyline_Jobs_h
#define skyline_Jobs_h

#include "Job.h"
#include "Stage.h"
#include "vtkHeightFieldAlgorithm.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// Turns: what comes first when time is short. A scene that matters less adds to them (Session.cxx).
constexpr int MainTurn = 0;   ///< the main setting of a family of methods
constexpr int PeerTurn = 1;   ///< other programs, second settings
constexpr int DeviceTurn = 2; ///< the graphics processor, which may be this processor in disguise
constexpr int SweepTurn = 3;  ///< further values of a parameter
constexpr int LastTurn = 6;   ///< programs that take minutes

/// The methods of vtkHeightFieldAlgorithm, with their names in --methods.
struct SearchMethod
{
  const char* Name;
  int Method;
};
constexpr SearchMethod Searches[] = { { "exact", vtkHeightFieldAlgorithm::EXACT },
  { "fast", vtkHeightFieldAlgorithm::FAST }, { "sweep", vtkHeightFieldAlgorithm::SWEEP },
  { "pyramid", vtkHeightFieldAlgorithm::PYRAMID } };

using StagePointer = std::shared_ptr<Stage>;

/// A job on a stage; the other arguments are those of Task and Job.
void AddJob(std::vector<Job>& jobs, const StagePointer& stage, const char* quantity,
  const char* kind, const std::string& label, const std::string& settings, int turn,
  std::function<void()> prepare, std::function<Result()> measure);

/// much: further settings, and the graphics processor.
void AddHorizonJobs(std::vector<Job>& jobs, const StagePointer& stage, bool much);
void AddSkyJobs(std::vector<Job>& jobs, const StagePointer& stage);
void AddThreadJobs(std::vector<Job>& jobs, const StagePointer& stage);
void AddIrradianceJobs(std::vector<Job>& jobs, const StagePointer& stage);
void AddSunJobs(std::vector<Job>& jobs, const StagePointer& stage);
void AddBeamJobs(std::vector<Job>& jobs, const StagePointer& stage);
void AddLampJobs(std::vector<Job>& jobs, const StagePointer& stage);
void AddFrameJobs(std::vector<Job>& jobs, const StagePointer& stage);

} // namespace benchmark
} // namespace skyline

#endif
