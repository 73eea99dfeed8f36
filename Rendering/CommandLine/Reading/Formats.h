// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the table of file formats that can be read, by extension
 *
 * To add a format, add an entry to the table in Formats.cxx: its extensions, its description and
 * the function that reads it. Every format may also be gzipped: "mesh.ply.gz" is read like
 * "mesh.ply".
 */

#ifndef Formats_h
#define Formats_h

#include "vtkSmartPointer.h"

#include <optional>
#include <string>

class vtkDataObject;

namespace lambent::command
{

class Progress;
class VtkMessages;

/// The formats that code outside of the table must distinguish.
enum class MeshKind
{
  Vtp,
  Vtu,
  LegacyVtk,
  Ply,
  Stl,
  Obj,
  Other
};

/// Reads a file that exists and is not empty; throws Failure.
using ReadFunction = vtkSmartPointer<vtkDataObject> (*)(
  const std::string& path, VtkMessages& messages, Progress& progress);

/// Whether a reader is safe with any bytes.
enum class Trust
{
  Checked, ///< the reader, or a check before it, handles broken files: runs in this process
  Isolated ///< the reader may crash or hang: runs in a child process, see Isolated.h
};

struct Format
{
  MeshKind kind;
  const char* extensions; ///< in lower case, separated by spaces
  const char* description;
  const char* library; ///< the library that reads it: "VTK", "assimp", "Lambent" itself, ...
  ReadFunction read;   ///< null if `library` was missing when the command was built
  Trust trust;
  bool hasParts; ///< the file names others, relative to its folder, or stands for its folder
  bool mayBeEmpty = false; ///< only the file's name and place matter
};

/// The format that belongs to a file's extension, in upper or lower case, gzipped or not; null if
/// it is unknown.
const Format* FindFormat(const std::string& path);

/// The kind of that format; empty if it is unknown.
std::optional<MeshKind> MeshKindOf(const std::string& path);

/// Whether the name ends in ".gz".
bool IsGzipped(const std::string& path);

/// How the file must be read. For legacy VTK files this depends on the type of data in the file.
Trust TrustIn(const Format& format, const std::string& path);

/// Throws Failure, with a list of the readable extensions, if the format is unknown or this build
/// cannot read it.
const Format& RequireFormat(const std::string& path);

/// The extensions that this build reads, as listed in messages: ".vtp .vtk ...".
std::string MeshExtensions();

/// The output of `lambent --formats`.
std::string DescribeFormats();

} // namespace lambent::command

#endif
