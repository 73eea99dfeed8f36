// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief progress, messages and a mesh through a pipe between two processes of one machine
 *
 * A message is a tag, a size, and so many bytes. A mesh is one message an array:
 * a header, then the values as they lie in memory.
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
  Array = 'a',    ///< of the mesh
  End = 'z'       ///< the mesh is complete; the last message
};

/// The writing end of a pipe. What cannot be written is dropped: nobody listens any more.
class MeshPipeWriter
{
public:
  explicit MeshPipeWriter(int file)
    : File(file)
  {
  }
  void Send(MessageTag tag, const void* bytes, std::size_t size);
  void Send(MessageTag tag, const std::string& text) { this->Send(tag, text.data(), text.size()); }
  /// Sends points, cells, and the point and cell data that consist of numbers.
  void Send(vtkPolyData* mesh);

private:
  void Send(int role, const char* name, int attribute, vtkDataArray* array);
  void Write(const void* bytes, std::size_t size);

  int File;
};

/// The reading end of a pipe.
class MeshPipeReader
{
public:
  explicit MeshPipeReader(int file);
  ~MeshPipeReader();
  MeshPipeReader(const MeshPipeReader&) = delete;
  MeshPipeReader& operator=(const MeshPipeReader&) = delete;

  /// The tag of the next message; false at the end of the pipe, also where it ends too early.
  bool Next(MessageTag& tag);

  /// The content of a message; of arrays TakeArray() instead.
  std::string TakeText();
  double TakeNumber();
  void TakeArray();

  /// The mesh of all arrays; throws Failure if they do not make one.
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
