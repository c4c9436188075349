// SPDX-License-Identifier: BSD-3-Clause
#include "NetcdfHeader.h"

#include <cstdint>
#include <fstream>

namespace skyline
{

namespace
{

constexpr std::uint64_t TagBytes = 4, TypeBytes = 4;

/// Size in bytes of a value of the netCDF types 1 (byte) to 11 (ubyte ... uint64); 1 for other
/// numbers.
std::uint64_t ValueBytes(std::uint64_t type)
{
  constexpr std::uint64_t bytes[] = { 1, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 };
  return type < sizeof(bytes) / sizeof(bytes[0]) ? bytes[type] : 1;
}

/// Reads through the header. Fits becomes false at the first count that is too large.
class Walk
{
public:
  explicit Walk(const std::string& path)
    : File(path, std::ios::binary)
  {
    char magic[4] = {};
    this->File.read(magic, sizeof(magic));
    this->Version =
      this->File && magic[0] == 'C' && magic[1] == 'D' && magic[2] == 'F' ? magic[3] : 0;
    if (this->Version == 1 || this->Version == 2 || this->Version == 5)
    {
      this->CountBytes = this->Version == 5 ? 8 : 4;
      this->PlaceBytes = this->Version == 1 ? 4 : 8;
      this->File.seekg(0, std::ios::end);
      this->Left = static_cast<std::uint64_t>(this->File.tellg()) - sizeof(magic);
      this->File.seekg(sizeof(magic));
      this->Skip(this->CountBytes); // the number of records
      this->Dimensions();
      this->Attributes();
      this->Variables();
    }
  }

  bool Fits() const { return this->Good; }

private:
  std::uint64_t Number(std::uint64_t bytes)
  {
    std::uint64_t number = 0;
    for (std::uint64_t i = 0; i < bytes && this->Good; ++i)
    {
      number =
        number << 8U | static_cast<std::uint64_t>(static_cast<unsigned char>(this->File.get()));
    }
    this->Take(bytes);
    return number;
  }

  void Take(std::uint64_t bytes)
  {
    this->Good = this->Good && bytes <= this->Left;
    this->Left -= this->Good ? bytes : 0;
  }

  void Skip(std::uint64_t bytes)
  {
    this->Take(bytes);
    if (this->Good)
    {
      this->File.seekg(static_cast<std::streamoff>(bytes), std::ios::cur);
    }
  }

  /// Reads the number of elements that take at least `least` bytes each.
  std::uint64_t Count(std::uint64_t least)
  {
    const std::uint64_t count = this->Number(this->CountBytes);
    this->Good = this->Good && count <= this->Left / least;
    return this->Good ? count : 0;
  }

  /// Skips `count` values and the padding to whole words.
  void Values(std::uint64_t count, std::uint64_t bytes)
  {
    const std::uint64_t all = count * bytes;
    this->Skip(all + (4 - all % 4) % 4);
  }

  void Name() { this->Values(this->Count(1), 1); }

  void Dimensions()
  {
    this->Skip(TagBytes);
    for (std::uint64_t i = this->Count(2 * this->CountBytes); i > 0 && this->Good; --i)
    {
      this->Name();
      this->Skip(this->CountBytes); // the length of the dimension
    }
  }

  void Attributes()
  {
    this->Skip(TagBytes);
    for (std::uint64_t i = this->Count(2 * this->CountBytes + TypeBytes); i > 0 && this->Good; --i)
    {
      this->Name();
      const std::uint64_t bytes = ValueBytes(this->Number(TypeBytes));
      this->Values(this->Count(bytes), bytes);
    }
  }

  void Variables()
  {
    this->Skip(TagBytes);
    const std::uint64_t least = 4 * this->CountBytes + TagBytes + TypeBytes + this->PlaceBytes;
    for (std::uint64_t i = this->Count(least); i > 0 && this->Good; --i)
    {
      this->Name();
      this->Values(this->Count(this->CountBytes), this->CountBytes); // numbers of its dimensions
      this->Attributes();
      this->Skip(TypeBytes + this->CountBytes + this->PlaceBytes);
    }
  }

  std::ifstream File;
  int Version = 0;
  std::uint64_t CountBytes = 0, PlaceBytes = 0, Left = 0;
  bool Good = true;
};

} // namespace

bool NetcdfHeaderFits(const std::string& path)
{
  return Walk(path).Fits();
}

} // namespace skyline
