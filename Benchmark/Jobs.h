// SPDX-License-Identifier: BSD-3-Clause
// The list of the measurements of all quantities on a scene.
#ifndef skyline_Jobs_h
#define skyline_Jobs_h

#include "Job.h"
#include "ReferenceScene.h"
#include "vtkHeightFieldAlgorithm.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// Turns: the order of the measurements when time is short. For a less important scene, Session.cxx
/// adds to them.
constexpr int MainTurn = 0;   ///< the main setting of each family of methods
constexpr int PeerTurn = 1;   ///< other programs, and second settings
constexpr int DeviceTurn = 2; ///< the graphics processor, which may be emulated on this processor
constexpr int SweepTurn = 3;  ///< further values of a parameter
constexpr int LastTurn = 6;   ///< programs that take minutes

/// The methods of vtkHeightFieldAlgorithm, with the names that --methods accepts.
struct SearchMethod
{
  const char* Name;
  int Method;
};
constexpr SearchMethod Searches[] = { { "exact", vtkHeightFieldAlgorithm::EXACT },
  { "fast", vtkHeightFieldAlgorithm::FAST }, { "sweep", vtkHeightFieldAlgorithm::SWEEP },
  { "pyramid", vtkHeightFieldAlgorithm::PYRAMID } };

using ReferenceScenePointer = std::shared_ptr<ReferenceScene>;

/// Adds a job on a scene. The other arguments are those of Task and Job.
void AddJob(std::vector<Job>& jobs, const ReferenceScenePointer& reference, const char* quantity,
  const char* kind, const std::string& label, const std::string& settings, int turn,
  std::function<void()> prepare, std::function<Result()> measure);

/// `much`: whether to add further settings and the graphics processor.
void AddHorizonJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference, bool much);
void AddSkyJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference);
void AddThreadJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference);
void AddIrradianceJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference);
void AddSunJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference);
void AddBeamJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference);
void AddLampJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference);
void AddFrameJobs(std::vector<Job>& jobs, const ReferenceScenePointer& reference);

} // namespace benchmark
} // namespace skyline

#endif
