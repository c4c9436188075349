// SPDX-License-Identifier: BSD-3-Clause
// Counts the passes that run if nothing, the light, the camera or the terrain changes. Writes the
// tables of Documentation/leave-out.md, or checks the counts in them.
//   SkylineLeaveOut --write FILE [SIZE]   SkylineLeaveOut --check FILE
#include "Measure.h"
#include "SceneImage.h"
#include "Scenes.h"
#include "SizeArgument.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSkylineSunLight.h"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace skyline::benchmark;

constexpr int Azimuths = 32;
constexpr int SmallSize = 64; // the counts do not depend on it
const char* const Begin = "<!-- SkylineLeaveOut writes from here -->";
const char* const End = "<!-- to here -->";

enum Lights
{
  Sun = 1,
  Sky = 2,
  Lamp = 4
};

void Count(vtkObject*, unsigned long, void* executions, void*)
{
  ++*static_cast<int*>(executions);
}

// The frames of one scene.
class Show
{
public:
  Show(int lights, bool harmonics, std::ptrdiff_t size)
    : Size(size)
    , Image(ImageOf(MovingTerrain(size, 0.0)))
  {
    this->Filter->SetInputData(this->Image);
    this->Filter->SetNumberOfAzimuths(Azimuths);
    this->Filter->SetLightMethod(
      harmonics ? vtkHeightFieldIrradiance::HARMONICS : vtkHeightFieldIrradiance::TABLE);
    this->Filter->SetKeepHorizons(!harmonics);
    this->SkyLight->SetSourceToCie();
    const double middle = 15.0 * static_cast<double>(size);
    this->LampLight->SetPosition(middle, middle, 1200.0);
    this->LampLight->SetRadius(50.0);
    if (lights & Sun)
    {
      this->Filter->AddLight(this->SunLight);
    }
    if (lights & Sky)
    {
      this->Filter->AddLight(this->SkyLight);
    }
    if (lights & Lamp)
    {
      this->Filter->AddLight(this->LampLight);
    }
    vtkNew<vtkCallbackCommand> count;
    count->SetCallback(Count);
    count->SetClientData(&this->Executions);
    this->Filter->AddObserver(vtkCommand::EndEvent, count);
  }

  void MoveLight()
  {
    this->SunLight->SetAzimuth(this->SunLight->GetAzimuth() + 20.0);
    this->SkyLight->SetSunAzimuth(this->SkyLight->GetSunAzimuth() + 20.0);
    const double* place = this->LampLight->GetPosition();
    this->LampLight->SetPosition(place[0] + 100.0, place[1], place[2]);
  }
  void MoveCamera() { this->Camera->Azimuth(10.0); }
  void MoveTerrain() { SetHeights(this->Image, MovingTerrain(this->Size, 1.0)); }

  // A row of the table with the executions of the filter since the last row. milliseconds: the time
  // of the frame.
  std::string Frame(double& milliseconds)
  {
    this->Executions = 0;
    const double start = Now().Wall;
    this->Filter->Update();
    milliseconds = 1000.0 * (Now().Wall - start);
    if (this->Executions == 0)
    {
      return " 0 | 0 | 0 | 0 | 0 |";
    }
    std::ostringstream row;
    row << " " << this->Executions << " | " << this->Filter->GetSearchedAzimuths() << " | "
        << this->Filter->GetEnvironmentPasses() << " | " << this->Filter->GetSunPasses() << " | "
        << this->Filter->GetLampPasses() << " |";
    return row.str();
  }

private:
  std::ptrdiff_t Size;
  vtkSmartPointer<vtkImageData> Image;
  vtkNew<vtkHeightFieldIrradiance> Filter;
  vtkNew<vtkSkylineSunLight> SunLight;
  vtkNew<vtkSkylineEnvironmentLight> SkyLight;
  vtkNew<vtkSkylineLampLight> LampLight;
  vtkNew<vtkCamera> Camera;
  int Executions = 0;
};

