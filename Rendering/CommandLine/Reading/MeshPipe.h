// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief sends progress, messages and a mesh through a pipe between two processes of a machine
 *
 * A message consists of a tag, a size and that many bytes. A mesh is sent as a message for each
 * array: a header, then the values as they are in memory.
 */

#ifndef MeshPipe_h
#define MeshPipe_h

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <string>

class vtkDataArray;
class vtkPolyData;

namespace lambent::command
{

enum class MessageTag : char
{
  Progress = 'p', ///< a double, 0..1
  Warning = 'w',  ///< its text
  Error = 'e',    ///< its text; the last message
  Array = 'a',    ///< an array of the mesh
  End = 'z'       ///< the mesh is complete; the last message
};

/// The write end of a pipe. Data that cannot be written is dropped, since the reader is gone.
class MeshPipeWriter
{
public:
  explicit MeshPipeWriter(int file)
    : File(file)
  {
  }
  void Send(MessageTag tag, const void* bytes, std::size_t size);
  void Send(MessageTag tag, const std::string& text) { this->Send(tag, text.data(), text.size()); }
  /// Sends points, cells, and numeric point and cell data.
  void Send(vtkPolyData* mesh);

private:
  void Send(int role, const char* name, int attribute, vtkDataArray* array);
  void Write(const void* bytes, std::size_t size);

  int File;
};

/// The read end of a pipe.
class MeshPipeReader
{
public:
  explicit MeshPipeReader(int file);
  ~MeshPipeReader();
  MeshPipeReader(const MeshPipeReader&) = delete;
  MeshPipeReader& operator=(const MeshPipeReader&) = delete;

  /// Reads the tag of the next message. Returns false at the end of the pipe, even if that is
  /// early.
  bool Next(MessageTag& tag);

  /// These read the content of a message; which one to call depends on its tag.
  std::string TakeText();
  double TakeNumber();
  void TakeArray();

  /// Makes the mesh from all arrays. Throws Failure if they do not form one.
  vtkSmartPointer<vtkPolyData> MakeMesh();

private:
  struct Parts;
  bool Read(void* bytes, std::size_t size);

  int File;
  std::uint64_t Size = 0;
  Parts* Taken;
};

} // namespace lambent::command

#endif
