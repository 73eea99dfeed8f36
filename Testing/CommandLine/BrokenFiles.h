// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief small files of every format for tests to damage, and what the command reads from them
 */
#ifndef BrokenFiles_h
#define BrokenFiles_h

#include <string>
#include <vector>

struct File
{
  std::string name;      ///< what is special about it
  std::string extension; ///< determines the format, as for the command
  std::string bytes;
};

/// Meshes and pictures from VTK's writers, in every format and with every compressor, and those of
/// MakeFilesByHand().
std::vector<File> MakeFiles();

/// Files that VTK's writers cannot produce: with lines, groups, strips, and so on.
std::vector<File> MakeFilesByHand();

/// A file in the working folder. The destructor deletes it.
class Scratch
{
public:
  explicit Scratch(const std::string& extension);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string read() const;
  void write(const std::string& bytes) const;

  const std::string path;
};

/// The result of reading: the size and coordinates of each polygon and strip, or the values of a
/// picture; or the reason for the failure.
struct Content
{
  std::vector<double> values;
  std::string warnings;
  std::string failure;
};

/// Writes the bytes to the file, and reads it as the command does. Also renders a mesh.
Content Read(const Scratch& scratch, const std::string& bytes);

#endif
