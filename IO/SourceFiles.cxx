// SPDX-License-Identifier: BSD-3-Clause
#include "SourceFiles.h"

#include "AtomicFile.h"
#include "GdalErrors.h"
#include "IoFailure.h"

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <cpl_minixml.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <utility>

#include <sys/stat.h>

namespace skyline
{

namespace
{

/// Characters that enclose a file name in GDAL's longer names, for instance in NETCDF:"f.nc":v,
/// vrt://f.tif?bands=1, /vsizip/{f.zip}/g.tif, /vsisubfile/100_200,f.tif.
constexpr const char* Marks = ":\"'?&=,|{}";

/// A longer text is not a file name.
constexpr std::size_t LongestName = 4096;

/// The greatest number of these characters and slashes in a file name.
constexpr std::size_t MostMarks = 64;

/// Files that may lie beside a raster: with this text after the whole name, or in place of the
/// extension.
constexpr std::array<const char*, 4> Behind{ { ".aux.xml", ".ovr", ".msk", ".hdr" } };
constexpr std::array<const char*, 10> Instead{ { ".hdr", ".prj", ".aux", ".rrd", ".ige", ".rde",
  ".tfw", ".wld", ".clr", ".stx" } };

/// How a virtual raster begins, and the number of bytes in which this text must stand.
constexpr std::size_t HeadBytes = 1024;
constexpr std::array<const char*, 2> VirtualRasters{ { "<VRTDataset", "<GDALTileIndexDataset" } };

using Identity = std::pair<dev_t, ino_t>;

/// Searches the files of inputs for the files that an output would replace.
class Search
{
public:
  explicit Search(const std::string& output)
  {
    struct stat status;
    for (const std::string& file : AtomicFile::FilesToBeReplaced(output))
    {
      if (::stat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode))
      {
        this->FilesToBeReplaced.insert({ status.st_dev, status.st_ino });
      }
    }
  }

  bool IsNeeded() const { return !this->FilesToBeReplaced.empty(); }

  /// True if the input named `name` contains one of those files.
  bool Finds(const std::string& name)
  {
    const std::size_t begin = name.find_first_not_of(" \t\r\n");
    if (begin != std::string::npos && name[begin] == '<')
    {
      const XmlTree tree(CPLParseXMLString(name.c_str()), CPLDestroyXMLNode);
      return this->FindsInTree(tree.get(), ".");
    }
    return this->FindsInName(name, ".");
  }

private:
  using XmlTree = std::unique_ptr<CPLXMLNode, decltype(&CPLDestroyXMLNode)>;

  /// Tries each part of a name between marks and before each slash, because GDAL may treat a file
  /// as a folder.
  bool FindsInName(const std::string& name, const std::string& folder)
  {
    if (name.empty() || name.size() > LongestName)
    {
      return false;
    }
    if (name.rfind("/vsistdin/", 0) == 0 && this->FindsAt("/dev/stdin", folder))
    {
      return true; // standard input
    }
    std::vector<std::size_t> begins{ 0 }, ends{ name.size() };
    for (std::size_t i = 0; i < name.size(); ++i)
    {
      const bool mark = std::strchr(Marks, name[i]) != nullptr;
      if (mark)
      {
        begins.push_back(i + 1);
      }
      if (mark || name[i] == '/')
      {
        ends.push_back(i);
      }
      if (name.compare(i, 4, "/vsi") == 0)
      {
        const std::size_t slash = name.find('/', i + 1);
        begins.push_back(slash == std::string::npos ? name.size() : slash + 1);
      }
    }
    if (begins.size() > MostMarks || ends.size() > MostMarks)
    {
      begins.resize(1); // a text such as XML, not a file name
      ends.resize(1);
    }
    for (const std::size_t begin : begins)
    {
      for (const std::size_t end : ends)
      {
        if (end > begin && this->FindsAt(name.substr(begin, end - begin), folder))
        {
          return true;
        }
      }
    }
    return false;
  }

  bool FindsAt(const std::string& path, const std::string& folder)
  {
    return this->IsOrHolds(path) ||
      (path[0] != '/' && folder != "." && this->IsOrHolds(folder + "/" + path));
  }

  bool Is(const std::string& path, Identity& identity) const
  {
    struct stat status;
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
    {
      return false;
    }
    identity = { status.st_dev, status.st_ino };
    return true;
  }

  bool IsToBeReplaced(const std::string& path) const
  {
    Identity identity;
    return this->Is(path, identity) && this->FilesToBeReplaced.count(identity) > 0;
  }

  bool IsOrHolds(const std::string& path)
  {
    Identity identity;
    if (!this->Is(path, identity) || !this->Seen.insert(identity).second)
    {
      return false;
    }
    if (this->FilesToBeReplaced.count(identity) > 0)
    {
      return true;
    }
    const std::size_t dot = path.find_last_of("./");
    const bool extended = dot != std::string::npos && path[dot] == '.';
    const std::string stem = extended ? path.substr(0, dot) : path;
    const auto beside = [this](const std::string& begin)
    { return [this, begin](const char* end) { return this->IsToBeReplaced(begin + end); }; };
    return std::any_of(Behind.begin(), Behind.end(), beside(path)) ||
      std::any_of(Instead.begin(), Instead.end(), beside(stem)) || this->FindsInFile(path);
  }

  bool FindsInFile(const std::string& path)
  {
    std::string head(HeadBytes, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    const bool isVirtual = std::any_of(VirtualRasters.begin(), VirtualRasters.end(),
      [&](const char* begin) { return head.find(begin) != std::string::npos; });
    if (!isVirtual)
    {
      return false;
    }
    const XmlTree tree(CPLParseXMLFile(path.c_str()), CPLDestroyXMLNode);
    const std::size_t slash = path.rfind('/');
    return this->FindsInTree(tree.get(), slash == std::string::npos ? "." : path.substr(0, slash));
  }

  /// Each text in the tree may be a file name.
  bool FindsInTree(const CPLXMLNode* node, const std::string& folder)
  {
    for (; node; node = node->psNext)
    {
      if ((node->eType == CXT_Text && this->FindsInName(node->pszValue, folder)) ||
        this->FindsInTree(node->psChild, folder))
      {
        return true;
      }
    }
    return false;
  }

  std::set<Identity> FilesToBeReplaced, Seen;
};

} // namespace

void StoreSourceFiles(const std::vector<std::string>& names, vtkDataObject* data)
{
  vtkNew<vtkStringArray> array;
  array->SetName(SourceFilesArrayName);
  for (const std::string& name : names)
  {
    std::error_code none;
    const bool file = std::filesystem::exists(name, none);
    array->InsertNextValue(file ? std::filesystem::absolute(name).string() : name);
  }
  data->GetFieldData()->AddArray(array);
}

std::vector<std::string> LoadSourceFiles(vtkDataObject* data)
{
  std::vector<std::string> names;
  vtkFieldData* fields = data ? data->GetFieldData() : nullptr;
  auto* array =
    vtkStringArray::SafeDownCast(fields ? fields->GetAbstractArray(SourceFilesArrayName) : nullptr);
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    names.push_back(array->GetValue(i));
  }
  return names;
}

void RefuseOverlap(const std::string& output, const std::vector<std::string>& inputs)
{
  Search search(output);
  if (!search.IsNeeded())
  {
    return;
  }
  const GdalErrors quiet;
  for (const std::string& input : inputs)
  {
    if (search.Finds(input))
    {
      throw IoFailure(vtkErrorCode::CannotOpenFileError,
        "cannot write '" + output + "': it is part of the input '" + input.substr(0, 200) +
          "'; choose another name");
    }
  }
}

} // namespace skyline
