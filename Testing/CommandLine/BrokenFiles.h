// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief small files of every kind, to be broken, and what the command reads from them
 */
#ifndef BrokenFiles_h
#define BrokenFiles_h

#include <string>
#include <vector>

struct File
{
  std::string name;      ///< what is special about it
  std::string extension; ///< tells the kind, as to the command
  std::string bytes;
};

/// Meshes and pictures as VTK's writers make them, in every format and with every compressor, and
/// those made by hand.
std::vector<File> MakeFiles();

/// What VTK's writers do not write: lines, groups, strips, and so on.
std::vector<File> MakeFilesByHand();

/// A file in the working folder while it lives.
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

/// What was read: the size and coordinates of each polygon or the values of a picture, after what
/// was drawn of it; or why not.
struct Content
{
  std::vector<double> values;
  std::string warnings;
  std::string failure;
};

/// Writes the bytes to the file and has the command read it.
Content Read(const Scratch& scratch, const std::string& bytes);

#endif
