// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the table of the kinds of files that can be read, by the end of their names
 *
 * A new kind is one entry in the table in Formats.cxx: its extensions, what it
 * is called, and the function that reads it. Every kind may also be gzipped:
 * "mesh.ply.gz" is of the kind of "mesh.ply".
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

/// The kinds that code outside of the table has to tell apart.
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

/// Whether a reader can be trusted with any bytes.
enum class Trust
{
  Checked, ///< it, or a check before it, withstands broken files: it runs in this process
  Isolated ///< it may crash or hang: it runs in a child process, see Isolated.h
};

struct Format
{
  MeshKind kind;
  const char* extensions; ///< in lower case, with spaces between them
  const char* description;
  const char* library; ///< what reads it: "VTK", "assimp", or "Lambent" itself
  ReadFunction read;   ///< null if `library` was missing when the command was built
  Trust trust;
  bool hasParts; ///< it names further files, relative to its own folder, or stands for that
  bool mayBeEmpty = false; ///< only its name and place matter
};

/// The format that the name of a file tells, in upper or lower case, gzipped or not; null if it is
/// not known.
const Format* FindFormat(const std::string& path);

/// The kind of that format; nothing if it is not known.
std::optional<MeshKind> MeshKindOf(const std::string& path);

/// Whether the name ends in ".gz".
bool IsGzipped(const std::string& path);

/// How the file has to be read: a legacy file holds meshes as well as images.
Trust TrustIn(const Format& format, const std::string& path);

/// Throws Failure, saying what can be read, if the name tells no format or one that this build
/// cannot read.
const Format& RequireFormat(const std::string& path);

/// The extensions that this build reads, as a message lists them: ".vtp .vtk ...".
std::string MeshExtensions();

/// What `lambent --formats` prints.
std::string DescribeFormats();

} // namespace lambent::command

#endif
