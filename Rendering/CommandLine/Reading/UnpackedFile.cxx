// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "UnpackedFile.h"
#include "FileKinds.h"
#include "Messages.h"

#include "vtkObject.h"

#ifdef LAMBENT_HAS_ZLIB
#include "vtk_zlib.h"
#endif

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <vector>

namespace lambent::command
{

#ifdef LAMBENT_HAS_ZLIB

namespace
{

using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

constexpr std::uintmax_t FreeSize = std::uintmax_t{ 64 } << 20;
constexpr std::uintmax_t MostRatio = 256;

/// zlib's state. A gzip file has one or more members, each with a header, a length and a checksum.
class Inflater
{
public:
  Inflater()
  {
    if (inflateInit2(&this->State, 15 + 16) != Z_OK) // 16: gzip, not zlib
    {
      throw std::bad_alloc();
    }
  }
  ~Inflater() { inflateEnd(&this->State); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream State = {};
};

class Unpacking
{
public:
  Unpacking(const std::string& from, const std::string& to)
    : In(std::fopen(from.c_str(), "rb"), std::fclose)
    , Out(std::fopen(to.c_str(), "wb"), std::fclose)
    , Most(FreeSize + MostRatio * std::filesystem::file_size(from))
  {
    if (!this->In || !this->Out)
    {
      throw Failure(std::strerror(errno));
    }
  }

  void Run()
  {
    bool isInMember = false;
    bool hasMember = false;
    while (this->Fill())
    {
      if (!isInMember && !this->StartsMember(hasMember))
      {
        break;
      }
      hasMember = true;
      isInMember = this->InflateSome();
    }
    if (isInMember || !hasMember)
    {
      throw Failure("it is incomplete: its compressed data does not end; use a complete copy");
    }
    if (std::fclose(this->Out.release()) != 0)
    {
      this->ThrowFull();
    }
  }

private:
  /// Reads more compressed data if necessary. Returns false at the end of the file.
  bool Fill()
  {
    z_stream& state = this->Inflate.State;
    if (state.avail_in == 0)
    {
      state.next_in = this->Packed.data();
      state.avail_in =
        static_cast<uInt>(std::fread(this->Packed.data(), 1, this->Packed.size(), this->In.get()));
      if (std::ferror(this->In.get()))
      {
        throw Failure("it cannot be read completely");
      }
    }
    return state.avail_in > 0;
  }

  /// Members begin with the byte 31. Like gzip, ignores trailing zeros, which pad tapes, and warns
  /// about other bytes.
  bool StartsMember(bool hasMember)
  {
    const unsigned char first = *this->Inflate.State.next_in;
    if (first == 31)
    {
      inflateReset(&this->Inflate.State);
      return true;
    }
    if (!hasMember)
    {
      throw Failure(
        "its name ends in .gz, but it is not compressed by gzip; rename or compress it");
    }
    if (first != 0)
    {
      vtkGenericWarningMacro(
        "the bytes after its compressed data are not compressed and are ignored");
    }
    return false;
  }

  /// Returns false at the end of a member.
  bool InflateSome()
  {
    z_stream& state = this->Inflate.State;
    int result = Z_OK;
    do
    {
      state.next_out = this->Plain.data();
      state.avail_out = static_cast<uInt>(this->Plain.size());
      result = inflate(&state, Z_NO_FLUSH);
      this->Write(this->Plain.size() - state.avail_out);
    } while (result == Z_OK && state.avail_out == 0);
    if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR)
    {
      throw Failure("its compressed data is corrupt" +
        (state.msg ? std::string(" (") + state.msg + ")" : std::string()) +
        "; use a complete copy");
    }
    return result != Z_STREAM_END;
  }

  void Write(std::size_t size)
  {
    this->Written += size;
    if (this->Written > this->Most)
    {
      throw Failure("it decompresses to more than " + std::to_string(MostRatio) +
        " times its size, which no mesh does; if that is intended, decompress it with gunzip "
        "first");
    }
    if (std::fwrite(this->Plain.data(), 1, size, this->Out.get()) != size)
    {
      this->ThrowFull();
    }
  }

  [[noreturn]] void ThrowFull()
  {
    throw Failure(std::string("it cannot be decompressed: ") + std::strerror(errno) +
      "; free some space, or name another folder in TMPDIR");
  }

  Stream In;
  Stream Out;
  Inflater Inflate;
  std::vector<unsigned char> Packed = std::vector<unsigned char>(1 << 18);
  std::vector<unsigned char> Plain = std::vector<unsigned char>(1 << 20);
  std::uintmax_t Written = 0;
  std::uintmax_t Most;
};

std::string FolderFor(const std::string& path, bool beside)
{
  namespace fs = std::filesystem;
  if (beside)
  {
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? "." : folder.string();
  }
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  if (error)
  {
    throw Failure("it cannot be decompressed: there is no folder for temporary files; name one in "
                  "TMPDIR");
  }
  return folder.string();
}

} // namespace

UnpackedFile::UnpackedFile(const std::string& path, bool beside)
{
  const std::string inner = path.substr(0, path.size() - 3);
  try
  {
    this->File.emplace(FolderFor(path, beside), ExtensionOf(inner));
  }
  catch (const Failure& reason)
  {
    throw Failure(std::string("it cannot be decompressed: ") + reason.what() +
      (beside ? "; it names files beside it, so decompress it with gunzip first" : ""));
  }
  Unpacking(path, this->File->GetPath()).Run();
}

#else

UnpackedFile::UnpackedFile(const std::string&, bool)
{
  throw Failure(
    "this build of lambent was made without VTK::zlib; decompress it with gunzip first");
}

#endif

} // namespace lambent::command
