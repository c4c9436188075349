// SPDX-License-Identifier: BSD-3-Clause
// The gallery at small sizes: its pictures are not empty, and errors decrease where they must.
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{

/// The exit code with which a program tells ctest that it could not run.
constexpr int Skipped = 77;

/// A white sheet with captions has only a dozen greys, at the edges of the letters.
constexpr std::size_t LeastColors = 300;

/// Percent of the RMS: 10 % above the worst scene at this size, the street of the city.
constexpr double LampBound = 25.0;

class Gallery : public ::testing::Test
{
protected:
  static std::string PathOf(const std::string& figure, const char* ending)
  {
    return std::string(SKYLINE_TEST_OUTPUT).append("/").append(figure).append(ending);
  }
  static std::string KeyOf(
    const std::string& figure, const std::string& setting, const std::string& against)
  {
    return std::string(figure).append("/").append(setting).append("/").append(against);
  }

  /// Returns false after a failure or a skip.
  bool Run(const std::vector<std::string>& figures)
  {
    const std::string folder = SKYLINE_TEST_OUTPUT;
    const std::string text = PathOf(figures.front(), ".txt");
    std::string command = std::string("'") + SKYLINE_GALLERY + "' --quick -o '" + folder + "'";
    for (const std::string& figure : figures)
    {
      std::remove(PathOf(figure, ".png").c_str());
      command.append(" --figure ").append(figure);
    }
    const int status = std::system((command + " > '" + text + "'").c_str());
    if (WIFEXITED(status) && WEXITSTATUS(status) == Skipped)
    {
      this->Missing = true;
      return false;
    }
    EXPECT_EQ(status, 0) << command;
    this->Read(text);
    return status == 0;
  }

  /// Reads the lines "| setting | against | rms | ..." and "| setting | what | value |" below
  /// "name: title".
  void Read(const std::string& path)
  {
    std::ifstream file(path);
    std::string line, figure;
    while (std::getline(file, line))
    {
      if (line.rfind("| ", 0) == 0)
      {
        std::istringstream cells(line.substr(2));
        std::string setting, against, value;
        const auto cell = [&cells](std::string& text)
        {
          std::getline(cells, text, '|');
          const auto first = text.find_first_not_of(' ');
          const auto last = text.find_last_not_of(' ');
          text = first == std::string::npos ? "" : text.substr(first, last - first + 1);
        };
        cell(setting);
        cell(against);
        cell(value);
        this->Values[KeyOf(figure, setting, against)] = std::strtod(value.c_str(), nullptr);
      }
      else if (line.find(": ") != std::string::npos)
      {
        figure = line.substr(0, line.find(':'));
      }
    }
  }

  double Value(const std::string& figure, const std::string& setting, const std::string& against)
  {
    const auto found = this->Values.find(KeyOf(figure, setting, against));
    EXPECT_NE(found, this->Values.end()) << figure << " " << setting << " " << against;
    return found == this->Values.end() ? 0.0 : found->second;
  }

  /// Checks that each value is less than `factor` times the previous one.
  void ExpectFalling(const std::string& figure, const std::vector<std::string>& settings,
    const std::string& against, double factor = 1.0)
  {
    for (std::size_t k = 1; k < settings.size(); ++k)
    {
      EXPECT_LT(this->Value(figure, settings[k], against),
        factor * this->Value(figure, settings[k - 1], against))
        << figure << " " << settings[k];
    }
  }

  static void ExpectPicture(const std::string& figure)
  {
    const std::string path = PathOf(figure, ".png");
    vtkNew<vtkPNGReader> reader;
    ASSERT_TRUE(reader->CanReadFile(path.c_str())) << path;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    ASSERT_EQ(image->GetNumberOfScalarComponents(), 3);
    const auto* code = static_cast<const unsigned char*>(image->GetScalarPointer());
    std::set<int> colors;
    vtkIdType black = 0;
    const vtkIdType pixels = image->GetNumberOfPoints();
    for (vtkIdType k = 0; k < pixels; ++k, code += 3)
    {
      colors.insert((code[0] << 16) | (code[1] << 8) | code[2]);
      black += code[0] + code[1] + code[2] < 30 ? 1 : 0;
    }
    EXPECT_GT(colors.size(), LeastColors) << figure;
    EXPECT_LT(black, pixels / 3) << figure << " is dark";
  }

  std::map<std::string, double> Values;
  bool Missing = false;
};

TEST_F(Gallery, KeyLights)
{
  const std::vector<std::string> figures{ "sn08-3", "sn08-4", "sn08-6", "sn08-9", "sn08-10" };
  if (!this->Run(figures))
  {
    if (this->Missing)
    {
      GTEST_SKIP() << "no OpenGL context";
    }
    return;
  }
  for (const std::string& figure : figures)
  {
    ExpectPicture(figure);
  }
  const std::string exact = "exact horizons", direct = "direct";
  this->ExpectFalling("sn08-3", { "k = 1", "k = 2", "k = 3" }, exact);
  this->ExpectFalling("sn08-4", { "o = 0", "o = 1", "o = 2", "o = 3", "o = 4" }, exact);
  this->ExpectFalling("sn08-10", { "k = o = 1", "k = o = 2", "k = o = 4", "k = o = 8" }, exact);
  const std::string edge = "steepest edge, % of the open light per metre";
  this->ExpectFalling("sn08-6",
    { "swath 11.25 degrees", "swath 22.5 degrees", "swath 45 degrees", "swath 90 degrees" }, edge);
  const std::string crease = "largest crease, % of the open light";
  this->ExpectFalling("sn08-9", { "linear 1D, bilinear 2D", "b-spline 1D and 2D" }, crease);
  for (const std::string figure : { "sn08-3", "sn08-4", "sn08-9", "sn08-10" })
  {
    EXPECT_LT(this->Value(figure, "Skyline's default", direct),
      0.5 * this->Value(figure, "exact horizons", direct))
      << figure;
  }
}

TEST_F(Gallery, Lamps)
{
  const std::vector<std::string> figures{ "thesis-6.1", "thesis-6.2", "thesis-6.3", "thesis-6.4",
    "thesis-6.5" };
  if (!this->Run(figures))
  {
    if (this->Missing)
    {
      GTEST_SKIP() << "no OpenGL context";
    }
    return;
  }
  for (const std::string& figure : figures)
  {
    ExpectPicture(figure);
  }
  this->ExpectFalling("thesis-6.1", { "4 azimuths", "8 azimuths", "16 azimuths", "32 azimuths" },
    "128 azimuths", 0.6);
  this->ExpectFalling("thesis-6.2", { "ls = 1", "ls = 2", "ls = 3" }, "exact horizons");
  int scenes = 0;
  for (const auto& value : this->Values)
  {
    const bool scene =
      value.first.rfind("thesis-6.", 0) == 0 && value.first.find("/(") != std::string::npos;
    scenes += scene ? 1 : 0;
    if (scene)
    {
      EXPECT_LT(value.second, LampBound) << value.first;
      EXPECT_GT(value.second, 0.0) << value.first;
    }
  }
  EXPECT_EQ(scenes, 15);
}

TEST_F(Gallery, Shadows)
{
  const std::vector<std::string> figures{ "shm-8", "tw10-8" };
  if (!this->Run(figures))
  {
    if (this->Missing)
    {
      GTEST_SKIP() << "no OpenGL context";
    }
    return;
  }
  for (const std::string& figure : figures)
  {
    ExpectPicture(figure);
  }
  for (const std::string radius : { "0.5", "5", "20" })
  {
    const std::string name = "radius " + radius + " degrees, ";
    this->ExpectFalling("tw10-8", { name + "16 azimuths", name + "64 azimuths" }, "1024 azimuths");
  }
}

/// The exit code of the program with these arguments. Its output is discarded.
int ExitOf(const std::string& arguments)
{
  std::string command = std::string("'").append(SKYLINE_GALLERY).append("' --quick ");
  const int status = std::system(command.append(arguments).append(" > /dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(Gallery, TellsWhatIsWrong)
{
  EXPECT_NE(ExitOf("-o . --figure none"), 0);
  EXPECT_NE(ExitOf("--figure sn08-6"), 0) << "no folder";
  const int below = ExitOf("-o /dev/null/below --figure sn08-6");
  if (below == Skipped)
  {
    GTEST_SKIP() << "no OpenGL context";
  }
  EXPECT_EQ(below, 1);
  std::filesystem::create_directories("taken/sn08-6.png/x");
  EXPECT_EQ(ExitOf("-o taken --figure sn08-6"), 1) << "a folder in the picture's place";
}

} // namespace
