// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckNetCdf.h"
#include "Messages.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace lambent::command
{
namespace
{

constexpr std::uint64_t Dimensions = 10;
constexpr std::uint64_t Variables = 11;
constexpr std::uint64_t Attributes = 12;

[[noreturn]] void FailCut()
{
  throw Failure(
    "it is incomplete or corrupt: it is shorter than its header declares; use a complete copy");
}

/// Walks through the header of a classic file, whose numbers are big-endian.
class NetCdfHeader
{
public:
  explicit NetCdfHeader(const std::string& path)
    : File(path, std::ios::binary)
    , FileSize(std::filesystem::file_size(path))
  {
  }

  void Check()
  {
    char magic[4] = {};
    this->File.read(magic, sizeof(magic));
    this->Version = magic[3];
    if (std::string(magic, 3) != "CDF" ||
      (this->Version != 1 && this->Version != 2 && this->Version != 5))
    {
      return; // HDF5, or not a NetCDF file, which the reader reports
    }
    const std::uint64_t records = this->TakeCount();
    this->TakeDimensions();
    this->SkipAttributes();
    const std::uint64_t recordSize = this->TakeVariables();
    const bool isUnknown = records >= (this->Version == 5 ? UINT64_MAX : UINT32_MAX); // streaming
    if (records > 0 && !isUnknown && !this->Records.empty())
    {
      this->Need(static_cast<double>(recordSize) * static_cast<double>(records - 1));
      for (const auto& [begin, size] : this->Records)
      {
        this->Need(static_cast<double>(begin) +
          static_cast<double>(recordSize) * static_cast<double>(records - 1) +
          static_cast<double>(size));
      }
    }
  }

private:
  void Need(double size) const
  {
    if (size > static_cast<double>(this->FileSize))
    {
      FailCut();
    }
  }

  std::uint64_t Take(int bytes)
  {
    std::uint64_t number = 0;
    for (int k = 0; k < bytes; ++k)
    {
      const int byte = this->File.get();
      if (byte < 0)
      {
        FailCut();
      }
      number = 256 * number + static_cast<std::uint64_t>(byte);
    }
    return number;
  }

  std::uint64_t TakeCount() { return this->Take(this->Version == 5 ? 8 : 4); }

  /// A list starts with a tag and a count; both are zero for an absent list.
  std::uint64_t TakeList(std::uint64_t tag)
  {
    const std::uint64_t found = this->Take(4);
    const std::uint64_t count = this->TakeCount();
    if ((found != tag && (found != 0 || count != 0)) || count > this->FileSize)
    {
      FailCut();
    }
    return count;
  }

  void SkipPadded(std::uint64_t size)
  {
    this->Need(static_cast<double>(size));
    this->File.seekg(static_cast<std::streamoff>((size + 3) / 4 * 4), std::ios::cur);
  }

  void SkipName() { this->SkipPadded(this->TakeCount()); }

  std::uint64_t TakeTypeSize()
  {
    constexpr std::uint64_t sizes[] = { 0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 };
    const std::uint64_t type = this->Take(4);
    if (type == 0 || type >= std::size(sizes))
    {
      FailCut();
    }
    return sizes[type];
  }

  void TakeDimensions()
  {
    const std::uint64_t count = this->TakeList(Dimensions);
    for (std::uint64_t k = 0; k < count; ++k)
    {
      this->SkipName();
      this->Lengths.push_back(this->TakeCount());
    }
  }

  void SkipAttributes()
  {
    const std::uint64_t count = this->TakeList(Attributes);
    for (std::uint64_t k = 0; k < count; ++k)
    {
      this->SkipName();
      const std::uint64_t size = this->TakeTypeSize();
      const std::uint64_t values = this->TakeCount();
      this->Need(static_cast<double>(values));
      this->SkipPadded(size * values);
    }
  }

  /// Checks the variables outside of records and returns the size of a record.
  std::uint64_t TakeVariables()
  {
    const std::uint64_t count = this->TakeList(Variables);
    std::uint64_t recordSize = 0;
    for (std::uint64_t k = 0; k < count; ++k)
    {
      this->SkipName();
      const std::uint64_t rank = this->TakeCount();
      this->Need(static_cast<double>(rank));
      bool isRecord = false;
      double size = 1;
      for (std::uint64_t axis = 0; axis < rank; ++axis)
      {
        const std::uint64_t dimension = this->TakeCount();
        if (dimension >= this->Lengths.size())
        {
          FailCut();
        }
        const std::uint64_t length = this->Lengths[dimension];
        isRecord |= axis == 0 && length == 0; // the dimension of unlimited length
        size *= axis == 0 && length == 0 ? 1.0 : static_cast<double>(length);
      }
      this->SkipAttributes();
      size *= static_cast<double>(this->TakeTypeSize());
      this->TakeCount(); // the stored size, which is wrong for large variables
      const std::uint64_t begin = this->Take(this->Version == 1 ? 4 : 8);
      if (!isRecord)
      {
        this->Need(size > 0 ? static_cast<double>(begin) + size : 0);
        continue;
      }
      this->Need(size);
      this->Records.push_back({ begin, static_cast<std::uint64_t>(size) });
      recordSize += (static_cast<std::uint64_t>(size) + 3) / 4 * 4;
    }
    // A single record variable is not padded to four bytes.
    return this->Records.size() == 1 ? this->Records.front().size : recordSize;
  }

  struct Record
  {
    std::uint64_t begin;
    std::uint64_t size;
  };

  std::ifstream File;
  std::uint64_t FileSize;
  int Version = 0;
  std::vector<std::uint64_t> Lengths;
  std::vector<Record> Records; ///< variables with values for each time step
};

} // namespace

void CheckNetCdf(const std::string& path)
{
  NetCdfHeader(path).Check();
}

} // namespace lambent::command
