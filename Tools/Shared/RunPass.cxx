// SPDX-License-Identifier: BSD-3-Clause
#include "RunPass.h"

#include "Data/ErrorReason.h"
#include "Failure.h"
#include "Interrupt.h"
#include "IoFailure.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkHeightFieldAlgorithm.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include <unistd.h>

namespace
{

// The first error and all warnings of the present pass.
struct Messages
{
  std::string Error;
  std::vector<std::string> Warnings;

  void KeepError(const char* text)
  {
    if (this->Error.empty() && text)
    {
      this->Error = skyline::ReasonOf(text);
    }
  }
  void KeepWarning(const char* text)
  {
    if (text)
    {
      this->Warnings.push_back(skyline::ReasonOf(text));
    }
  }
};

Messages& KeptMessages()
{
  static Messages messages;
  return messages;
}

// Discards the output of objects that have no observer.
class SilentWindow : public vtkOutputWindow
{
public:
  static SilentWindow* New();
  vtkTypeMacro(SilentWindow, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override { KeptMessages().KeepError(text); }
  void DisplayWarningText(const char* text) override { KeptMessages().KeepWarning(text); }
  void DisplayGenericWarningText(const char* text) override { KeptMessages().KeepWarning(text); }
  void DisplayDebugText(const char*) override {}
};
vtkStandardNewMacro(SilentWindow);

// A progress bar in one line of the terminal.
class ProgressBar
{
public:
  ProgressBar(const std::string& title, bool shown)
    : Title(title)
    , Shown(shown)
  {
  }
  ~ProgressBar()
  {
    if (this->Percent >= 0)
    {
      std::fputs("\r\033[K", stderr);
    }
  }
  void Show(double progress)
  {
    const int percent = static_cast<int>(std::floor(100.0 * std::clamp(progress, 0.0, 1.0)));
    if (!this->Shown || percent == this->Percent)
    {
      return;
    }
    this->Percent = percent;
    constexpr int width = 40;
    const std::string done(static_cast<std::size_t>(percent * width / 100), '=');
    std::fprintf(
      stderr, "\r%-14s [%-*s] %3d %%", this->Title.c_str(), width, done.c_str(), percent);
  }

private:
  std::string Title;
  bool Shown;
  int Percent = -1;
};

// Returns how many of `wanted` threads the system allows, including the current one.
int CountThreads(int wanted)
{
  std::mutex gate;
  std::vector<std::thread> others;
  {
    const std::lock_guard<std::mutex> closed(gate); // all wait until the last has begun
    try
    {
      others.reserve(static_cast<std::size_t>(wanted));
      while (static_cast<int>(others.size()) + 1 < wanted)
      {
        others.emplace_back([&gate] { const std::lock_guard<std::mutex> lock(gate); });
      }
    }
    catch (const std::exception&)
    {
      // The system allows no more threads, or there is no memory for one.
    }
  }
  for (std::thread& other : others)
  {
    other.join();
  }
  return static_cast<int>(others.size()) + 1;
}

// Observes one algorithm.
class MessageObserver : public vtkCommand
{
public:
  static MessageObserver* New() { return new MessageObserver; }
  void Execute(vtkObject* caller, unsigned long event, void* data) override
  {
    switch (event)
    {
      case vtkCommand::ErrorEvent:
        KeptMessages().KeepError(static_cast<const char*>(data));
        break;
      case vtkCommand::WarningEvent:
        KeptMessages().KeepWarning(static_cast<const char*>(data));
        break;
      default:
        if (vtkAlgorithm* algorithm = vtkAlgorithm::SafeDownCast(caller))
        {
          const double progress = algorithm->GetProgress();
          this->Progress->Show(progress);
          if (skyline::Interrupted() && progress < 1.0) // a file that is complete stays
          {
            algorithm->SetAbortExecute(1);
          }
        }
    }
  }
  ProgressBar* Progress = nullptr;
};

} // namespace

namespace skyline
{

void PrepareVtk(const CommonOptions& common)
{
  vtkNew<SilentWindow> window;
  vtkOutputWindow::SetInstance(window);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  // More threads than processors have no use, and TBB would print a warning about them.
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int wanted = common.Threads > 0 ? std::min(common.Threads, processors) : processors;
  const int threads = CountThreads(wanted);
  if (threads == 1)
  {
    vtkSMPTools::SetBackend("Sequential"); // TBB ends a program that gets no thread
  }
  else if (threads < processors)
  {
    vtkSMPTools::Initialize(threads);
  }
  // The number of threads that Mesa starts if it draws on the processor.
  ::setenv("LP_NUM_THREADS", std::to_string(threads == 1 ? 0 : threads).c_str(), 0);
}

void PrintWarning(const std::string& text, const CommonOptions& common)
{
  static std::set<std::string> printed;
  if (!common.Quiet && printed.insert(text).second)
  {
    std::fprintf(stderr, "warning: %s\n", text.c_str());
  }
}

std::string ReasonOf(const std::string& text)
{
  return FirstLine(ErrorReason(text));
}

void RunPass(vtkAlgorithm* algorithm, const std::string& title, const CommonOptions& common,
  const std::function<void()>& update)
{
  StopIfInterrupted();
  KeptMessages() = Messages();
  const auto start = std::chrono::steady_clock::now();
  {
    ProgressBar bar(title, !common.Quiet && isatty(STDERR_FILENO) != 0);
    vtkNew<MessageObserver> watch;
    watch->Progress = &bar;
    algorithm->AddObserver(vtkCommand::ErrorEvent, watch);
    algorithm->AddObserver(vtkCommand::WarningEvent, watch);
    algorithm->AddObserver(vtkCommand::ProgressEvent, watch);
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, watch);
    if (update)
    {
      update();
    }
    else
    {
      algorithm->Update();
    }
    algorithm->RemoveObserver(watch);
    algorithm->GetExecutive()->RemoveObserver(watch);
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  if (algorithm->GetAbortExecute())
  {
    StopIfInterrupted();
  }
  if (!KeptMessages().Error.empty())
  {
    throw Failure(KeptMessages().Error);
  }
  if (algorithm->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw Failure(title + " failed without a reason");
  }
  for (const std::string& warning : KeptMessages().Warnings)
  {
    PrintWarning(warning, common);
  }
  if (common.Verbose)
  {
    std::fprintf(stderr, "%-14s %8.3f s", title.c_str(), time.count());
    if (auto* horizons = vtkHeightFieldAlgorithm::SafeDownCast(algorithm))
    {
      std::fprintf(stderr, " (bounds %.3f s, search %.3f s)", horizons->GetPrepareSeconds(),
        horizons->GetSearchSeconds());
    }
    std::fputc('\n', stderr);
  }
}

} // namespace skyline
