// SPDX-License-Identifier: BSD-3-Clause
#include "TiffBlockTable.h"

#include <algorithm>
#include <array>

namespace skyline
{

namespace
{

constexpr std::uint64_t LittleEndian = 0x4949; // "II"
constexpr std::uint64_t ClassicTiff = 42;
constexpr std::uint64_t BigTiff = 43;

constexpr std::uint64_t StripOffsets = 273;
constexpr std::uint64_t StripByteCounts = 279;
constexpr std::uint64_t TileOffsets = 324;
constexpr std::uint64_t TileByteCounts = 325;

/// Size in bytes of a number of the TIFF types that may hold offsets (SHORT, LONG, LONG8); 0 for
/// other types.
int BytesOf(std::uint64_t type)
{
  return type == 3 ? 2 : type == 4 ? 4 : type == 16 ? 8 : 0;
}

} // namespace

TiffBlockTable::TiffBlockTable(const std::string& path)
  : File(path, "r+")
{
  const std::uint64_t version = this->ReadNumber(2, 2);
  const bool big = version == BigTiff;
  if (this->ReadNumber(0, 2) != LittleEndian || (!big && version != ClassicTiff))
  {
    return;
  }
  const auto directory = static_cast<std::int64_t>(big ? ReadNumber(8, 8) : ReadNumber(4, 4));
  const std::uint64_t entries = this->ReadNumber(directory, big ? 8 : 2);
  const std::int64_t first = directory + (big ? 8 : 2);
  for (std::uint64_t i = 0; i < std::min<std::uint64_t>(entries, 65535); ++i)
  {
    this->ReadEntry(first + static_cast<std::int64_t>(i) * (big ? 20 : 12), big);
  }
}

void TiffBlockTable::ReadEntry(std::int64_t place, bool big)
{
  const std::uint64_t tag = this->ReadNumber(place, 2);
  const bool offsets = tag == StripOffsets || tag == TileOffsets;
  if (!offsets && tag != StripByteCounts && tag != TileByteCounts)
  {
    return;
  }
  const int word = big ? 8 : 4;
  const std::uint64_t count = this->ReadNumber(place + 4, word);
  const std::int64_t value = place + 4 + word;
  Table& table = offsets ? this->Offsets : this->Counts;
  table.Bytes = BytesOf(this->ReadNumber(place + 2, 2));
  const bool inside = count * static_cast<std::uint64_t>(table.Bytes) <=
    static_cast<std::uint64_t>(word); // a short table stands in the entry itself
  table.Place = inside ? value : static_cast<std::int64_t>(this->ReadNumber(value, word));
  const bool fits = table.Bytes > 0 && table.Place > 0 &&
    count * static_cast<std::uint64_t>(table.Bytes) <=
      static_cast<std::uint64_t>(this->File.GetSize() - table.Place);
  table.Numbers.assign(fits ? static_cast<std::size_t>(count) : 0, 0);
}

std::uint64_t TiffBlockTable::ReadNumber(std::int64_t place, int bytes)
{
  std::array<unsigned char, 8> raw{};
  this->File.Read(raw.data(), static_cast<std::size_t>(bytes), place);
  std::uint64_t number = 0;
  for (int i = bytes; i-- > 0;)
  {
    number = number << 8 | raw[static_cast<std::size_t>(i)];
  }
  return number;
}

bool TiffBlockTable::Has(std::size_t blocks) const
{
  return this->File.GetError() == 0 && this->Offsets.Numbers.size() == blocks &&
    this->Counts.Numbers.size() == blocks;
}

void TiffBlockTable::Append(std::size_t block, const void* bytes, std::size_t size)
{
  const std::int64_t place = this->File.GetSize();
  this->File.Write(bytes, size, place);
  this->Offsets.Numbers[block] = static_cast<std::uint64_t>(place);
  this->Counts.Numbers[block] = size;
}

bool TiffBlockTable::SaveTable(const Table& table)
{
  std::vector<unsigned char> bytes;
  bytes.reserve(table.Numbers.size() * static_cast<std::size_t>(table.Bytes));
  for (std::uint64_t number : table.Numbers)
  {
    for (int i = 0; i < table.Bytes; ++i)
    {
      bytes.push_back(static_cast<unsigned char>(number & 255));
      number >>= 8;
    }
    if (number != 0)
    {
      return false;
    }
  }
  this->File.Write(bytes.data(), bytes.size(), table.Place);
  return true;
}

bool TiffBlockTable::Save()
{
  const bool saved = this->SaveTable(this->Offsets) && this->SaveTable(this->Counts);
  this->File.Close();
  return saved;
}

} // namespace skyline
