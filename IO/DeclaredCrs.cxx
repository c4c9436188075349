// SPDX-License-Identifier: BSD-3-Clause
#include "DeclaredCrs.h"

#include <cpl_conv.h>
#include <cpl_minixml.h>
#include <cpl_string.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

namespace skyline
{

namespace
{

/// Larger side files cannot be the text of a CRS.
constexpr vsi_l_offset MostBytes = 16u << 20;

std::string ReadText(const std::string& file)
{
  std::string text;
  VSIStatBufL status;
  VSILFILE* stream = nullptr;
  if (VSIStatL(file.c_str(), &status) == 0 && !VSI_ISDIR(status.st_mode) &&
    static_cast<vsi_l_offset>(status.st_size) <= MostBytes &&
    (stream = VSIFOpenL(file.c_str(), "rb")) != nullptr)
  {
    text.resize(static_cast<std::size_t>(status.st_size));
    text.resize(VSIFReadL(text.data(), 1, text.size(), stream));
    VSIFCloseL(stream);
  }
  return text;
}

bool IsBlank(const std::string& text)
{
  return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

/// True if a .vrt or .aux.xml has an <SRS> element of its own. Those of its sources do not count.
bool XmlDeclaresCrs(const std::string& text)
{
  const std::unique_ptr<CPLXMLNode, decltype(&CPLDestroyXMLNode)> tree(
    CPLParseXMLString(text.c_str()), &CPLDestroyXMLNode);
  for (const char* root : { "=VRTDataset", "=PAMDataset" })
  {
    CPLXMLNode* node = CPLGetXMLNode(tree.get(), root);
    if (node && !IsBlank(CPLGetXMLValue(node, "SRS", "")))
    {
      return true;
    }
  }
  return false;
}

/// Finds out whether the first directory of a TIFF has GeoKeys that give the type of a CRS.
class GeoKeys
{
public:
  static bool Exist(const std::string& file)
  {
    VSILFILE* stream = VSIFOpenL(file.c_str(), "rb");
    if (!stream)
    {
      return false;
    }
    const bool found = GeoKeys(stream).Find();
    VSIFCloseL(stream);
    return found;
  }

private:
  explicit GeoKeys(VSILFILE* stream)
    : Stream(stream)
  {
  }

  std::uint64_t Number(std::uint64_t offset, int bytes)
  {
    std::array<unsigned char, 8> raw{};
    VSIFSeekL(this->Stream, offset, SEEK_SET);
    VSIFReadL(raw.data(), 1, static_cast<std::size_t>(bytes), this->Stream);
    std::uint64_t number = 0;
    for (int i = 0; i < bytes; ++i)
    {
      number = number << 8 | raw[static_cast<std::size_t>(this->Little ? bytes - 1 - i : i)];
    }
    return number;
  }

  bool Find()
  {
    constexpr std::uint64_t geoKeyDirectory = 34735, modelType = 1024;
    std::array<char, 2> order{};
    if (VSIFReadL(order.data(), 1, 2, this->Stream) != 2 || order[0] != order[1] ||
      (order[0] != 'I' && order[0] != 'M'))
    {
      return false;
    }
    this->Little = order[0] == 'I';
    const bool big = this->Number(2, 2) == 43;
    const std::uint64_t directory = big ? this->Number(8, 8) : this->Number(4, 4);
    const int countBytes = big ? 8 : 2, entryBytes = big ? 20 : 12;
    const std::uint64_t entries =
      std::min<std::uint64_t>(this->Number(directory, countBytes), 65535);
    for (std::uint64_t i = 0; i < entries; ++i)
    {
      const std::uint64_t entry = directory + countBytes + i * entryBytes;
      if (this->Number(entry, 2) != geoKeyDirectory)
      {
        continue;
      }
      const std::uint64_t keys = big ? this->Number(entry + 12, 8) : this->Number(entry + 8, 4);
      const std::uint64_t count = this->Number(keys + 6, 2);
      for (std::uint64_t key = 1; key <= count; ++key)
      {
        if (this->Number(keys + 8 * key, 2) == modelType)
        {
          return this->Number(keys + 8 * key + 6, 2) != 0;
        }
      }
      return count > 0;
    }
    return false;
  }

  VSILFILE* Stream;
  bool Little = true;
};

} // namespace

UnreadCrs FindUnreadCrs(GDALDataset& dataset)
{
  UnreadCrs unread;
  const std::string name = dataset.GetDescription();
  if (!name.empty() && name[0] == '<')
  {
    unread.Part = XmlDeclaresCrs(name) ? "its SRS" : "";
    return unread;
  }
  const CPLStringList files(dataset.GetFileList());
  for (int i = 0; i < files.Count() && unread.Part.empty(); ++i)
  {
    const std::string file = files[i];
    const std::string extension = CPLGetExtension(file.c_str());
    const bool declares = EQUAL(extension.c_str(), "prj") ? !IsBlank(ReadText(file))
      : EQUAL(extension.c_str(), "vrt") || EQUAL(extension.c_str(), "xml")
      ? XmlDeclaresCrs(ReadText(file))
      : i == 0 && GeoKeys::Exist(file);
    if (declares)
    {
      unread.Part = "'" + file + "'";
    }
  }
  for (const char* extension : { "prj", "PRJ" })
  {
    const std::string beside = CPLResetExtension(name.c_str(), extension);
    if (unread.Part.empty() && unread.Beside.empty() && beside != name &&
      !IsBlank(ReadText(beside)))
    {
      unread.Beside = beside;
    }
  }
  return unread;
}

} // namespace skyline