struct Row
{
  std::string Counts;
  double Milliseconds;
};

std::vector<Row> MakeRows(bool harmonics, std::ptrdiff_t size)
{
  const struct
  {
    const char* Name;
    int Which;
  } scenes[] = { { "sun", Sun }, { "sky", Sky }, { "lamp", Lamp }, { "all", Sun | Sky | Lamp } };
  std::vector<Row> rows;
  for (const auto& scene : scenes)
  {
    Show show(scene.Which, harmonics, size);
    const auto add = [&](const char* change)
    {
      Row row;
      row.Counts = std::string("| ") + scene.Name + " | " + change + " |";
      row.Counts += show.Frame(row.Milliseconds);
      rows.push_back(row);
    };
    add("first frame");
    add("nothing moves");
    show.MoveCamera();
    add("camera moves");
    show.MoveLight();
    add("light moves");
    show.MoveTerrain();
    add("terrain moves");
  }
  return rows;
}

std::string MakeTables(std::ptrdiff_t size)
{
  std::ostringstream text;
  for (const bool harmonics : { false, true })
  {
    const std::vector<Row> rows = MakeRows(harmonics, size);
    double whole = 0.0; // all lights, without stored results
    for (const Row& row : rows)
    {
      whole = row.Counts.rfind("| all | first frame |", 0) == 0 ? row.Milliseconds : whole;
    }
    text
      << (harmonics ? "\nHarmonics of four bands, the transfer kept:\n\n"
                    : "\nTables, horizons kept (`KeepHorizonsOn`):\n\n")
      << "| lights | frame | filter runs | azimuths searched | sky | sun | lamp | ms | saved, ms |\n"
      << "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const Row& row : rows)
    {
      char times[64];
      std::snprintf(times, sizeof times, " %.1f | %.1f |\n", row.Milliseconds,
        std::max(0.0, whole - row.Milliseconds));
      text << row.Counts << times;
    }
  }
  return text.str();
}

std::string Read(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  const std::string read = text.str();
  if (read.find(Begin) == std::string::npos || read.find(End) == std::string::npos)
  {
    throw std::runtime_error(file + " has no mark where the tables begin");
  }
  return read;
}

void Write(const std::string& file, std::ptrdiff_t size)
{
  const std::string text = Read(file);
  std::ofstream out(file, std::ios::binary);
  out << text.substr(0, text.find(Begin)) << Begin << "\n"
      << MakeTables(size) << "\n"
      << text.substr(text.find(End));
}

int Check(const std::string& file)
{
  const std::string text = Read(file);
  int wrong = 0;
  std::size_t from = text.find(Begin);
  for (const bool harmonics : { false, true })
  {
    for (const Row& row : MakeRows(harmonics, SmallSize))
    {
      const std::size_t found = text.find(row.Counts, from);
      wrong += found == std::string::npos ? 1 : 0;
      if (found == std::string::npos)
      {
        std::cerr << file << " does not contain: " << row.Counts
                  << (harmonics ? " (harmonics)" : " (tables)") << "\n";
        continue;
      }
      from = found;
    }
  }
  if (wrong > 0)
  {
    std::cerr << "the cure: SkylineLeaveOut --write " << file << std::endl;
  }
  return wrong > 0 ? 1 : 0;
}

} // namespace

int main(int argc, char** argv)
{
  const std::string task = argc > 2 ? argv[1] : "";
  const int size = skyline::SizeArgument(argc, argv, 3, 512);
  if ((task != "--write" && task != "--check") || size < SmallSize)
  {
    std::cerr << "usage: SkylineLeaveOut --write|--check FILE [SIZE, 64 or more]" << std::endl;
    return 2;
  }
  try
  {
    if (task == "--check")
    {
      return Check(argv[2]);
    }
    Write(argv[2], size);
  }
  catch (const std::exception& failure)
  {
    std::cerr << "SkylineLeaveOut: " << failure.what() << std::endl;
    return 1;
  }
  return 0;
}
